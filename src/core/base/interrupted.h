// How a question to the matcher ends that was given up before its answer came.
#pragma once

namespace tessera {

/// Thrown by whoever waits for an answer and is told to stop: by a signal, by the time limit, or because a rank that
/// owes the answer is lost. It is no error, hence no std::exception. The matcher that threw it must not be asked again.
struct Interrupted {
  const char* reason;  // a word that lives for ever: "signal", "time_limit" or "lost_rank"
};

}  // namespace tessera
