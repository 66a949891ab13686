#include "core/style/style_measure.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/style/style_lines.h"
#include "core/style/style_surface.h"

namespace tessera {
namespace {

/// Largest distance of a contour's begin from the boundary, px.
constexpr int kContourReach_px = 2;

bool any_near(const Grid<float>& lines, int x, int y) {
  for (int v = std::max(0, y - kContourReach_px); v <= std::min(lines.height() - 1, y + kContourReach_px); ++v) {
    for (int u = std::max(0, x - kContourReach_px); u <= std::min(lines.width() - 1, x + kContourReach_px); ++u) {
      if (lines(u, v) > 0) return true;
    }
  }
  return false;
}

/// The fraction of the boundary pixels (inside, with one outside beside them) that are near a line.
double outlined_part(const StyleRaster& raster, const Grid<float>& lines) {
  const Grid<std::uint8_t>& in = raster.inside;
  double boundary = 0, outlined = 0;
  for (int y = 1; y + 1 < in.height(); ++y) {
    for (int x = 1; x + 1 < in.width(); ++x) {
      if (in(x, y) == 0 || (in(x - 1, y) && in(x + 1, y) && in(x, y - 1) && in(x, y + 1))) continue;
      ++boundary;
      outlined += any_near(lines, x, y) ? 1 : 0;
    }
  }
  return boundary > 0 ? outlined / boundary : 0;
}

struct Inside {
  double pixels = 0;
  double chroma = 0;
};

Inside measure_inside(const StyleRaster& raster) {
  Inside inside;
  for (std::size_t i = 0; i < raster.inside.data().size(); ++i) {
    if (raster.inside.data()[i] == 0) continue;
    const Lab& c = raster.colour.data()[i];
    ++inside.pixels;
    inside.chroma += double(std::sqrt(c.a * c.a + c.b * c.b));
  }
  return inside;
}

}  // namespace

StyleFeatures measure_style(const StyleRaster& raster) {
  const Inside inside = measure_inside(raster);
  if (inside.pixels == 0) return {};
  const Grid<float> lines = dark_lines(raster);
  const double line_px2 = std::accumulate(lines.data().begin(), lines.data().end(), 0.0);
  const double perimeter_px = crofton_perimeter_px(lines);
  const StyleSurface surface = style_surface(raster);
  StyleFeatures style;
  style.line_width = perimeter_px > 0 ? float(2 * line_px2 / perimeter_px / double(raster.unit_px)) : 0;
  style.line_part = float(std::min(1., line_px2 / inside.pixels));
  style.outlined = float(outlined_part(raster, lines));
  style.palette = float(palette_bits(raster, surface.calm));
  style.chroma = float(inside.chroma / inside.pixels);
  style.texture = float(surface.texture);
  style.shading = float(surface.shading);
  style.detail = float(surface.detail);
  return style;
}

}  // namespace tessera
