// The free region: the part of the canvas that is not yet covered. Every piece is docked to its boundary, from inside.
#pragma once

#include <cstdint>

#include "core/field/canvas.h"
#include "core/field/field_lookup.h"
#include "core/geometry/periodic_grid.h"
#include "core/geometry/similarity.h"
#include "core/settings/settings.h"
#include "core/shape/shape.h"

namespace tessera {

class StoredDepth;
class PieceDistance;

/// Canvas nodes (see CanvasField) whose pixels the piece and a rim of `margin_px` around it can touch; not clipped to
/// the canvas.
Window piece_window(const Outline& outline, const Similarity& canvas_from_shape, Vec2 origin, float margin_px);

/// The nodes of the free field: the canvas' own nodes, and on seamless sides as many images as pieces and look-ups
/// reach.
PeriodicGrid free_field_grid(const Canvas& canvas, const PieceSettings& pieces);

/// Signed distance to the free region's boundary, px, positive inside. It is exact up to stamp_band_px from a piece and
/// everywhere near the canvas' edge; elsewhere it is a bound that says "far". Within pieces of lines it falls faster
/// (StoredDepth). On a seamless canvas it repeats exactly, and windows stand for all of their images.
class FreeField {
 public:
  FreeField(const Canvas& canvas, const PieceSettings& pieces);

  const CanvasField& field() const { return field_; }
  const PeriodicGrid& grid() const { return grid_; }
  FieldView view() const { return FieldView(field_); }
  /// The distance to the edge of the canvas without pieces, positive inside, less the padding.
  FieldView canvas_view() const;
  float padding_px() const { return padding_px_; }
  /// A look-up in canvas_view(), but without the padding and with its gradient.
  FieldSample canvas_sample(Vec2 canvas_px) const;
  /// Whether the canvas has zones that pieces keep out of. A zone may be smaller than a piece.
  bool has_zones() const { return has_zones_; }

  /// Takes the piece out of the region: d = min(d, distance to the piece - padding). Returns the nodes that changed.
  Window stamp(const Shape& shape, const Similarity& canvas_from_shape);

  /// The nodes that stamp() may change.
  Window stamp_window(const Shape& shape, const Similarity& canvas_from_shape) const;
  /// Stamps the piece at the nodes in `window` only. Together with clear() this removes pieces: clear their windows,
  /// then stamp the remaining pieces there.
  Window stamp(const Shape& shape, const Similarity& canvas_from_shape, const Window& window);
  void clear(const Window& window);

  /// Area of the free region of one period, padding included, in 1/256 px². Exact: it does not depend on the order in
  /// which pieces came and went.
  std::int64_t free_256ths_px2() const { return free_256ths_px2_; }

 private:
  std::int64_t node_256ths_px2(float distance_px) const;
  Window stamp_part(const PieceDistance& piece, const StoredDepth& held, const Window& part);

  PeriodicGrid grid_;
  Grid<float> empty_;  // the field of the canvas without pieces
  CanvasField field_;
  float padding_px_;
  float hard_depth_px_;
  float band_px_;
  bool has_zones_;
  std::int64_t free_256ths_px2_ = 0;
};

}  // namespace tessera
