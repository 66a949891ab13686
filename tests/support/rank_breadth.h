// Sets the number of cores for a test.
#pragma once

#include "core/base/rank_pool.h"

namespace tessera::test {

/// While an object of this class lives, this rank computes on the given number of cores, whatever the machine has.
class RankBreadth {
 public:
  explicit RankBreadth(int cores) : before_(rank_cores()) { rank_pool().resize(cores); }
  ~RankBreadth() { rank_pool().resize(before_); }
  RankBreadth(const RankBreadth&) = delete;
  RankBreadth& operator=(const RankBreadth&) = delete;

 private:
  int before_;
};

}  // namespace tessera::test
