#include "core/style/style_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/portable_math.h"

namespace tessera {
namespace {

/// Least CIELAB difference between neighbouring pixels at an edge; a gradient from black to white over 20 px has less.
constexpr float kEdgeStep = 5;
/// Least distance of calm pixels from edges, px: antialiasing is 1 px wide.
constexpr int kCalm_px = 2;
/// Least colour difference of a shade, over twice this many px: a gradient from black to white over 1,600 px. Steps of
/// 8 bits per channel are 0.4.
constexpr int kShadeReach_px = 4;
constexpr float kLeastShade = 0.5f;
/// A larger difference is not texture but an edge that was missed.
constexpr float kMostTexture = 6;
/// Fraction of calm pixels from which on shading counts fully; with fewer it counts in proportion.
constexpr double kLeastCalmPart = 0.05;

float difference(const Lab& a, const Lab& b) {
  const float l = a.lightness - b.lightness, x = a.a - b.a, y = a.b - b.b;
  return std::sqrt(l * l + x * x + y * y);
}

Grid<std::uint8_t> edges_of(const Grid<Lab>& colour) {
  Grid<std::uint8_t> edges(colour.width(), colour.height());
  const auto compare = [&](int x, int y, int to_x, int to_y) {
    if (!colour.bounds().contains(to_x, to_y) || difference(colour(x, y), colour(to_x, to_y)) < kEdgeStep) return;
    edges(x, y) = edges(to_x, to_y) = 1;
  };
  for (int y = 0; y < colour.height(); ++y) {
    for (int x = 0; x < colour.width(); ++x) {
      compare(x, y, x + 1, y);
      compare(x, y, x, y + 1);
    }
  }
  return edges;
}

/// The pixels inside with neither an edge nor the outside within kCalm_px.
Grid<std::uint8_t> calm_part(const StyleRaster& raster) {
  const Grid<std::uint8_t> edges = edges_of(raster.colour);
  Grid<std::uint8_t> calm = raster.inside;
  for (int y = 0; y < calm.height(); ++y) {
    for (int x = 0; x < calm.width(); ++x) {
      if (edges(x, y) == 0 && raster.inside(x, y) != 0) continue;
      for (int v = std::max(0, y - kCalm_px); v <= std::min(calm.height() - 1, y + kCalm_px); ++v) {
        for (int u = std::max(0, x - kCalm_px); u <= std::min(calm.width() - 1, x + kCalm_px); ++u) calm(u, v) = 0;
      }
    }
  }
  return calm;
}

Lab mean_of(const Lab& a, const Lab& b, const Lab& c, const Lab& d) {
  return {((a.lightness + c.lightness) + (b.lightness + d.lightness)) / 4, ((a.a + c.a) + (b.a + d.a)) / 4,
          ((a.b + c.b) + (b.b + d.b)) / 4};
}

/// Side of the cells in which colours are counted, CIELAB; it keeps their number small.
constexpr float kCell = 6;
constexpr int kLightnessCells = 18, kHueCells = 44;
constexpr float kLeastHue = -132;  // of a and b
/// Colours at this distance are entirely different; nearer ones are partly alike.
constexpr float kUnlike = 24;

/// The used colours of a cell.
struct PaletteColour {
  double part = 0;  // fraction of all counted pixels
  Lab mean;
};

class Palette {
 public:
  void add(const Lab& colour) {
    const int l = cell(colour.lightness, 0, kLightnessCells);
    const int a = cell(colour.a, kLeastHue, kHueCells), b = cell(colour.b, kLeastHue, kHueCells);
    Cell& to = cells_[std::size_t((l * kHueCells + a) * kHueCells + b)];
    to.pixels += 1;
    to.lightness += double(colour.lightness);
    to.a += double(colour.a);
    to.b += double(colour.b);
    all_ += 1;
  }

  std::vector<PaletteColour> colours() const {
    std::vector<PaletteColour> colours;
    for (const Cell& c : cells_) {
      if (c.pixels == 0) continue;
      colours.push_back(
          {c.pixels / all_, {float(c.lightness / c.pixels), float(c.a / c.pixels), float(c.b / c.pixels)}});
    }
    return colours;
  }
  bool empty() const { return all_ == 0; }

 private:
  struct Cell {
    double pixels = 0, lightness = 0, a = 0, b = 0;
  };

  static int cell(float value, float least, int cells) {
    return std::clamp(int((value - least) / kCell), 0, cells - 1);
  }

  std::vector<Cell> cells_ = std::vector<Cell>(std::size_t(kLightnessCells) * kHueCells * kHueCells);
  double all_ = 0;
};

/// The entropy of colours that are partly alike: Leinster and Cobbold, "Measuring diversity" (2012), of order 1.
double entropy_bits(const std::vector<PaletteColour>& colours) {
  constexpr double kLog2 = 0.6931471805599453;
  double sum = 0;
  for (const PaletteColour& own : colours) {
    double like = 0;
    for (const PaletteColour& other : colours)
      like += other.part * double(std::max(0.f, 1 - difference(own.mean, other.mean) / kUnlike));
    sum -= own.part * portable_log(like);
  }
  return std::max(0., sum / kLog2);
}

}  // namespace

StyleSurface style_surface(const StyleRaster& raster) {
  StyleSurface surface;
  surface.calm = calm_part(raster);
  const Grid<Lab>& c = raster.colour;
  double inside = 0, calm = 0, shaded = 0, texture = 0;
  for (int y = kShadeReach_px; y < c.height() - kShadeReach_px; ++y) {
    for (int x = kShadeReach_px; x < c.width() - kShadeReach_px; ++x) {
      inside += raster.inside(x, y);
      if (surface.calm(x, y) == 0) continue;
      ++calm;
      const Lab around = mean_of(c(x - 1, y), c(x, y - 1), c(x + 1, y), c(x, y + 1));
      texture += double(std::min(kMostTexture, difference(c(x, y), around)));
      const auto shade = [&](int dx, int dy) {
        const bool whole = surface.calm(x - dx, y - dy) != 0 && surface.calm(x + dx, y + dy) != 0;
        return whole ? difference(c(x - dx, y - dy), c(x + dx, y + dy)) : 0.f;
      };
      shaded += std::max(shade(kShadeReach_px, 0), shade(0, kShadeReach_px)) >= kLeastShade ? 1 : 0;
    }
  }
  if (inside == 0) return surface;
  const double judged = std::max(calm, kLeastCalmPart * inside);
  surface.texture = texture / judged;
  surface.shading = shaded / judged;
  surface.detail = 1 - calm / inside;
  return surface;
}

double palette_bits(const StyleRaster& raster, const Grid<std::uint8_t>& calm) {
  const auto palette_of = [&](const Grid<std::uint8_t>& counted) {
    Palette palette;
    for (std::size_t i = 0; i < counted.data().size(); ++i) {
      if (counted.data()[i] != 0) palette.add(raster.colour.data()[i]);
    }
    return palette;
  };
  const Palette palette = palette_of(calm);
  return entropy_bits(palette.empty() ? palette_of(raster.inside).colours() : palette.colours());
}

}  // namespace tessera
