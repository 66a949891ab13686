// Makes a picture of ground only, from the patches of ground that a photograph shows: image quilting (Efros and Freeman,
// SIGGRAPH 2001) on a torus.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// The side of the smallest patches, and how many of them without overlap the ground must hold.
inline constexpr int kLeastPatch_px = 6;
inline constexpr int kLeastPlaces = 12;

/// The picture, CV_8UC3, `side_px` px wide and high. Its left edge continues at the right one, its upper edge at the lower
/// one. `photo`: CV_8UC3 or CV_8UC4, BGR first. `ground`: CV_8U of its size, 255 where the photo may be copied, otherwise
/// 0. Slow changes of brightness and colour over the photo, caused by its light, are evened out. Empty where the ground is
/// too small even for the smallest patches. The same photo gives the same picture. The time grows with the area and stays
/// below some seconds for 1024 px.
cv::Mat synthesised_ground(const cv::Mat& photo, const cv::Mat& ground, int side_px);

/// The side of the patches for this ground, px; 0: the ground is too small.
int patch_side_px(const cv::Mat& ground);

}  // namespace tessera
