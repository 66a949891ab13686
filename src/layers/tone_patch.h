// Colours that are laid over a piece, most of them hardly seen, so that it comes nearer to the picture beneath it.
#pragma once

#include <array>
#include <opencv2/core.hpp>

#include "core/colour/colour_grid.h"

namespace tessera {

/// A grid of colours that change evenly from the middle of a cell to the next; beyond the outermost middles they stay.
struct TonePatch {
  std::array<cv::Vec4b, kColourCells> bgra{};          // of the cells, row by row, straight alpha
  cv::Matx23d canvas_from_cells = {1, 0, 0, 0, 1, 0};  // canvas px; a cell is a unit, the grid begins at (0, 0)

  /// Nothing would change.
  bool empty() const;
  /// Of all cells, premultiplied.
  cv::Vec4d mean() const;
};

/// The patch with a ring of the same colours round it, one px a cell: straight BGRA. Drawn smoothly it has no edge where
/// a piece is.
cv::Mat patch_picture(const TonePatch& patch);

/// Canvas px from px of patch_picture.
cv::Matx23d canvas_from_patch_picture(const TonePatch& patch);

/// Lays it over a part of a picture: `bgra` is premultiplied, its upper left pixel is `origin`, and a canvas px has
/// `picture_px`. What is transparent stays so.
void lay_patch(const TonePatch& patch, cv::Point origin, double picture_px, cv::Mat& bgra);

}  // namespace tessera
