// The main loop of a worker: it answers requests, together with the workers below it. It keeps only its part of the
// library, the field, recently used shapes, and the time that its answers took.
#pragma once

#include <memory>

#include "comm/communicator.h"
#include "core/matching/matcher.h"
#include "core/replacing/replacer.h"

namespace tessera::comm {

/// Tells the parent of this rank (core/ranks/worker_tree.h) which shapes the matcher has and how many windows the
/// replacer works on at a time. Then answers requests in their order until the job ends. Leaves by JobEnded, or by an
/// exception of matcher or replacer.
[[noreturn]] void serve(Communicator& ranks, std::unique_ptr<Matcher> matcher, std::unique_ptr<Replacer> replacer);

}  // namespace tessera::comm
