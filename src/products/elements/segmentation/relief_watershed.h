// Watersheds of a relief, and how shallow basins become one. cv::watershed floods by differences of colour instead.
#pragma once

#include <functional>
#include <opencv2/core.hpp>

namespace tessera {

/// `relief`: CV_32F; `mask`: CV_8U, what may be flooded, or empty = all. Each minimum of the relief floods its own
/// basin. Labels CV_32S: 1..n = basins, each connected by its pixels' sides, 0 = outside the mask.
cv::Mat basins_of(const cv::Mat& relief, const cv::Mat& mask = {});

/// Are two neighbours one? `saddle`: the lowest pass between them; `floor`: that of the basin which is less deep.
using OneBasin = std::function<bool(float saddle, float floor)>;

/// Neighbouring basins become one from the lowest saddle upwards where `one_basin` says so. Labels 1..n without gaps.
cv::Mat merged_basins(const cv::Mat& relief, const cv::Mat& basins, const OneBasin& one_basin);

}  // namespace tessera
