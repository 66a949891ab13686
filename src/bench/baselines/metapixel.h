// The peer of mosaics: metapixel (Debian's package of that name), given the drawings of a library as its tiles.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <string>

#include "library/storage/library_file.h"

namespace tessera::bench {

/// Whether it can be started.
bool has_metapixel();

/// The tiles of a mosaic, on one ground: a folder of their own.
struct Tiles {
  std::string folder;     // of the drawings, and of what metapixel prepares of them
  std::size_t count = 0;  // of the drawings
};

/// Writes the library's drawings (their thumbnails) on this ground, "#rrggbb", into the folder, which is there and
/// empty. Throws InputError where there are none, EnvironmentError.
Tiles write_tiles(const LibraryFile& library, const std::string& ground, const std::string& folder);

/// How an image is divided into tiles, so that about so many of them come out.
struct TileGrid {
  int columns = 1;
  int rows = 1;
  int tile_px = 64;  // smaller where the mosaic would be too large to be read again
};
TileGrid tile_grid(cv::Size image_px, std::size_t pieces);

/// Writes the image as large as the mosaic will be, stretched to whole tiles, into the folder of the tiles; returns its
/// path. It is what the mosaic shows. Throws EnvironmentError.
std::string write_tiled_image(const cv::Mat& image_bgr, const TileGrid& grid, const Tiles& tiles);

/// Prepares the tiles and makes the mosaic of that image: the file `mosaic`. A drawing stands two tiles away from
/// itself, nearer where drawings are few. Throws EnvironmentError where metapixel fails.
void make_metapixel_mosaic(const Tiles& tiles, const std::string& image, const TileGrid& grid,
                           const std::string& mosaic);

}  // namespace tessera::bench
