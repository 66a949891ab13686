// The loop of the paper (section 4, Fig. 15): match, choose, merge, until nothing fits.
#pragma once

#include "core/canvas.h"
#include "core/matcher.h"
#include "core/placement.h"
#include "core/settings.h"
#include "core/shape_source.h"
#include "master/progress.h"

namespace tessera::master {

struct CollageResult {
  std::vector<Placement> placements;
  RunStatistics statistics;
};

/// `matcher` covers the whole library.
CollageResult make_collage(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher,
                           ShapeSource& shapes, Observer& observer);

}  // namespace tessera::master
