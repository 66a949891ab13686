// Divides pictures into cells, to measure how a mosaic looks from afar (core/colour/seen_from_afar.h).
#pragma once

#include <opencv2/core.hpp>

#include "core/colour/seen_from_afar.h"
#include "core/field/canvas.h"
#include "result/picture_file.h"

namespace tessera {

/// The number of cells in which a mosaic is compared: one for each of its px, but about a million at most. That is ten for
/// each px of a picture of 100 px, so that the canvas' edge may lie anywhere in a px.
cv::Size comparison_cells(cv::Size mosaic_px);

/// Collects the rows of a picture while it is drawn, and writes no file.
class MosaicCells : public PictureFile {
 public:
  explicit MosaicCells(cv::Size picture_px);

  void write(const cv::Mat& rows) override;
  void finish() override {}

  /// The cells; to be called after the last row. Transparent parts become white, as on paper.
  Grid<Srgb> cells() const;

 private:
  AreaMeans means_;
};

/// The picture (straight BGRA, CV_8UC4) stretched over so many cells. The weight of a colour is its alpha.
Grid<WeightedColour> cells_of_picture(const cv::Mat& straight_bgra, cv::Size cells);

/// The two pictures to compare: the opaque part of `picture`, and of that only the part on the canvas, if there is one.
/// Both have the same cells, which cover the canvas' bounding box.
PicturePair picture_pair(const Grid<Srgb>& mosaic, const Grid<WeightedColour>& picture, const Canvas* canvas);

/// The width of the canvas divided by the size of a mean piece. Where pieces fill the canvas evenly, it is their number in
/// a row.
double width_in_pieces(const Canvas& canvas, std::size_t pieces);

}  // namespace tessera
