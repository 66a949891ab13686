#include "core/replacing/own_replacer.h"

#include <algorithm>
#include <utility>

#include "core/replacing/replaced_windows.h"

namespace tessera {
namespace {

/// Shapes that are kept, 0.1 MB each.
constexpr std::size_t kMostKept = 2000;

}  // namespace

OwnReplacer::OwnReplacer(ShapeSource& shapes, TaskPool& pool, StopCheck check_stop)
    : shapes_(shapes),
      pool_(pool),
      check_stop_(std::move(check_stop)) {}

OwnReplacer::OwnReplacer(ShapeSource& shapes, int threads, StopCheck check_stop)
    : shapes_(shapes),
      own_pool_(std::make_unique<TaskPool>(threads)),
      pool_(*own_pool_),
      check_stop_(std::move(check_stop)) {}

const HoleShape& OwnReplacer::kept(ShapeId id) {
  auto found = kept_.find(id);
  if (found == kept_.end()) {
    check_stop_();
    found = kept_.emplace(id, Kept{make_hole_shape(shapes_.shape(id)), 0}).first;
  }
  found->second.used = questions_;
  return found->second.shape;
}

HoleShapes OwnReplacer::shapes_of(const std::vector<ReplacementWindow>& windows) {
  HoleShapes shapes;
  for (const ReplacementWindow& window : windows) {
    for (const WindowPiece& piece : window.moving) shapes[piece.shape] = &kept(piece.shape);
    for (const WindowPiece& piece : window.still) shapes[piece.shape] = &kept(piece.shape);
    for (const IncomingShape& in : window.incoming) shapes[in.shape] = &kept(in.shape);
  }
  return shapes;
}

/// Forgets the shapes that were not needed for the longest time. Those of the last question stay, whatever their
/// number.
void OwnReplacer::forget_some() {
  if (kept_.size() <= kMostKept) return;
  std::vector<std::uint64_t> used;
  for (const auto& [id, kept] : kept_) used.push_back(kept.used);
  const auto oldest_kept = used.end() - std::ptrdiff_t(kMostKept);
  std::nth_element(used.begin(), oldest_kept, used.end());
  const std::uint64_t least = *oldest_kept;
  auto room = std::count(oldest_kept, used.end(), least);
  std::erase_if(kept_, [&](const auto& entry) {
    const std::uint64_t when = entry.second.used;
    return when < questions_ && (when < least || (when == least && room-- <= 0));
  });
}

std::vector<ReplacementOutcome> OwnReplacer::take_replaced() {
  const std::vector<ReplacementWindow> windows = std::exchange(posted_, {});
  ++questions_;
  std::vector<ReplacementOutcome> outcomes = replaced_windows(windows, shapes_of(windows), pool_, check_stop_);
  forget_some();
  return outcomes;
}

}  // namespace tessera
