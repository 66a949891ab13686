#include "comm/rank_watch.h"

#include <algorithm>
#include <cmath>

namespace tessera::comm {
namespace {

std::string seconds_text(double seconds) { return std::to_string(std::lround(seconds)) + " s"; }

}  // namespace

RankWatch::RankWatch(int ranks, double silence_s) : silence_s_(silence_s), seen_(std::size_t(ranks) - 1) {}

void RankWatch::waited(double seconds) {
  const double counted_s = std::min(seconds, kMostAtOnce_s);
  clock_s_ += counted_s;
  this_wait_s_ += counted_s;
}

void RankWatch::heard(int rank, const Heartbeat& beat) { seen_.at(std::size_t(rank) - 1) = {clock_s_, beat}; }

bool RankWatch::all_wait() const {
  return std::all_of(seen_.begin(), seen_.end(),
                     [this](const Seen& seen) { return seen.beat.waiting && seen.beat.for_s > silence_s_; });
}

std::optional<RankWatch::Lost> RankWatch::lost() const {
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const Seen& seen = seen_[i];
    const double silent_s = clock_s_ - seen.at_s;
    if (silent_s > silence_s_) return Lost{int(i) + 1, "has not been heard of for " + seconds_text(silent_s)};
    if (!seen.beat.waiting && seen.beat.for_s > kMostBusy * silence_s_) {
      return Lost{int(i) + 1, "has been busy with one request for " + seconds_text(seen.beat.for_s)};
    }
  }
  if (this_wait_s_ > silence_s_ && all_wait()) {
    return Lost{0, "all workers and the master have waited for a message for " + seconds_text(this_wait_s_) +
                       ": it was lost on the way"};
  }
  return {};
}

}  // namespace tessera::comm
