// tessera collage FOLDER: from drawings to a library and a job that suits them, which is then run as any job.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "run/collage_run.h"

namespace tessera::cli {

struct FirstCollageArguments {
  std::string source;  // a folder of drawings, or a library
  bool is_library = false;
  std::string job;                          // the file to write; empty: named like the source and the canvas
  std::string canvas;                       // SVG or image whose shape is filled; empty: a rectangle
  std::optional<std::vector<int>> size_px;  // width and height of the canvas, or of the box round its shape
};

/// The job of a first collage, in the working directory: named like the source and the canvas, so that the drawings in
/// a heart do not replace those in a rectangle. `first.job` where that is not empty.
std::string first_job_path(const FirstCollageArguments& first);

/// To be called on rank 0 alone. Builds the library out/NAME.h5 of a folder and writes `collage.job`. Says on stdout what it did,
/// unless `collage.quiet`. Throws InputError where the source, the canvas or an override is of no use, and where somebody has
/// changed the job; EnvironmentError.
void write_first_job(const FirstCollageArguments& first, const CollageArguments& collage);

}  // namespace tessera::cli
