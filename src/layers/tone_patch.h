// Translucent colours that are laid over a piece, mostly faint, so that its colours come nearer to the picture beneath.
#pragma once

#include <array>
#include <opencv2/core.hpp>

#include "core/colour/colour_grid.h"

namespace tessera {

/// A grid of colours, interpolated linearly between the centres of cells; beyond the outermost centres they are
/// constant.
struct TonePatch {
  std::array<cv::Vec4b, kColourCells> bgra{};          // of the cells, row by row, straight alpha
  cv::Matx23d canvas_from_cells = {1, 0, 0, 0, 1, 0};  // canvas px; a cell is one unit, the grid begins at (0, 0)

  /// Whether all cells are transparent.
  bool empty() const;
  /// The mean of all cells, premultiplied.
  cv::Vec4d mean() const;
};

/// The patch as straight BGRA, one px a cell, with two more px of the edge's colours on each side. Drawn with smoothing
/// it has no visible edge inside the piece.
cv::Mat patch_picture(const TonePatch& patch);

/// Maps px of patch_picture to canvas px.
cv::Matx23d canvas_from_patch_picture(const TonePatch& patch);

/// Lays the patch over a part of a picture. `bgra` is premultiplied, its upper left pixel is `origin`, and a canvas px
/// is `picture_px` of its pixels wide. Transparent pixels stay transparent.
void lay_patch(const TonePatch& patch, cv::Point origin, double picture_px, cv::Mat& bgra);

}  // namespace tessera
