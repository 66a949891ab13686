#include "core/replacing/own_replacer.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "core/replacing/window_queue.h"

namespace tessera {
namespace {

/// 0.1 MB each.
constexpr std::size_t kMostKept = 2000;

/// A look takes some microseconds, and messages that are under way wait for it.
constexpr std::chrono::milliseconds kBetweenLooks{1};

}  // namespace

OwnReplacer::OwnReplacer(ShapeSource& shapes, int threads, std::function<void()> look)
    : shapes_(shapes),
      threads_(std::max(1, threads)),
      look_(std::move(look)) {}

const HoleShape& OwnReplacer::kept(ShapeId id) {
  auto found = kept_.find(id);
  if (found == kept_.end()) {
    look_();
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

void OwnReplacer::forget_some() {
  if (kept_.size() <= kMostKept) return;
  std::erase_if(kept_, [this](const auto& entry) { return entry.second.used < questions_; });
}

std::vector<ReplacementOutcome> OwnReplacer::take_replaced() {
  const std::vector<ReplacementWindow> windows = std::exchange(posted_, {});
  ++questions_;
  const HoleShapes shapes = shapes_of(windows);
  WindowQueue queue(windows, shapes);
  {
    std::vector<std::jthread> threads;
    try {
      const int wanted = windows.empty() ? 0 : threads_;
      for (int i = 0; i < wanted; ++i) threads.emplace_back([&queue] { queue.work(); });
      while (!queue.wait(kBetweenLooks)) look_();
    } catch (...) {
      queue.give_up();
      throw;
    }
  }
  forget_some();
  return queue.take_outcomes();
}

}  // namespace tessera
