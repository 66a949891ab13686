// Replacement trials on another rank and on the ranks below it.
#pragma once

#include <vector>

#include "comm/communicator.h"
#include "core/replacing/replacer.h"

namespace tessera::comm {

class RemoteReplacer : public Replacer {
 public:
  /// `worker` (worker_server.h) and the ranks below it work on `breadth` windows at a time. The communicator must
  /// outlive the replacer.
  RemoteReplacer(Communicator& ranks, int worker, int breadth);

  int breadth() const override { return breadth_; }
  void post_replace(std::vector<ReplacementWindow> windows) override;
  std::vector<ReplacementOutcome> take_replaced() override;

 private:
  Communicator& ranks_;
  int worker_;
  int breadth_;
};

}  // namespace tessera::comm
