// A worker's life: it answers questions from its own part of the library and those of the workers below it, and keeps
// nothing but its part, the field, and how long the answers took.
#pragma once

#include <memory>

#include "comm/communicator.h"
#include "core/matching/matcher.h"

namespace tessera::comm {

/// Tells the rank that asks this one (core/ranks/worker_tree.h) which shapes these are, then answers in the order of
/// the questions until the job ends. It leaves by JobEnded, or by what the matcher throws.
[[noreturn]] void serve(Communicator& ranks, std::unique_ptr<Matcher> matcher);

}  // namespace tessera::comm
