// Pictures as cells, for the measures of a mosaic that is seen from afar (core/colour/seen_from_afar.h).
#pragma once

#include <opencv2/core.hpp>

#include "core/colour/seen_from_afar.h"
#include "core/field/canvas.h"
#include "result/picture_file.h"

namespace tessera {

/// How many cells a mosaic of so many px is compared in: as many as it has px, and about a million at most. That is ten
/// for each px of 100 px, so that the canvas' edge may lie anywhere in one.
cv::Size comparison_cells(cv::Size mosaic_px);

/// Takes the rows of a picture while they are drawn, and writes no file.
class MosaicCells : public PictureFile {
 public:
  explicit MosaicCells(cv::Size picture_px);

  void write(const cv::Mat& rows) override;
  void finish() override {}

  /// After the last row. What is transparent is white, as on paper.
  Grid<Srgb> cells() const;

 private:
  AreaMeans means_;
};

/// Straight BGRA, CV_8UC4, stretched over so many cells. A colour's weight is its alpha.
Grid<WeightedColour> cells_of_picture(const cv::Mat& straight_bgra, cv::Size cells);

/// What is compared: all of the picture that is opaque and lies on the canvas, where there is one, else all that is
/// opaque. Both have the same cells, which cover the canvas' box.
PicturePair picture_pair(const Grid<Srgb>& mosaic, const Grid<WeightedColour>& picture, const Canvas* canvas);

/// How many times as wide as a piece of mean size the canvas is: with pieces that fill it evenly, their number in a
/// row.
double width_in_pieces(const Canvas& canvas, std::size_t pieces);

}  // namespace tessera
