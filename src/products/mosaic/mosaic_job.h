// The job file of a mosaic: few keys, each with a word on what it does, to be edited by hand.
#pragma once

#include <string>
#include <vector>

#include "products/mosaic/mosaic_plan.h"

namespace tessera {

struct MosaicFiles {
  std::string image;
  std::vector<std::string> libraries;  // one at least
  std::string size_map;
  std::string regions;  // the picture of them; empty = none
};

/// How every job of mosaic_job begins, which tells it from files of other kinds.
inline constexpr const char* kMosaicJobMark = "# A mosaic by tessera mosaic";

/// Paths are written as they are in `files`. `shift`: CIEDE2000. `regions`: their colours in files.regions, "#rrggbb".
std::string mosaic_job(const MosaicFiles& files, const MosaicPlan& plan, const MosaicVariety& variety, double shift,
                       const std::vector<std::string>& regions = {});

}  // namespace tessera
