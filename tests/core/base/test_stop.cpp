#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/base/stop.h"

namespace tessera {
namespace {

TEST(StopReasons, HaveEachAWordThatNamesIt) {
  std::set<std::string> words;
  for (const StopReason reason : kStopReasons) {
    words.emplace(stop_word(reason));
    EXPECT_EQ(stop_reason_of(stop_word(reason)), reason);
  }
  EXPECT_EQ(words.size(), kStopReasons.size());
  EXPECT_EQ(stop_word(StopReason::used_up), "used_up");
  EXPECT_EQ(stop_word(StopReason::lost_rank), "lost_rank");
  EXPECT_EQ(stop_reason_of("Full"), std::nullopt);
  EXPECT_EQ(stop_reason_of(""), std::nullopt);
}

TEST(StopReasons, ThreeAreInterruptions) {
  std::set<StopReason> interruptions;
  for (const StopReason reason : kStopReasons) {
    if (is_interruption(reason)) interruptions.insert(reason);
  }
  EXPECT_EQ(interruptions, (std::set{StopReason::signal, StopReason::time_limit, StopReason::lost_rank}));
}

TEST(StopCheck, ThrowsTheReason) {
  std::optional<StopReason> reason;
  const StopCheck check = stop_check([&] { return reason; });
  EXPECT_NO_THROW(check());
  reason = StopReason::time_limit;
  try {
    check();
    FAIL() << "went on";
  } catch (const Interrupted& interrupted) {
    EXPECT_EQ(interrupted.reason, StopReason::time_limit);
  }
}

}  // namespace
}  // namespace tessera
