#include "bench/segments/target_stretches.h"

#include "core/field/free_field.h"
#include "core/field/opened_field.h"
#include "core/settings/tuning.h"

namespace tessera::bench {
namespace {

PieceSettings without_padding(PieceSettings pieces) {
  pieces.padding_px = 0;  // already subtracted from the free field
  return pieces;
}

Canvas canvas_of(const CanvasField& free) {
  Canvas canvas;
  canvas.width_px = free.value.width() - 2 * kCanvasMargin;
  canvas.height_px = free.value.height() - 2 * kCanvasMargin;
  canvas.distance = free;
  return canvas;
}

}  // namespace

TargetStretches::TargetStretches(const PieceSettings& pieces) : pieces_(without_padding(pieces)) {}

void TargetStretches::trace(const CanvasField& free) {
  const OpenedField opened(FreeField(canvas_of(free), pieces_), pieces_);
  curve_.emplace(target_sigma_px(pieces_));
  curve_->retrace(opened.contour(), opened.grid(), free.origin, {opened.contour().bounds()});
}

/// The vertices after `from` that are nearer to it than `length_px` along the curve. Nullopt where the walk meets
/// `last`.
std::optional<std::vector<int>> TargetStretches::walk(int from, float length_px, bool forward, int last) {
  std::vector<int> passed;
  float walked_px = 0;
  for (int at = from;;) {
    const int next = forward ? curve_->vertex(at).next : curve_->vertex(at).previous;
    walked_px += curve_->vertex(forward ? at : next).edge_after;
    if (walked_px >= length_px) return passed;
    if (next == last) return std::nullopt;
    passed.push_back(next);
    at = next;
  }
}

std::vector<Vec2> TargetStretches::around(const TargetSample& sample, int level) {
  const int middle = curve_->find(GridEdge::of(edge_number(sample.id), curve_->width()));
  if (middle == LinkedContour::kNone) return {};
  const auto at = std::size_t(level);
  const auto right = walk(middle, sample.pyramid.right[at], true, middle);
  if (!right) return {};
  const auto left = walk(middle, sample.pyramid.left[at], false, right->empty() ? middle : right->back());
  if (!left) return {};
  std::vector<Vec2> stretch;
  for (auto v = left->rbegin(); v != left->rend(); ++v) stretch.push_back(curve_->vertex(*v).smooth);
  stretch.push_back(curve_->vertex(middle).smooth);
  for (const int v : *right) stretch.push_back(curve_->vertex(v).smooth);
  return stretch;
}

}  // namespace tessera::bench
