// How a run tells of itself, and how it is asked to stop: injected, so that tests are silent.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tessera::master {

struct Progress {
  std::size_t pieces = 0;
  double coverage = 0;   // fraction of the canvas, from the pieces' areas
  double seconds = 0;    // since the loop started
  std::size_t open_samples = 0;  // target samples left on the free region's boundary
  std::uint64_t trials = 0;      // of ruin and recreate
};

class Observer {
 public:
  virtual ~Observer() = default;
  virtual void progressed(const Progress& progress) = 0;
  /// Asked once a round; true ends the loop with what is placed.
  virtual bool stop_requested() = 0;
};

class SilentObserver : public Observer {
 public:
  void progressed(const Progress&) override {}
  bool stop_requested() override { return false; }
};

}  // namespace tessera::master
