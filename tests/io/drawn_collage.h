// The pictures of a report, for the tests: as tessera draw makes them, but in memory.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "io/drawing/drawers.h"
#include "io/result/picture_drawing.h"
#include "io/result/shape_artworks.h"
#include "io/result/stop_watcher.h"
#include "io/result/svg_output.h"

namespace tessera::test {

class SilentDrawing : public io::DrawingObserver {
 public:
  void progressed(const char*, std::size_t, std::size_t) override {}
  bool stop_requested() override { return false; }
};

/// The shapes of a report, ready to be drawn.
struct DrawnCollage {
  explicit DrawnCollage(const io::CollageReport& its_report, const io::DrawerSettings& settings = {.processes = 2})
      : report(its_report),
        drawers(settings) {}

  cv::Mat picture(const io::PictureLimits& limits = {}) {
    cv::Mat whole;
    io::draw_picture(report, artworks, limits, [&](const cv::Mat& rows) { whole.push_back(rows); });
    return whole;
  }

  const io::CollageReport& report;
  SilentDrawing observer;
  io::Drawers drawers;
  io::StopWatcher stop{observer, drawers};
  io::ShapeArtworks artworks{report, drawers, stop};
};

inline cv::Mat drawn_picture(const io::CollageReport& report) { return DrawnCollage(report).picture(); }

inline std::string drawn_svg(const io::CollageReport& report) {
  DrawnCollage drawn(report);
  return collage_svg(report, drawn.artworks);
}

}  // namespace tessera::test
