// A library shape. Shape frame: origin at the centroid of the silhouette's area, unit of length = square root of that
// area, y down as in the artwork. So the scale of a canvas_from_shape is the piece's size in canvas px ("square root of
// the piece's area").
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/colour/colour_grid.h"
#include "core/geometry/grid.h"
#include "core/geometry/polygon.h"
#include "core/geometry/vec2.h"
#include "core/pad/pad.h"

namespace tessera {

/// Signed distance to the outline in shape units, positive outside. The square grid spans [-extent, extent] in both
/// directions: node 0 at -extent, the last node at +extent. It covers the shape with a rim of at least 0.1 units.
struct ShapeField {
  Grid<float> distance;
  float extent = 0;

  /// Bilinear within the grid, a lower bound outside. The bound holds because the grid is convex and contains the
  /// outline: seen from p, the outline lies at an obtuse angle behind the grid's nearest point.
  float at(Vec2 p) const;
  /// The value at the point of the grid that is nearest to p; `beyond` is the distance of p to that point.
  float at_nearest(Vec2 p, float& beyond) const;
};

inline float ShapeField::at(Vec2 p) const {
  float beyond;
  const float d = at_nearest(p, beyond);
  return beyond > 0 ? std::sqrt(d * d + beyond * beyond) : d;
}

inline float ShapeField::at_nearest(Vec2 p, float& beyond) const {
  const Vec2 nearest{std::clamp(p.x, -extent, extent), std::clamp(p.y, -extent, extent)};
  const int last = distance.width() - 1;
  const float nodes_per_unit = float(last) / (2 * extent);
  const float u = (nearest.x + extent) * nodes_per_unit;
  const float v = (nearest.y + extent) * nodes_per_unit;
  const int i = std::min(int(u), last - 1);
  const int j = std::min(int(v), last - 1);
  const float s = u - float(i), t = v - float(j);
  const float upper = distance(i, j) * (1 - s) + distance(i + 1, j) * s;
  const float lower = distance(i, j + 1) * (1 - s) + distance(i + 1, j + 1) * s;
  beyond = nearest == p ? 0.f : norm(p - nearest);
  return upper * (1 - t) + lower * t;
}

/// A level of smoothing. Matching needs both curves smoothed by the same fraction of size, so there are a few fixed
/// levels.
struct SmoothingLevel {
  float sigma;       // width of the Gaussian along the curve, shape units
  int curve_points;  // points of even arclength of the smoothed outer curve
  int samples;       // PADs, at every (curve_points / samples)-th point
};

/// The levels, an octave apart. A piece of scale s px agrees with a target smoothed by sigma_px if s · sigma is within
/// half an octave of sigma_px. Together the levels serve a range of scales of 32 : 1.
inline constexpr std::array<SmoothingLevel, 5> kSmoothingLevels = {{
    {0.176777f, 256, 64},
    {0.088388f, 256, 64},
    {0.044194f, 256, 128},
    {0.022097f, 512, 128},
    {0.011049f, 1024, 128},
}};

/// The outer curve at one smoothing level.
struct LevelCurve {
  std::vector<Vec2> points;  // SmoothingLevel::curve_points points of even arclength, shape frame
  float perimeter = 0;       // of the smoothed curve, shape units
  /// SmoothingLevel::samples pyramids; sample j lies at point j·curve_points/samples.
  std::vector<ArclengthPyramid> samples;
};

using Sha256 = std::array<std::uint8_t, 32>;

/// Version of the reading of drawings. It is increased when drawings are read differently, as a drawing made again from
/// its original would no longer fit its outline. Version 1: images as they are stored; version 2: turned as their EXIF
/// data say.
inline constexpr int kArtworkReader = 2;

/// The opacity of other elements in Artwork::surroundings_png: half of that of ground, to tell them apart.
inline constexpr std::uint8_t kOtherElementAlpha = 128;

/// The data of the original drawing that pictures need. Artwork frame: px of the raster from which the outline was
/// traced (`width_px` x `height_px`). Its y axis points down; the origin is the upper left corner of the upper left
/// pixel.
struct Artwork {
  std::string path;                 // absolute path at build time
  std::string path_beside_library;  // its path if it was moved together with the library; may be empty
  std::optional<Sha256> sha256;     // of the file at build time; empty in libraries of older versions
  int reader = kArtworkReader;      // the version of kArtworkReader that made the shape
  int width_px = 0;
  int height_px = 0;
  bool mirrored = false;                    // the shape is the drawing's mirror image
  Vec2 centroid_px;                         // shape origin in the artwork frame
  float unit_px = 0;                        // artwork px for one shape unit
  std::vector<std::uint8_t> thumbnail_png;  // RGBA PNG, longest side <= 192 px
  std::vector<std::uint8_t> original;       // the file itself, empty unless embedded (library build --embed)
  /// For a drawing that was cut out of a photo: the original's page and a margin of the photo round it, RGBA PNG. The
  /// element and its ground are opaque; other elements have kOtherElementAlpha. Empty: of no photo.
  std::vector<std::uint8_t> surroundings_png;
  int surroundings_margin_px = 0;  // on each side, px of the original
};

struct Shape {
  std::string name;     // file name without extension, unique within a library
  Outline outline;      // outer curve: 512 points of even arclength; holes in proportion, at least 16
  float perimeter = 0;  // of all curves
  float radius = 0;     // largest distance of an outline point from the origin
  ShapeField field;
  std::array<LevelCurve, kSmoothingLevels.size()> levels;
  std::array<float, 3> mean_lab{};  // CIELAB (D65), alpha-weighted mean
  float colour_spread = -1;         // root mean square distance of the colours from mean_lab; negative: unknown
  ColourGrid colour_grid{};         // over the outline's bounding box
  /// The scale at which a piece is as large as it was drawn: px of an image, 1/96 inch of an SVG; 0: unknown.
  float drawn_scale_px = 0;
  Artwork artwork;
};

}  // namespace tessera
