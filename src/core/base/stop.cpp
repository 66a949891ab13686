#include "core/base/stop.h"

#include <array>
#include <cstddef>
#include <utility>

namespace tessera {
namespace {

/// The words in the order of StopReason.
constexpr std::array<std::string_view, kStopReasons.size()> kWords = {"full",    "used_up", "pieces",     "coverage",
                                                                      "seconds", "signal",  "time_limit", "lost_rank"};

}  // namespace

std::string_view stop_word(StopReason reason) { return kWords[std::size_t(reason)]; }

std::optional<StopReason> stop_reason_of(std::string_view word) {
  for (const StopReason reason : kStopReasons) {
    if (stop_word(reason) == word) return reason;
  }
  return std::nullopt;
}

bool is_interruption(StopReason reason) { return reason >= StopReason::signal; }

StopCheck stop_check(StopQuestion question) {
  return [question = std::move(question)] {
    if (const std::optional<StopReason> reason = question()) throw Interrupted{*reason};
  };
}

}  // namespace tessera
