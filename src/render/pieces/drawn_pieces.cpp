#include "render/pieces/drawn_pieces.h"

#include "core/geometry/extent.h"

namespace tessera {
namespace {

bool touches(const Canvas& canvas, const Outline& clip, const Similarity& canvas_from_shape) {
  if (clip.curves.empty()) return false;
  const Extent extent = extent_of(clip.curves.front(), canvas_from_shape);
  return extent.low.x < float(canvas.width_px) && extent.high.x > 0 && extent.low.y < float(canvas.height_px) &&
         extent.high.y > 0;
}

}  // namespace

std::vector<DrawnPiece> drawn_pieces(const CollageReport& report, const ShapeArtworks& artworks) {
  const Canvas& canvas = *report.canvas;
  std::vector<DrawnPiece> drawn;
  for (std::size_t piece = 0; piece < report.placements.size(); ++piece) {
    const Placement& placement = report.placements[piece];
    const Outline& clip = artworks.clip(report.shapes.slot_of(placement.shape));
    for (const Vec2 offset : canvas.period.offsets()) {
      Placement image = placement;
      image.canvas_from_shape = moved(placement.canvas_from_shape, offset);
      if (offset == Vec2{} || touches(canvas, clip, image.canvas_from_shape)) drawn.push_back({image, piece});
    }
  }
  return drawn;
}

}  // namespace tessera
