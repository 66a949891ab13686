// Pictures of very many pixels, worked on as smaller copies: what is found in a picture takes several times its pixels.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// Pictures of more pixels are reduced. 4096 x 4096: what a mask or the colours of so many take stays within 512 MiB.
inline constexpr double kMostWorkedPixels = 4096. * 4096.;

/// `decoded`: as from decode_image, 1, 3 (BGR) or 4 channels (straight BGRA) of 8 or 16 bits. The same with 8 bits, and
/// each side divided by the same multiple of 1/8, rounded to whole px, so that `most_pixels` hold it; means of areas,
/// weighted by alpha. One that is small enough keeps its pixels. Rows that were worked on leave memory, unless it stays
/// as it is: nothing else may look at `decoded` afterwards.
cv::Mat reduced_picture(const cv::Mat& decoded, double most_pixels);

}  // namespace tessera
