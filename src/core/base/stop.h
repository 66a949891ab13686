// Reasons for which a run ends, and the check by which long work stops.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

namespace tessera {

/// The reason for which a run ended.
enum class StopReason : std::uint8_t {
  full,     // nothing more fits
  used_up,  // every shape has reached its largest number of uses
  pieces,   // the limits of the job's [stop]
  coverage,
  seconds,
  signal,  // the interruptions: the run has more to do
  time_limit,
  lost_rank,
};

inline constexpr std::array kStopReasons = {StopReason::full,       StopReason::used_up,  StopReason::pieces,
                                            StopReason::coverage,   StopReason::seconds,  StopReason::signal,
                                            StopReason::time_limit, StopReason::lost_rank};

/// The reason's word in files and tables: "used_up".
std::string_view stop_word(StopReason reason);
/// The reason with that word; empty: there is no such word.
std::optional<StopReason> stop_reason_of(std::string_view word);
/// Whether the reason interrupted a run that has more to do.
bool is_interruption(StopReason reason);

/// Thrown by work or a wait that is told to stop; `reason` is an interruption. It is not an error, so it is not a
/// std::exception. A matcher or replacer whose question ended so must not be asked again.
struct Interrupted {
  StopReason reason;
};

/// Tells whether work must stop, and why; empty: it goes on.
using StopQuestion = std::function<std::optional<StopReason>()>;

/// A function that long work calls regularly, so that it can stop soon. It throws an exception that the caller of that
/// work catches, mostly Interrupted.
using StopCheck = std::function<void()>;
inline void never_stop() {}
/// A check that throws Interrupted if the question returns a reason.
StopCheck stop_check(StopQuestion question);

}  // namespace tessera
