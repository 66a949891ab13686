// A small matching task on formula shapes, to measure devices by: the questions of a round, of about the kind and
// length that a collage asks for a piece.
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

/// For PADs of these parameters, so that the kernels are those of the job.
SpeedTask make_speed_task(const PadParameters& pad);

/// Counts, docks and refines. What the matcher remembers of the round before does not help.
void do_speed_task(Matcher& matcher, const SpeedTask& task);

}  // namespace tessera::worker
