// A layout of a library's shapes as a job of tessera collage, which draws the artwork itself.
#pragma once

#include <string>

#include "products/nesting/nest_result.h"

namespace tessera {

struct NestJob {
  std::string toml;
  std::string pieces;  // geojson
};

/// Of one sheet. `pieces_name`: the file of the pieces, in the job's folder.
NestJob nest_job(const NestRun& run, int sheet, const std::string& folder, const std::string& pieces_name);

}  // namespace tessera
