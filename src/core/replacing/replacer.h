// Who runs replacement trials: this rank's cores, or other ranks. A question is posted, then taken.
#pragma once

#include <vector>

#include "core/replacing/replacement.h"

namespace tessera {

class Replacer {
 public:
  virtual ~Replacer() = default;

  /// So many windows may be worked on at a time.
  virtual int breadth() const = 0;
  virtual void post_replace(std::vector<ReplacementWindow> windows) = 0;
  /// The outcomes stand in the order of the windows posted.
  virtual std::vector<ReplacementOutcome> take_replaced() = 0;
};

}  // namespace tessera
