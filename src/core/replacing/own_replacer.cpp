#include "core/replacing/own_replacer.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "core/replacing/window_trials.h"

namespace tessera {
namespace {

/// 0.1 MB each.
constexpr std::size_t kMostKept = 2000;

/// Another thread's window failed.
struct GivenUp {};

}  // namespace

OwnReplacer::OwnReplacer(ShapeSource& shapes, int threads, std::function<void()> look)
    : shapes_(shapes),
      threads_(std::max(1, threads)),
      look_(std::move(look)) {}

const HoleShape& OwnReplacer::kept(ShapeId id) {
  auto found = kept_.find(id);
  if (found == kept_.end()) found = kept_.emplace(id, Kept{make_hole_shape(shapes_.shape(id)), 0}).first;
  found->second.used = questions_;
  return found->second.shape;
}

void OwnReplacer::forget_some() {
  if (kept_.size() <= kMostKept) return;
  std::erase_if(kept_, [this](const auto& entry) { return entry.second.used < questions_; });
}

std::vector<ReplacementOutcome> OwnReplacer::take_replaced() {
  const std::vector<ReplacementWindow> windows = std::exchange(posted_, {});
  ++questions_;
  HoleShapes shapes;
  for (const ReplacementWindow& window : windows) {
    look_();
    for (const WindowPiece& piece : window.moving) shapes[piece.shape] = &kept(piece.shape);
    for (const WindowPiece& piece : window.still) shapes[piece.shape] = &kept(piece.shape);
    for (const IncomingShape& in : window.incoming) shapes[in.shape] = &kept(in.shape);
  }
  std::vector<ReplacementOutcome> outcomes(windows.size());
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  std::exception_ptr error;
  std::mutex mutex;
  const auto work = [&](const std::function<void()>& look) {
    try {
      for (std::size_t i = next++; i < windows.size(); i = next++) {
        outcomes[i] = replaced(windows[i], shapes, [&] {
          if (failed) throw GivenUp{};
          look();
        });
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!error) error = std::current_exception();
      failed = true;
    }
  };
  {
    std::vector<std::jthread> threads;
    const std::size_t wanted = std::min<std::size_t>(windows.size(), std::size_t(threads_));
    for (std::size_t i = 1; i < wanted; ++i) threads.emplace_back(work, [] {});
    work(look_);
  }
  if (error) std::rethrow_exception(error);
  forget_some();
  return outcomes;
}

}  // namespace tessera
