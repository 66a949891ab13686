// From an image to the files of a mosaic: its job, and beside it the pictures that the job names, sizes and regions.
#pragma once

#include <string>
#include <vector>

#include "io/drawing/drawers.h"
#include "io/mosaic/mosaic_plan.h"

namespace tessera::io {

struct MosaicRequest {
  std::string image;                   // JPEG, PNG, TIFF, WebP or BMP
  std::vector<std::string> libraries;  // one at least
  std::string job;                     // the file to write
  int pieces = 3000;
  double shift = 0;      // CIEDE2000
  int regions = 6;       // at most, by the image's colours; 1 = pieces may lie anywhere
  bool replace = false;  // another mosaic's files of these names
};

struct WrittenMosaic {
  MosaicPlan plan;
  std::vector<std::string> new_files;  // that were not there before
  int regions = 0;  // 0: the image has no parts of different colours that are large enough, or none were wanted
};

/// Of the job's name: portrait_sizes.png beside portrait.toml.
std::string size_map_path(const std::string& job);

/// portrait_regions.png beside portrait.toml.
std::string region_picture_path(const std::string& job);

/// Writes all of them, each whole or not at all; those that are there with the same content stay. Paths in the job are
/// relative to its folder where the request's are relative. Throws InputError where the image or a path is of no use,
/// and where a file of another content is there (with `replace`: one that is no mosaic's); EnvironmentError.
WrittenMosaic write_mosaic_files(const MosaicRequest& request, Drawers& drawers);

}  // namespace tessera::io
