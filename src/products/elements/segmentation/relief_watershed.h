// Watersheds of a relief, and merging of shallow basins. (cv::watershed floods by differences of colour instead.)
#pragma once

#include <functional>
#include <opencv2/core.hpp>

namespace tessera {

/// `relief`: CV_32F. `mask`: CV_8U, the pixels that may be flooded; empty: all. Each minimum of the relief floods its own
/// basin. Returns labels, CV_32S: 1..n = basins, each connected by sides of pixels, 0 = outside the mask.
cv::Mat basins_of(const cv::Mat& relief, const cv::Mat& mask = {});

/// Whether two neighbouring basins are one. `saddle`: the lowest pass between them. `floor`: the lowest point of the
/// shallower basin.
using OneBasin = std::function<bool(float saddle, float floor)>;

/// Merges neighbouring basins, beginning at the lowest saddle, where `one_basin` says so. Labels 1..n without gaps.
cv::Mat merged_basins(const cv::Mat& relief, const cv::Mat& basins, const OneBasin& one_basin);

}  // namespace tessera
