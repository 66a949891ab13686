// A worker's life: it answers questions, by itself and by the workers below it, and keeps nothing but its part of the
// library, the field, the shapes that it needed lately, and how long the answers took.
#pragma once

#include <memory>

#include "comm/communicator.h"
#include "core/matching/matcher.h"
#include "core/replacing/replacer.h"

namespace tessera::comm {

/// Tells the rank that asks this one (core/ranks/worker_tree.h) which shapes the matcher has and how many windows the
/// replacer works on at a time, then answers in the order of the questions until the job ends. It leaves by JobEnded,
/// or by what one of the two throws.
[[noreturn]] void serve(Communicator& ranks, std::unique_ptr<Matcher> matcher, std::unique_ptr<Replacer> replacer);

}  // namespace tessera::comm
