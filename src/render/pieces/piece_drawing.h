// One piece of a collage as it lies in the picture, drawn row by row from its sprite.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <optional>

#include "core/collage/placement.h"
#include "core/geometry/polygon.h"
#include "core/geometry/similarity.h"
#include "core/shape/shape.h"
#include "render/pieces/cairo_paint.h"
#include "render/pieces/sprite.h"

namespace tessera {

/// Rows are drawn so many at a time, from multiples of it: however a picture is divided into bands of such rows, its
/// bytes are the same.
inline constexpr int kStripRows = 64;

/// Pieces are warped at twice the picture's resolution and averaged: a warp alone either blurs or leaves jagged edges.
inline constexpr int kSupersampling = 2;

struct PieceDrawing {
  std::size_t slot = 0;                 // of the shape that is drawn
  Similarity picture_from_artwork;      // px; of the artwork as it stands after it was mirrored
  std::optional<float> mirrored_at_px;  // x of the artwork's middle, where it is mirrored
  PlacedCurves outline;                 // the shape's
  cv::Rect box;                         // of the picture; empty: the piece lies beside it
  int sprite_side_px = 0;               // wanted
};

/// `line_px` is the width of the line along the outline, px of the picture, of which `picture_px` are one px of the
/// canvas. `shape` must outlive what is returned.
PieceDrawing make_piece_drawing(const Placement& placement, std::size_t slot, const Shape& shape, const Outline& clip,
                                double line_px, double picture_px, cv::Size picture);

/// The artwork in rows [begin, end) of the box, counted in the picture; both are multiples of kStripRows or an end of
/// the box. Premultiplied BGRA, as wide as the box.
cv::Mat draw_rows(const PieceDrawing& piece, const Sprite& sprite, int begin, int end);

/// Leaves of premultiplied BGRA as much of each pixel as is covered: 0 to 255, CV_8U.
void cut_to(const cv::Mat& coverage, cv::Mat& bgra);

/// Lays premultiplied BGRA over a part of the picture of the same size: BGR, or premultiplied BGRA.
void lay_over(const cv::Mat& bgra, cv::Mat picture);

}  // namespace tessera
