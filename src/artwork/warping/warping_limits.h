// Limits on one drawing that is deformed as vectors: far above openclipart (332 drawings: at most 19,286 elements), and
// within a process of 512 MiB. Each use of an element counts with all that it shows.
#pragma once

#include <cstddef>

#include "core/base/error.h"

namespace tessera {

/// Counts what is written, and throws InputError where a limit is exceeded.
class WarpingLimits {
 public:
  static constexpr double kMostPixels = 64e6;

  void count_element(int depth) {
    if (++elements_ > kMostElements) throw InputError("it has too many elements");
    if (depth > kDeepest) throw InputError("its elements stand too deep in each other");
  }
  void count_bytes(std::size_t count) {
    bytes_ += count;
    if (bytes_ > kMostBytes) throw InputError("it becomes too large");
  }
  void count_pixels(double count) {
    pixels_ += count;
    if (pixels_ > kMostPixels) throw InputError("its bitmaps have too many pixels");
  }
  /// Steps of paths that may still be written; the caller reduces it.
  std::size_t& steps_left() { return steps_left_; }

 private:
  static constexpr std::size_t kMostElements = 100'000;
  static constexpr std::size_t kMostSteps = 1'000'000;
  static constexpr std::size_t kMostBytes = std::size_t(48) << 20;
  static constexpr int kDeepest = 600;

  std::size_t elements_ = 0;
  std::size_t bytes_ = 0;
  std::size_t steps_left_ = kMostSteps;
  double pixels_ = 0;
};

}  // namespace tessera
