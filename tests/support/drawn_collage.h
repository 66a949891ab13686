// Draws a report's pictures as tessera draw does, but in memory.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "artwork/drawers/drawers.h"
#include "core/base/stop.h"
#include "render/picture_drawing.h"
#include "render/pieces/shape_artworks.h"
#include "render/pieces/stop_watcher.h"
#include "render/svg_output.h"

namespace tessera::test {

class SilentDrawing : public DrawingObserver {
 public:
  void progressed(const char*, std::size_t, std::size_t) override {}
  std::optional<StopReason> stop_requested() override { return std::nullopt; }
};

/// A report with its shapes' artwork, ready to be drawn.
struct DrawnCollage {
  explicit DrawnCollage(const CollageReport& its_report, const DrawerSettings& settings = {.processes = 2})
      : report(its_report),
        drawers(settings) {}

  cv::Mat picture(const PictureLimits& limits = {}) {
    cv::Mat whole;
    draw_picture(report, artworks, limits, [&](const cv::Mat& rows) { whole.push_back(rows); });
    return whole;
  }

  const CollageReport& report;
  SilentDrawing observer;
  Drawers drawers;
  StopWatcher stop{observer, drawers};
  ShapeArtworks artworks{report, drawers, stop};
};

inline cv::Mat drawn_picture(const CollageReport& report) { return DrawnCollage(report).picture(); }

inline std::string drawn_svg(const CollageReport& report) {
  DrawnCollage drawn(report);
  return collage_svg(report, drawn.artworks);
}

}  // namespace tessera::test
