// Writes the job file of a mosaic: few keys, each with a short explanation, to be edited by hand.
#pragma once

#include <string>
#include <vector>

#include "products/mosaic/mosaic_plan.h"

namespace tessera {

struct MosaicFiles {
  std::string image;
  std::vector<std::string> libraries;  // at least one
  std::string size_map;
  std::string regions;  // the picture of the regions; empty: none
};

/// The beginning of every job of mosaic_job(), which tells it from files of other kinds.
inline constexpr const char* kMosaicJobMark = "# A mosaic by tessera mosaic";

/// The text of the job. Paths are written as they are in `files`. `shift`: CIEDE2000. `regions`: the colours of the regions
/// in files.regions, "#rrggbb".
std::string mosaic_job(const MosaicFiles& files, const MosaicPlan& plan, const MosaicVariety& variety, double shift,
                       const std::vector<std::string>& regions = {});

}  // namespace tessera
