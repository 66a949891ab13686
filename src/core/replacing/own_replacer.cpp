#include "core/replacing/own_replacer.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include "core/base/stop.h"
#include "core/replacing/window_queue.h"

namespace tessera {
namespace {

/// 0.1 MB each.
constexpr std::size_t kMostKept = 2000;

/// One has the window, the others help: a trial tries four candidates.
constexpr std::size_t kMostThreadsPerWindow = 4;

/// A look takes some microseconds, and messages that are under way wait for it.
constexpr std::chrono::milliseconds kBetweenLooks{1};

/// As many as the system gives.
void start_threads(WindowQueue& queue, std::size_t wanted, std::vector<std::jthread>& threads) {
  try {
    while (threads.size() < wanted) threads.emplace_back([&queue] { queue.work(); });
  } catch (const std::system_error&) {
  }
}

}  // namespace

OwnReplacer::OwnReplacer(ShapeSource& shapes, int threads, StopCheck check_stop)
    : shapes_(shapes),
      threads_(std::max(1, threads)),
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

/// Those that were not needed for longest; the last question's stay, however many they are.
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
  const HoleShapes shapes = shapes_of(windows);
  WindowQueue queue(windows, shapes);
  {
    std::vector<std::jthread> threads;
    try {
      const std::size_t wanted = std::min(kMostThreadsPerWindow * windows.size(), std::size_t(threads_));
      start_threads(queue, wanted, threads);
      if (threads.empty() && wanted > 0) queue.work();
      while (!queue.wait(kBetweenLooks)) check_stop_();
    } catch (...) {
      queue.give_up();
      throw;
    }
  }
  forget_some();
  return queue.take_outcomes();
}

}  // namespace tessera
