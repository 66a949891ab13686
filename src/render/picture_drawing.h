// The picture in pixels, for collage.png and collage.tiff: the artworks as placed, on the canvas. It is drawn in bands
// of rows, so that memory does not grow with the picture, on all cores.
#pragma once

#include <cstddef>
#include <functional>
#include <opencv2/core.hpp>
#include <vector>

#include "render/pieces/shape_artworks.h"
#include "render/pieces/stop_watcher.h"
#include "result/collage_files.h"
#include "result/picture_file.h"

namespace tessera {

/// How much memory drawing may take. The picture's bytes do not depend on it.
struct PictureLimits {
  int band_rows = 512;  // drawn at a time at most; a multiple of kStripRows (piece_drawing.h)
  std::size_t sprite_bytes = std::size_t(320) << 20;  // as SpriteCache counts them
  std::size_t tile_bytes = std::size_t(96) << 20;     // of pieces that reach into later bands and wait for them
  std::size_t band_bytes = std::size_t(48) << 20;     // of a band, where kStripRows rows have no more; two are there
};

/// Hands out the picture from top to bottom, some rows at a time: `take` is called from one thread at a time. The
/// canvas region has the background colour and on it the ground's tiles, what lies outside it is white, and the rows
/// are BGR, CV_8UC3; without a background all that neither pieces nor the ground cover is transparent, and the rows are
/// straight BGRA, CV_8UC4. Pieces are drawn in order of placement and clipped by the picture only, and the overlay over
/// them within the canvas region. Throws DrawingStopped.
void draw_picture(const CollageReport& report, ShapeArtworks& artworks, const PictureLimits& limits,
                  const std::function<void(const cv::Mat& rows)>& take);

/// What the files of that picture are made with.
PictureFormat picture_format(const CollageReport& report);

/// Writes it into each of the files and finishes them; `progressed(rows)` tells how many are written. Throws
/// EnvironmentError and DrawingStopped.
void write_picture(const CollageReport& report, ShapeArtworks& artworks, const std::vector<PictureFile*>& files,
                   const StopWatcher& stop, const std::function<void(std::size_t rows)>& progressed);

}  // namespace tessera
