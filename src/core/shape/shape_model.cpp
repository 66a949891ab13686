#include "core/shape/shape_model.h"

#include <cmath>

#include "core/geometry/closed_curve.h"
#include "core/geometry/extent.h"
#include "core/shape/level_curve.h"

namespace tessera {
namespace {

constexpr float kInteriorSpacing = 0.13f;  // shape units: about 50 points
constexpr float kInteriorDepth = 0.04f;
constexpr float kInteriorReach = 10;  // shapes of area 1 that reach farther are hairlines, or damaged

struct CurveShare {
  const std::vector<Vec2>* curve;
  int points;
};

/// kBoundaryPoints divided among the curves by length. Every hole gets at least 4, the outer curve the rest.
std::vector<CurveShare> shares(const Outline& outline) {
  float total = 0;
  for (const auto& curve : outline.curves) total += closed_length(curve);
  std::vector<CurveShare> result;
  int left = kBoundaryPoints;
  for (std::size_t c = 1; c < outline.curves.size() && left > kBoundaryPoints / 2; ++c) {
    const int points = std::max(4, int(std::lround(kBoundaryPoints * closed_length(outline.curves[c]) / total)));
    result.push_back({&outline.curves[c], std::min(points, left - kBoundaryPoints / 2)});
    left -= result.back().points;
  }
  result.insert(result.begin(), {&outline.curves.front(), left});
  return result;
}

void add_boundary(ShapeModel& model, int at, const CurveShare& share) {
  const std::vector<Vec2> points = resampled_closed(*share.curve, share.points);
  // Tangents over about a fortieth of the curve: docking needs a frame, not details.
  const int reach = std::max(1, share.points / 48);
  for (int i = 0; i < share.points; ++i) {
    const Vec2 chord = points[(i + reach) % share.points] - points[(i + share.points - reach) % share.points];
    model.boundary[at + i] = points[i];
    model.tangent[at + i] = chord * (1 / std::max(norm(chord), 1e-9f));
  }
}

std::vector<Vec2> interior_points(const Shape& shape) {
  std::vector<Vec2> points;
  const int reach = int(std::min(shape.radius, kInteriorReach) / kInteriorSpacing) + 1;
  for (int j = -reach; j <= reach; ++j) {
    for (int i = -reach; i <= reach; ++i) {
      const Vec2 p{float(i) * kInteriorSpacing, float(j) * kInteriorSpacing};
      if (shape.field.at(p) >= -kInteriorDepth) continue;
      points.push_back(p);
      if (points.size() == kMaxInteriorPoints) return points;
    }
  }
  return points;
}

void set_disc(ShapeModel& model, const ShapeField& field) {
  const Grid<float>& distance = field.distance;
  const float step = 2 * field.extent / float(distance.width() - 1);
  for (int j = 0; j < distance.height(); ++j) {
    for (int i = 0; i < distance.width(); ++i) {
      if (-distance(i, j) <= model.disc_radius) continue;
      model.disc_radius = -distance(i, j);
      model.disc_centre = {float(i) * step - field.extent, float(j) * step - field.extent};
    }
  }
}

ModelLevel make_level(const Shape& shape, int level, const PadParameters& library_pad, const PadParameters& pad) {
  const SmoothingLevel& kind = kSmoothingLevels[level];
  const LevelCurve& curve = shape.levels[level];
  ModelLevel result;
  result.level = level;
  const float step = keypoint_step(shape.radius);
  for (const ArclengthPyramid& pyramid :
       pad == library_pad ? curve.samples : sample_pyramids(curve.points, kind.sigma, kind.samples, pad)) {
    result.samples.push_back(make_model_sample(pyramid, pad.levels, step));
  }
  return result;
}

}  // namespace

ScaleRange level_scales(int level, float target_sigma_px) {
  const float centre = target_sigma_px / kSmoothingLevels[level].sigma;
  return {centre * 0.70710678f, centre * 1.41421356f};
}

std::vector<int> levels_for_scales(float min_scale_px, float max_scale_px, float target_sigma_px) {
  const float middle_px = std::sqrt(min_scale_px * max_scale_px);
  std::vector<int> levels;
  for (int k = 0; k < int(kSmoothingLevels.size()); ++k) {
    const ScaleRange range = level_scales(k, target_sigma_px);
    // The neighbouring level serves a small part of an octave at either end. If the range has nothing else, the level
    // of its middle serves it.
    const bool more_than_a_sliver = range.high > min_scale_px * kLevelSliver && range.low < max_scale_px / kLevelSliver;
    if (more_than_a_sliver || (range.low <= middle_px && middle_px < range.high)) levels.push_back(k);
  }
  return levels;
}

ShapeModel make_shape_model(const Shape& shape, const PadParameters& library_pad, const PadParameters& pad,
                            const std::vector<int>& levels) {
  ShapeModel model;
  model.perimeter = shape.perimeter;
  model.radius = shape.radius;
  int at = 0;
  for (const CurveShare& share : shares(shape.outline)) {
    add_boundary(model, at, share);
    at += share.points;
  }
  model.interior = interior_points(shape);
  set_disc(model, shape.field);
  const Extent box = extent_of(shape.outline.curves.front(), {1, 0, 0, 0});
  model.colour = make_colour_model(shape.colour_grid, box.low, box.high);
  for (const int level : levels) model.levels.push_back(make_level(shape, level, library_pad, pad));
  return model;
}

}  // namespace tessera
