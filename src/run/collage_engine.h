// The engine answers rank 0's questions of matching and replacing. It is made of the workers; where there are none, of
// rank 0's own devices and cores.
#pragma once

#include <memory>
#include <string>

#include "comm/communicator.h"
#include "core/base/stop.h"
#include "core/matching/matcher.h"
#include "core/matching/matching_context.h"
#include "core/matching/model_source.h"
#include "core/ranks/rank_site.h"
#include "core/replacing/replacer.h"
#include "core/shape/shape_source.h"
#include "run/collage_problem.h"
#include "worker/device_group.h"

namespace tessera {

struct CollageEngine {
  std::unique_ptr<Matcher> matcher;  // of the whole library
  std::unique_ptr<Replacer> replacer;
  RankSite site;  // of rank 0, with its devices where it matches itself
};

/// Without workers what asks to stop ends a question by Interrupted. The shapes outlive the engine.
CollageEngine engine_of(comm::Communicator& ranks, const CollageProblem& problem, ShapeSource& shapes,
                        const StopQuestion& shall_stop);

// A worker makes its matcher with these, too.

MatchingContext context_of(const CollageProblem& problem);
/// What matching needs of a device. The canvas' size is that of the job, whatever its file shows.
worker::DeviceNeeds needs_of(const Job& job, const ModelSource& models);
std::string host_name();

}  // namespace tessera
