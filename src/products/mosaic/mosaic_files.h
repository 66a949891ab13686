// From an image to the files of a mosaic: its job, and beside it the pictures that the job names, sizes and regions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "products/mosaic/mosaic_plan.h"

namespace tessera {

struct MosaicRequest {
  std::string image;                   // JPEG, PNG, TIFF, WebP or BMP
  std::vector<std::string> libraries;  // one at least
  std::string job;                     // the file to write
  std::string salient;                 // a grey picture, white where pieces are to be smallest; empty: faces are found
  std::string face_cascade;            // face_search.h; without such a file no faces are looked for
  std::size_t shapes = 0;              // of all libraries, which are not read
  int pieces = 3000;
  double shift = 6;      // CIEDE2000
  int regions = 6;       // at most, by the image's colours; 1 = pieces may lie anywhere
  bool replace = false;  // another mosaic's files of these names
};

struct MosaicFile {
  std::string path;
  std::vector<std::uint8_t> bytes;
};

struct Mosaic {
  MosaicPlan plan;
  std::optional<int> faces;  // that were found; none where they were not looked for
  int regions = 0;  // 0: the image has no parts of different colours that are large enough, or none were wanted
  std::vector<MosaicFile> files;  // the job last
};

/// Of the job's name: portrait_sizes.png beside portrait.toml.
std::string size_map_path(const std::string& job);

/// portrait_regions.png beside portrait.toml.
std::string region_picture_path(const std::string& job);

/// Writes nothing. Paths in the job are relative to its folder where the request's are relative. Throws InputError where
/// the image or a path is of no use, and where a file of another content is there (with `replace`: one that is no
/// mosaic's); EnvironmentError.
Mosaic make_mosaic(const MosaicRequest& request, Drawers& drawers);

/// Writes all files, each whole or not at all; those that are there with the same content stay. Returns the paths of
/// those that were not there before. Throws EnvironmentError.
std::vector<std::string> write_mosaic(const Mosaic& mosaic);

}  // namespace tessera
