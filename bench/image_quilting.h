// Image quilting, the baseline for textures: a texture of square blocks of the photo, which overlap and are cut along the
// line where they differ least. Source: A. A. Efros and W. T. Freeman, "Image quilting for texture synthesis and
// transfer", SIGGRAPH 2001, section 2.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace tessera::bench {

struct QuiltingSettings {
  int block_px = 0;        // side of a block, kLeastBlock_px or more
  std::uint64_t seed = 1;  // the same seed gives the same picture
};

/// The smallest block: it overlaps its neighbours by one px.
inline constexpr int kLeastBlock_px = 6;

/// A picture of `size` px made from blocks of the photo. Each of its pixels is one of the photo's. A block that continues its
/// neighbours as in the photo has no error, so the picture copies large parts of the photo. `photo`: CV_8UC3. Throws
/// std::invalid_argument where a block is too small, or larger than the photo.
cv::Mat quilted(const cv::Mat& photo, cv::Size size, const QuiltingSettings& settings);

/// The path from the first to the last row with the least sum of errors: its column in each row. It moves by one column at
/// most from row to row. `errors`: CV_32F, not empty.
std::vector<int> least_error_path(const cv::Mat& errors);

}  // namespace tessera::bench
