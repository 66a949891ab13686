// The ranks of tessera collage that search the library, a part of it each, on the devices of their node, and replace
// pieces on its cores.
#pragma once

#include <functional>
#include <memory>

#include "comm/communicator.h"
#include "core/base/stop.h"
#include "core/matching/matcher.h"
#include "core/ranks/rank_site.h"
#include "core/replacing/replacer.h"
#include "core/shape/shape_source.h"
#include "run/collage_problem.h"

namespace tessera {

/// A worker's life, from the master's job on. Leaves by JobEnded; throws InputError and EnvironmentError.
[[noreturn]] void run_collage_worker(comm::Communicator& ranks);

/// Rank 0's matcher, and where that rank runs.
struct SitedMatcher {
  std::unique_ptr<Matcher> matcher;
  RankSite site;
};

/// Of a run without workers: the whole library on this rank's devices. What asks to stop ends a question by
/// Interrupted.
SitedMatcher own_matcher(const CollageProblem& problem, const StopQuestion& shall_stop);

/// Of a run with workers, which do the matching: rank 0 has no devices then.
SitedMatcher workers_matcher(comm::Communicator& ranks);

/// The replacer of a run without workers: on all cores of this rank. What asks to stop ends a question by Interrupted.
/// The shapes outlive it.
std::unique_ptr<Replacer> own_replacer(ShapeSource& shapes, const StopQuestion& shall_stop);

}  // namespace tessera
