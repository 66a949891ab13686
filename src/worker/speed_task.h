// A small matching task on formula shapes, to measure the speed of devices: the questions of one round, about as long as
// those that a collage asks for one piece.
#pragma once

#include <vector>

#include "core/field/field_lookup.h"
#include "core/field/target_sample.h"
#include "core/matching/matcher.h"
#include "core/matching/matching_context.h"

namespace tessera::worker {

struct SpeedTask {
  MatchingContext context;
  std::vector<ShapeModel> models;
  CanvasField field;
  std::vector<TargetSample> samples;
};

/// Makes the task for PADs of these parameters, so that the kernels are those of the job.
SpeedTask make_speed_task(const PadParameters& pad);

/// Counts, docks and refines. The matcher cannot use what it remembers of earlier rounds.
void do_speed_task(Matcher& matcher, const SpeedTask& task);

}  // namespace tessera::worker
