#include "render/pieces/stop_watcher.h"

#include <chrono>
#include <system_error>
#include <utility>

namespace tessera {
namespace {

constexpr std::chrono::milliseconds kPause{20};

}  // namespace

StopWatcher::StopWatcher(DrawingObserver& observer, Drawers& drawers)
    : observer_(observer),
      drawers_(drawers),
      stopped_(observer.stop_requested().has_value()) {
  try {
    thread_ = std::jthread([this](std::stop_token done) { watch(std::move(done)); });
  } catch (const std::system_error&) {  // no further thread: check() still asks, between two pieces
  }
}

void StopWatcher::check() const {
  if (stopped_ || observer_.stop_requested()) throw DrawingStopped();
}

void StopWatcher::watch(std::stop_token done) {
  while (!done.stop_requested()) {
    if (stopped_ || observer_.stop_requested()) {
      stopped_ = true;
      drawers_.stop();
      return;
    }
    std::this_thread::sleep_for(kPause);
  }
}

}  // namespace tessera
