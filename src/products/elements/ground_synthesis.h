// A picture of ground alone, made from the patches of it that a photograph shows: image quilting (Efros and Freeman,
// SIGGRAPH 2001) on a torus.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// The smallest patches, and how many of them that do not overlap the ground must have.
inline constexpr int kLeastPatch_px = 6;
inline constexpr int kLeastPlaces = 12;

/// CV_8UC3, `side_px` px wide and high, whose left edge goes on at the right one and whose upper edge at the lower one.
/// `photo`: CV_8UC3 or CV_8UC4, BGR first; `ground`: CV_8U of its size, 255 where the photo may be copied from, else 0.
/// The brightness and colour of the whole ground, which change across a photo with its light, are evened out. Empty where
/// the ground has not enough places for even the smallest patch. The same photo gives the same picture; the time grows
/// with the area and stays below some seconds for 1024 px.
cv::Mat synthesised_ground(const cv::Mat& photo, const cv::Mat& ground, int side_px);

/// The side of the patches that this ground is made of, px; 0: it has not enough of them.
int patch_side_px(const cv::Mat& ground);

}  // namespace tessera
