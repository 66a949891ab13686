// A worker's life: it answers the master's questions from its own part of the library, and keeps nothing but that part,
// the field, and how long the answers took.
#pragma once

#include "comm/communicator.h"
#include "core/matcher.h"

namespace tessera::comm {

/// Tells rank 0 which shapes these are, then answers in the order of the questions, until the job ends: leaves by
/// JobEnded, or by what the matcher throws.
[[noreturn]] void serve(Communicator& ranks, Matcher& matcher);

}  // namespace tessera::comm
