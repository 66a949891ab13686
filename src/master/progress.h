// How a run reports its progress, and how it is asked to stop: injected, so that tests are silent.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/base/stop.h"

namespace tessera::master {

struct Progress {
  std::size_t pieces = 0;
  double coverage = 0;            // fraction of the canvas, from the pieces' areas
  double seconds = 0;             // since the loop started
  bool exchanging = false;        // other pieces than these are worked on, that lie in each other: not in `coverage`
  std::size_t open_samples = 0;   // target samples left on the free region's boundary
  std::uint64_t trials = 0;       // of improving
  std::uint64_t most_trials = 0;  // 0: no limit
  int attempt = 1;                // above 1: pieces found no place, and it began again at other sizes
};

class Observer {
 public:
  virtual ~Observer() = default;
  virtual void progressed(const Progress& progress) = 0;
  /// Asked before every round and trial, and while a piece is chosen. A reason ends
  /// the loop with what is placed.
  virtual std::optional<StopReason> stop_requested() = 0;
};

class SilentObserver : public Observer {
 public:
  void progressed(const Progress&) override {}
  std::optional<StopReason> stop_requested() override { return std::nullopt; }
};

}  // namespace tessera::master
