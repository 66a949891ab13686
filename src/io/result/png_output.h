// collage.png: the artworks as placed, on the canvas.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "io/result/collage_files.h"

namespace tessera::io {

/// A picture of a run with work left is no wider than this: the time limit is near, or mpirun is about to kill it.
inline constexpr int kQuickWidth_px = 2000;

/// BGR, CV_8UC3, OutputSpec::width_px wide. The canvas region has the background colour, what lies outside it is white;
/// pieces are drawn in order of placement and clipped by the picture only. `quick` draws from thumbnails, and
/// no wider than kQuickWidth_px.
cv::Mat draw_collage(const CollageReport& report, bool quick);

/// The same as a PNG file.
std::vector<std::uint8_t> collage_png(const CollageReport& report, bool quick);

}  // namespace tessera::io
