#include "tessera/matching/drawing.h"

#include "package/drawer_of_package.h"
#include "package/translated_errors.h"
#include "recognition/drawn_curves.h"

namespace tessera::matching {
namespace {

/// The narrowest smoothing, in pixels, as in tessera match: for silhouettes, and for thinned lines, which are rougher.
constexpr double kOutlineSigma_px = 1.5;
constexpr double kCentreLineSigma_px = 2;

Outline outline_of(const DrawnCurves& drawn, double sigma_px) {
  Outline outline;
  outline.smoothing = sigma_px * double(drawn.pixel);
  for (const tessera::Curve& curve : drawn.curves) {
    Curve& own = outline.curves.emplace_back();
    own.closed = curve.closed;
    for (const Vec2 p : curve.points) own.points.push_back({p.x, p.y});
  }
  return outline;
}

}  // namespace

Outline read_drawing(const std::string& path, Trace trace) {
  return with_errors_translated([&] {
    Drawers drawers({.program = drawer_of_package()});
    const bool outlines = trace == Trace::outlines;
    const TracedAs kind = outlines ? TracedAs::outlines : TracedAs::centre_lines;
    return outline_of(read_drawn_curves(path, kind, drawers), outlines ? kOutlineSigma_px : kCentreLineSigma_px);
  });
}

}  // namespace tessera::matching
