// Draws the picture in pixels for collage.png and collage.tiff: the placed artworks on the canvas. It works on all cores in
// bands of rows, so that memory does not grow with the picture.
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

/// The most memory that drawing may take. The picture's bytes do not depend on it.
struct PictureLimits {
  int band_rows = 512;  // rows drawn at a time at most; a multiple of kStripRows (piece_drawing.h)
  std::size_t sprite_bytes = std::size_t(320) << 20;  // as counted by SpriteCache
  std::size_t tile_bytes = std::size_t(96) << 20;     // for parts of pieces that later bands need
  // of one band, unless kStripRows rows have more; there are two bands
  std::size_t band_bytes = std::size_t(48) << 20;
};

/// Calls `take` with the picture from top to bottom, some rows at a time and from one thread at a time. The canvas region
/// has the background colour and the ground's tiles on it, the outside is white, and the rows are BGR, CV_8UC3. Without a
/// background everything is transparent that neither pieces nor the ground cover, and the rows are straight BGRA, CV_8UC4.
/// Pieces are drawn in order of placement and clipped only by the picture; the overlay is drawn over them within the canvas
/// region. Throws DrawingStopped.
void draw_picture(const CollageReport& report, ShapeArtworks& artworks, const PictureLimits& limits,
                  const std::function<void(const cv::Mat& rows)>& take);

/// The format of the picture's files.
PictureFormat picture_format(const CollageReport& report);

/// Writes the picture into each of the files and finishes them. Calls `progressed` with the number of rows written. Throws
/// EnvironmentError and DrawingStopped.
void write_picture(const CollageReport& report, ShapeArtworks& artworks, const std::vector<PictureFile*>& files,
                   const StopWatcher& stop, const std::function<void(std::size_t rows)>& progressed);

}  // namespace tessera
