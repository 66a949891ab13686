// Whole collages with a phase of replacement trials.
#pragma once

#include <cstdint>
#include <vector>

#include "asked_replacer.h"
#include "stopped_collage.h"
#include "whole_collage.h"

namespace tessera::master::replacement_phase {

using stopped_collage::KeepLatest;
using whole_collage::library;
using whole_collage::quality;

inline CollageSettings settings(int trials, float min_scale_px = 40, float max_scale_px = 80) {
  CollageSettings s = whole_collage::improved(trials);
  s.pieces.min_scale_px = min_scale_px;
  s.pieces.max_scale_px = max_scale_px;
  return s;
}

inline CollageResult run(const Canvas& canvas, const CollageSettings& s, Replacer* replacer, Observer& observer,
                         const Checkpoints& checkpoints = {}) {
  const MatchingContext context = make_matching_context(s, std::uint32_t(library().size()));
  CompositeMatcher matcher = test::divided_matcher(library(), context, {});
  test::VectorShapes shapes(library());
  return make_collage(canvas, s, matcher, shapes, observer, checkpoints, replacer);
}

inline CollageResult run(const Canvas& canvas, const CollageSettings& s, Replacer* replacer) {
  SilentObserver silent;
  return run(canvas, s, replacer, silent);
}

inline std::uint64_t trials_of(const std::vector<ReplacementWindow>& windows) {
  std::uint64_t trials = 0;
  for (const ReplacementWindow& w : windows) trials += w.trials;
  return trials;
}

inline const Canvas& small_canvas() {
  static const Canvas canvas = make_rectangle_canvas(160, 120);
  return canvas;
}

}  // namespace tessera::master::replacement_phase
