// Reduces pictures with very many pixels: searching a picture takes several times the memory of its pixels.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// Larger pictures are reduced. 4096 x 4096: a mask or the colours of so many pixels stay within 512 MiB.
inline constexpr double kMostWorkedPixels = 4096. * 4096.;

/// `decoded` with 8 bits and at most `most_pixels`. `decoded` has 1, 3 (BGR) or 4 (straight BGRA) channels of 8 or 16
/// bits, as from decode_image. Both sides are divided by the same multiple of 1/8 and rounded to whole px; a new pixel
/// is the mean of its area, weighted by alpha. A small picture keeps its pixels. Memory of finished rows is given back,
/// so `decoded` must not be used afterwards.
cv::Mat reduced_picture(const cv::Mat& decoded, double most_pixels);

}  // namespace tessera
