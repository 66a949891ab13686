// Turns a layout of a library's shapes into a job of tessera collage, which draws the artwork.
#pragma once

#include <string>

#include "products/nesting/nest_result.h"

namespace tessera {

struct NestJob {
  std::string toml;
  std::string pieces;  // geojson
};

/// The job of one sheet. `pieces_name`: the file of the pieces, in the job's folder.
NestJob nest_job(const NestRun& run, int sheet, const std::string& folder, const std::string& pieces_name);

}  // namespace tessera
