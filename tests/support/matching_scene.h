// A scene for matchers: a small library of formula shapes, a canvas with a few of them, and the target samples of the free region. It is
// the same on every machine.
#pragma once

#include <cmath>
#include <map>
#include <vector>

#include "core/field/free_field.h"
#include "core/field/opened_field.h"
#include "core/field/target_curve.h"
#include "core/matching/matching_context.h"
#include "core/shape/shape_builder.h"
#include "support/colours.h"
#include "support/synthetic_shapes.h"

namespace tessera::test {

inline Shape shape_from_outline(const Outline& outline, const PadParameters& pad) {
  TracedOutline traced;
  for (std::vector<Vec2> curve : outline.curves) {
    for (Vec2& p : curve) p = p * 150.f;
    traced.curves.push_back(smoothing_spline(curve, 1.5));
  }
  return make_shape(traced, pad);
}

/// Blobs with a star, a rectangle, a bean and a ring among them.
inline std::vector<Shape> formula_shapes(int count, const PadParameters& pad) {
  const std::vector<Outline> others = {star_outline(5), rectangle_outline(1.f, 0.6f), bean_outline(), ring_outline()};
  std::vector<Shape> shapes;
  for (int i = 0; i < count; ++i) {
    const bool other = i % 5 == 4 && i / 5 < int(others.size());
    shapes.push_back(shape_from_outline(other ? others[i / 5] : blob_outline(std::uint32_t(i + 1)), pad));
    shapes.back().colour_grid =
        two_toned_grid(numbered_colour(std::uint32_t(i)), numbered_colour(std::uint32_t(3 * i)));
  }
  return shapes;
}

struct MatchingScene {
  CollageSettings settings;
  MatchingContext context;
  std::vector<ShapeModel> models;
  CanvasField field;
  std::vector<TargetSample> samples;  // an even choice from all, at most as many as asked for
};

struct SceneSize {
  int shapes = 10;
  int canvas_px = 260;
  int placed = 4;
  int samples = 12;
};

inline CollageSettings scene_settings() {
  CollageSettings settings;
  settings.pieces.min_scale_px = 16;
  settings.pieces.max_scale_px = 90;
  settings.match.tangent_dockings = 60;
  return settings;
}

/// Places shapes in a ring around the middle, with narrow gaps between them.
inline void stamp_shapes(FreeField& free, const std::vector<Shape>& shapes, int count, float canvas_px) {
  for (int i = 0; i < count; ++i) {
    const float angle = kTwoPi * float(i) / float(count) + 0.3f;
    const float scale = canvas_px * (0.14f + 0.05f * float(i % 3));
    Similarity s;
    s.a = scale * std::cos(2.3f * float(i));
    s.b = scale * std::sin(2.3f * float(i));
    s.tx = canvas_px * (0.5f + 0.27f * std::cos(angle));
    s.ty = canvas_px * (0.5f + 0.27f * std::sin(angle));
    free.stamp(shapes[i % shapes.size()], s);
  }
}

inline std::vector<TargetSample> trace_samples(const FreeField& free, const CollageSettings& settings, int most) {
  const OpenedField opened(free, settings.pieces);
  TargetCurve curve(settings.pieces, settings.match.pad);
  curve.retrace(opened, free.field().origin, {opened.contour().bounds()});
  const std::vector<SampleId> ids = curve.samples();
  const std::size_t count = std::min(ids.size(), std::size_t(most));
  std::vector<TargetSample> samples;
  for (std::size_t i = 0; i < count; ++i) samples.push_back(curve.sample(ids[i * ids.size() / count]));
  return samples;
}

inline MatchingScene make_scene(const CollageSettings& settings = scene_settings(), const SceneSize& size = {}) {
  const PadParameters library_pad;
  static std::map<int, const std::vector<Shape>> made;  // these take most of a scene's time
  if (!made.contains(size.shapes)) made.emplace(size.shapes, formula_shapes(size.shapes, library_pad));
  const std::vector<Shape>& shapes = made.at(size.shapes);
  MatchingScene scene;
  scene.settings = settings;
  scene.context = make_matching_context(settings, std::uint32_t(shapes.size()));
  for (const Shape& shape : shapes) {
    scene.models.push_back(make_shape_model(shape, library_pad, settings.match.pad, scene.context.levels));
  }
  FreeField free(make_rectangle_canvas(size.canvas_px, size.canvas_px), settings.pieces);
  stamp_shapes(free, shapes, size.placed, float(size.canvas_px));
  scene.field = free.field();
  scene.samples = trace_samples(free, settings, size.samples);
  return scene;
}

}  // namespace tessera::test
