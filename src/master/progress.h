// The interface by which a run reports its progress and is asked to stop. The caller injects both, so that tests are silent.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/base/stop.h"

namespace tessera::master {

struct Progress {
  std::size_t pieces = 0;
  double coverage = 0;            // fraction of the canvas, by the areas of the pieces
  double seconds = 0;             // since the loop started
  bool exchanging = false;        // a replacement phase works on other pieces, which overlap and are not in `coverage`
  std::size_t open_samples = 0;   // target samples left on the free region's boundary
  std::uint64_t trials = 0;       // of improving so far
  std::uint64_t most_trials = 0;  // 0: no limit
  int attempt = 1;                // above 1: pieces found no place, and filling began again at other sizes
};

class Observer {
 public:
  virtual ~Observer() = default;
  virtual void progressed(const Progress& progress) = 0;
  /// Whether the loop shall stop, and why. Called before every round and trial, and while a piece is chosen. Where it gives
  /// a reason, the loop ends with the pieces that are placed.
  virtual std::optional<StopReason> stop_requested() = 0;
};

class SilentObserver : public Observer {
 public:
  void progressed(const Progress&) override {}
  std::optional<StopReason> stop_requested() override { return std::nullopt; }
};

}  // namespace tessera::master
