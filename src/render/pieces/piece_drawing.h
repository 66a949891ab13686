// Draws one placed piece of a collage row by row from its sprite.
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

/// Rows are drawn so many at a time, beginning at multiples of it. So the picture's bytes do not depend on how it is
/// divided into bands of such rows.
inline constexpr int kStripRows = 64;

/// Drawings are warped at twice the picture's resolution and averaged. A warp without that either blurs or leaves jagged
/// edges. Images that have no more pixels than the picture are not.
inline constexpr int kSupersampling = 2;

struct PieceDrawing {
  std::size_t slot = 0;                 // of the drawn shape
  Similarity picture_from_artwork;      // px; of the artwork after mirroring
  std::optional<float> mirrored_at_px;  // x of the artwork's middle if it is mirrored
  PlacedCurves outline;                 // of the shape
  cv::Rect box;                         // of the picture; empty: the piece lies outside
  int sprite_side_px = 0;               // wanted side of the sprite
};

/// Maps px of the artwork to px of the picture, for a piece. `picture_px`: px of the picture for one px of the canvas.
Similarity picture_from_artwork(const Placement& placement, const Artwork& artwork, double picture_px);

/// `line_px`: width of the line along the outline, px of the picture. `picture_px`: px of the picture for one px of the
/// canvas. `shape` must outlive the result.
PieceDrawing make_piece_drawing(const Placement& placement, std::size_t slot, const Shape& shape, const Outline& clip,
                                double line_px, double picture_px, cv::Size picture);

/// The artwork in the rows [begin, end) of the box, counted in the picture. Both are multiples of kStripRows or an end of
/// the box. Premultiplied BGRA, as wide as the box.
cv::Mat draw_rows(const PieceDrawing& piece, const Sprite& sprite, int begin, int end);

/// Scales premultiplied BGRA by the coverage of each pixel: 0 to 255, CV_8U.
void cut_to(const cv::Mat& coverage, cv::Mat& bgra);

/// Lays premultiplied BGRA over a part of the picture of the same size (BGR, or premultiplied BGRA).
void lay_over(const cv::Mat& bgra, cv::Mat picture);

}  // namespace tessera
