// Whole collages of synthetic shapes, with the plain C++ matcher.
#pragma once

#include "core/quality/quality.h"
#include "master/collage_loop.h"
#include "support/divided_matcher.h"

namespace tessera::whole_collage {

inline const std::vector<Shape>& library() {
  static const std::vector<Shape> shapes = test::synthetic_library(12);
  return shapes;
}

inline CollageSettings settings() {
  CollageSettings s;
  s.seed = 3;
  s.pieces.min_scale_px = 20;
  s.pieces.max_scale_px = 90;
  s.match.tangent_dockings = 150;
  return s;
}

/// Runs with the library divided at `cuts`.
inline master::CollageResult run(const Canvas& canvas, const CollageSettings& s, std::vector<std::uint32_t> cuts,
                                 master::Observer& observer) {
  const MatchingContext context = make_matching_context(s, std::uint32_t(library().size()));
  CompositeMatcher matcher = test::divided_matcher(library(), context, std::move(cuts));
  test::VectorShapes shapes(library());
  return master::make_collage(canvas, s, matcher, shapes, observer);
}

inline master::CollageResult run(const Canvas& canvas, const CollageSettings& s, std::vector<std::uint32_t> cuts = {}) {
  master::SilentObserver silent;
  return run(canvas, s, std::move(cuts), silent);
}

inline CollageSettings improved(int trials) {
  CollageSettings s = settings();
  s.improve.trials = trials;
  return s;
}

inline Quality quality_of(const Canvas& canvas, const std::vector<Placement>& placements,
                          const std::vector<Shape>& shapes) {
  return measure_quality(canvas, placements, [&](ShapeId id) -> const Shape& { return shapes[index_of(id)]; });
}

inline Quality quality(const Canvas& canvas, const master::CollageResult& result) {
  return quality_of(canvas, result.placements, library());
}

}  // namespace tessera::whole_collage
