// The interface by which drawing reports its progress and is asked to stop.
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <thread>

#include "artwork/drawers/drawers.h"
#include "core/base/stop.h"

namespace tessera {

/// Receives the progress; the caller injects it, so that tests are silent.
class DrawingObserver {
 public:
  virtual ~DrawingObserver() = default;
  /// Called from the thread that draws. `total` is the value that `done` has at the end of this picture.
  virtual void progressed(const char* picture, std::size_t done, std::size_t total) = 0;
  /// Called often, from any thread. A reason ends the drawing with DrawingStopped.
  virtual std::optional<StopReason> stop_requested() = 0;
};

/// Asks the observer 50 times a second while it lives. When the observer wants to stop, it stops the drawers, so that
/// nobody waits for a slow drawing, and check() throws. Where the system has no further thread, only check() asks.
class StopWatcher {
 public:
  StopWatcher(DrawingObserver& observer, Drawers& drawers);

  /// Throws DrawingStopped where drawing shall stop. Cheap; may be called from any thread.
  void check() const;

 private:
  void watch(std::stop_token done);

  DrawingObserver& observer_;
  Drawers& drawers_;
  std::atomic<bool> stopped_ = false;
  std::jthread thread_;  // the last member, because it uses the others
};

}  // namespace tessera
