// How work is begun that may go on beside the caller's.
#pragma once

#include <future>

namespace tessera {

/// For std::async: on a thread of its own where the system gives one; else the work is done when its result is asked
/// for. With std::launch::async alone a user's limit (ulimit -u, ulimit -v, containers, batch jobs) ends the program.
inline constexpr std::launch kWhereThreadsAre = std::launch::async | std::launch::deferred;

}  // namespace tessera
