// The baseline for mosaics: metapixel (Debian's package of that name), with the drawings of a library as its tiles.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <string>

#include "library/storage/library_file.h"

namespace tessera::bench {

/// Whether metapixel can be started.
bool has_metapixel();

/// The tiles of a mosaic on one ground, in a folder of their own.
struct Tiles {
  std::string folder;     // with the drawings and metapixel's preparation of them
  std::size_t count = 0;  // number of drawings
};

/// Writes the library's drawings (their thumbnails) on this ground, "#rrggbb", into an existing empty folder. Throws
/// InputError where there are none, EnvironmentError.
Tiles write_tiles(const LibraryFile& library, const std::string& ground, const std::string& folder);

/// The division of an image into about the wanted number of tiles.
struct TileGrid {
  int columns = 1;
  int rows = 1;
  int tile_px = 64;  // smaller where the mosaic would be too large to read
};
TileGrid tile_grid(cv::Size image_px, std::size_t pieces);

/// Writes the image with the size of the mosaic, stretched to whole tiles, into the folder of the tiles; returns its
/// path. The mosaic shows this image. Throws EnvironmentError.
std::string write_tiled_image(const cv::Mat& image_bgr, const TileGrid& grid, const Tiles& tiles);

/// Prepares the tiles and makes the mosaic of that image as the file `mosaic`. Copies of a drawing are two tiles apart,
/// less where drawings are few. Throws EnvironmentError where metapixel fails.
void make_metapixel_mosaic(const Tiles& tiles, const std::string& image, const TileGrid& grid,
                           const std::string& mosaic);

}  // namespace tessera::bench
