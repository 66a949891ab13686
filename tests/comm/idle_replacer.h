// A worker's replacer for tests that use only matching.
#pragma once

#include <vector>

#include "core/replacing/replacer.h"

namespace tessera::comm::test {

/// Leaves every window as it is.
class IdleReplacer : public Replacer {
 public:
  int breadth() const override { return 1; }
  void post_replace(std::vector<ReplacementWindow> windows) override { windows_ = windows.size(); }
  std::vector<ReplacementOutcome> take_replaced() override { return std::vector<ReplacementOutcome>(windows_); }

 private:
  std::size_t windows_ = 0;
};

}  // namespace tessera::comm::test
