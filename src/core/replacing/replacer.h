// Runs replacement trials, on this rank's cores or on other ranks. A question is posted, then taken.
#pragma once

#include <vector>

#include "core/replacing/replacement.h"

namespace tessera {

class Replacer {
 public:
  virtual ~Replacer() = default;

  /// The number of windows that may be worked on at a time.
  virtual int breadth() const = 0;
  virtual void post_replace(std::vector<ReplacementWindow> windows) = 0;
  /// The outcomes stand in the order of the windows posted.
  virtual std::vector<ReplacementOutcome> take_replaced() = 0;
};

}  // namespace tessera
