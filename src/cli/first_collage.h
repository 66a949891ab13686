// tessera collage FOLDER: makes a library of drawings and a job that suits them; the job then runs as any job.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "run/collage_run.h"

namespace tessera::cli {

struct FirstCollageArguments {
  std::string source;  // a folder of drawings, or a library
  bool is_library = false;
  std::string job;                          // the file to write; empty: named after the source and the canvas
  std::string canvas;                       // SVG or image whose silhouette is filled; empty: a rectangle
  std::optional<std::vector<int>> size_px;  // width and height of the canvas, or of the box round its silhouette
};

/// The path of the job of a first collage: `first.job`, or a file in the working directory. Its name contains the
/// source and the canvas, so that drawings in a heart do not replace the same drawings in a rectangle.
std::string first_job_path(const FirstCollageArguments& first);

/// Builds the library out/NAME.h5 of a folder and writes `collage.job`; for rank 0 only. Reports on stdout unless
/// `collage.quiet`. Throws InputError where the source, the canvas or an override cannot be used, and where somebody
/// has changed the job file; EnvironmentError.
void write_first_job(const FirstCollageArguments& first, const CollageArguments& collage);

}  // namespace tessera::cli
