// Makes the files of a mosaic from an image: its job, and the pictures that the job names, sizes and regions.
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
  std::vector<std::string> libraries;  // at least one
  std::string job;                     // the file to write
  std::string salient;                 // a grey picture, white where pieces shall be smallest; empty: finds faces
  std::string face_cascade;            // see face_search.h; without this file no faces are searched
  std::size_t shapes = 0;              // in all libraries, which are not read here
  int pieces = 3000;
  double shift = 6;      // CIEDE2000
  int regions = 6;       // at most, by the image's colours; 1: pieces may lie anywhere
  bool replace = false;  // replace files of these names that belong to another mosaic
};

struct MosaicFile {
  std::string path;
  std::vector<std::uint8_t> bytes;
};

struct Mosaic {
  MosaicPlan plan;
  std::optional<int> faces;       // number of faces found; empty: not searched
  int regions = 0;                // 0: none wanted, or the image has no large parts of different colours
  std::vector<MosaicFile> files;  // the job is the last
};

/// The path of the size map: portrait_sizes.png beside portrait.toml.
std::string size_map_path(const std::string& job);

/// The path of the picture of regions: portrait_regions.png beside portrait.toml.
std::string region_picture_path(const std::string& job);

/// Makes the mosaic and writes nothing. Paths in the job are relative to its folder where the request's paths are relative.
/// Throws InputError where the image or a path is unusable, or where a file with other content is there (with `replace`:
/// one that does not belong to a mosaic); EnvironmentError.
Mosaic make_mosaic(const MosaicRequest& request, Drawers& drawers);

/// Writes all files, each whole or not at all; files with the same content stay. Returns the paths of the files that are
/// new. Throws EnvironmentError.
std::vector<std::string> write_mosaic(const Mosaic& mosaic);

}  // namespace tessera
