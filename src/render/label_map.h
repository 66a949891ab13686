// Writes labels.png: which pixel of a collage's picture belongs to which piece.
#pragma once

#include <cstddef>
#include <functional>
#include <opencv2/core.hpp>

#include "render/pieces/shape_artworks.h"
#include "render/pieces/stop_watcher.h"
#include "result/collage_files.h"
#include "result/picture_file.h"

namespace tessera {

/// The format of the map: grey, as large as collage.png, with 8 bits where the numbers of the pieces fit into them,
/// otherwise 16. Throws InputError where there are more pieces than numbers of 16 bits.
PictureFormat label_format(const CollageReport& report);

/// Calls `take` with the map from top to bottom, some rows at a time. A pixel is 0 where its middle lies in no piece,
/// otherwise the number of the uppermost piece there, from 1 in the order of pieces.geojson. `artworks` tells how far
/// drawings reach.
void draw_labels(const CollageReport& report, const ShapeArtworks& artworks,
                 const std::function<void(const cv::Mat& rows)>& take);

/// Writes the map and finishes the file. Calls `progressed` with the number of rows written. Throws EnvironmentError and
/// DrawingStopped.
void write_labels(const CollageReport& report, const ShapeArtworks& artworks, PictureFile& file,
                  const StopWatcher& stop, const std::function<void(std::size_t rows)>& progressed);

}  // namespace tessera
