// How drawing reports its progress, and how it is asked to stop.
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <thread>

#include "artwork/drawers/drawers.h"
#include "core/base/stop.h"

namespace tessera {

/// Injected, so that tests are silent.
class DrawingObserver {
 public:
  virtual ~DrawingObserver() = default;
  /// Called from the thread that draws; `total` is what `done` reaches at the end of this picture.
  virtual void progressed(const char* picture, std::size_t done, std::size_t total) = 0;
  /// Asked again and again, from any thread: a reason ends the drawing with DrawingStopped.
  virtual std::optional<StopReason> stop_requested() = 0;
};

/// While it lives it asks the observer 50 times a second. Once that wants to stop, it stops the drawers, so that nobody
/// waits for a drawing that takes long, and check() throws. Where the system gives no further thread, only check() asks.
class StopWatcher {
 public:
  StopWatcher(DrawingObserver& observer, Drawers& drawers);

  /// Throws DrawingStopped. Cheap; from any thread.
  void check() const;

 private:
  void watch(std::stop_token done);

  DrawingObserver& observer_;
  Drawers& drawers_;
  std::atomic<bool> stopped_ = false;
  std::jthread thread_;  // last: it uses the others
};

}  // namespace tessera
