// Which pixel of a collage's picture belongs to which piece: labels.png.
#pragma once

#include <cstddef>
#include <functional>
#include <opencv2/core.hpp>

#include "render/pieces/shape_artworks.h"
#include "render/pieces/stop_watcher.h"
#include "result/collage_files.h"
#include "result/picture_file.h"

namespace tessera {

/// Grey, as large as collage.png; 8 bits where the pieces' numbers fit into them, else 16. Throws InputError where
/// there are more pieces than numbers of 16 bits.
PictureFormat label_format(const CollageReport& report);

/// Hands out the map from top to bottom, some rows at a time: 0 where the middle of a pixel lies in no piece, else the
/// number of the uppermost piece that it lies in, from 1 in the order of pieces.geojson. `artworks` tells how far
/// drawings reach.
void draw_labels(const CollageReport& report, const ShapeArtworks& artworks,
                 const std::function<void(const cv::Mat& rows)>& take);

/// Writes it and finishes the file; `progressed(rows)` tells how many are written. Throws EnvironmentError and
/// DrawingStopped.
void write_labels(const CollageReport& report, const ShapeArtworks& artworks, PictureFile& file,
                  const StopWatcher& stop, const std::function<void(std::size_t rows)>& progressed);

}  // namespace tessera
