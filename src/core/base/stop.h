// Why a run ends, and how long work is asked to stop.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

namespace tessera {

/// Why a run ended.
enum class StopReason : std::uint8_t {
  full,     // nothing more fits
  used_up,  // no shape may be placed once more
  pieces,   // the limits of the job's [stop]
  coverage,
  seconds,
  signal,  // the interruptions: there is more to do
  time_limit,
  lost_rank,
};

inline constexpr std::array kStopReasons = {StopReason::full,       StopReason::used_up,  StopReason::pieces,
                                            StopReason::coverage,   StopReason::seconds,  StopReason::signal,
                                            StopReason::time_limit, StopReason::lost_rank};

/// Its word in files and tables: "used_up".
std::string_view stop_word(StopReason reason);
/// The reason of that word; nothing: there is no such word.
std::optional<StopReason> stop_reason_of(std::string_view word);
/// Whether it ended a run that has more to do.
bool is_interruption(StopReason reason);

/// Thrown by whoever works or waits for long and is told to stop; `reason` is an interruption. It is no error, hence no
/// std::exception. Whoever was asked a question that ended so must not be asked again.
struct Interrupted {
  StopReason reason;
};

/// Answers whether work is to stop, and why; nothing: it goes on.
using StopQuestion = std::function<std::optional<StopReason>()>;

/// Long work calls it again and again, so that it can stop soon. It throws what the caller of that work catches, most
/// often Interrupted.
using StopCheck = std::function<void()>;
inline void never_stop() {}
/// Throws Interrupted where the question is answered with a reason.
StopCheck stop_check(StopQuestion question);

}  // namespace tessera
