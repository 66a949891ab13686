// Makes the matcher and the replacer of the loop. On rank 0 they ask the workers, or use its own devices and cores where
// there are none. A worker makes its own with own_matchers(), too.
#pragma once

#include <memory>

#include "comm/communicator.h"
#include "core/base/stop.h"
#include "core/matching/matcher.h"
#include "core/ranks/rank_site.h"
#include "core/replacing/replacer.h"
#include "core/shape/shape_source.h"
#include "run/collage_problem.h"
#include "worker/devices/opencl_devices.h"

namespace tessera {

struct LoopMatchers {
  std::unique_ptr<Matcher> matcher;
  std::unique_ptr<Replacer> replacer;
  RankSite site;  // of this rank, with its devices if it matches itself
};

/// Makes the matchers of rank 0, which cover the whole library. Without workers a reason to stop ends a question by
/// Interrupted. The shapes outlive the matchers.
LoopMatchers gather_matchers(comm::Communicator& ranks, const CollageProblem& problem, ShapeSource& shapes,
                             const StopQuestion& shall_stop);

/// Makes matchers for `part` of the library on this rank's `share` of its node's devices, and for replacing on the rank's
/// cores. `check_stop` may throw to give a question up. The shapes outlive the matchers.
LoopMatchers own_matchers(const CollageProblem& problem, ShapeSource& shapes, const ShapeRange& part,
                          const worker::DeviceShare& share, const StopCheck& check_stop);

/// Compiles the kernels that own_matchers() needs, unless the cache on disk has them.
void compile_kernels(const CollageProblem& problem);

}  // namespace tessera
