// A collage that is stopped between two rounds, so that a figure can show what the next round sees and does.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "bench/concepts/figure_sheet.h"
#include "bench/concepts/weighed_matcher.h"
#include "core/base/run_statistics.h"
#include "core/field/canvas.h"
#include "core/field/opened_field.h"
#include "core/field/target_curve.h"
#include "core/settings/settings.h"
#include "library/library_shapes.h"
#include "library/storage/library_file.h"
#include "master/collage.h"
#include "master/filling.h"

namespace tessera::bench::concepts {

class CollageStage {
 public:
  /// A rectangle without pieces, for pieces of these sizes. `library` outlives it.
  CollageStage(const LibraryFile& library, const std::string& devices_use, std::array<float, 2> scale_px);

  /// Places pieces until so many stand, or none fits. Then it ends the batch.
  void place(std::size_t pieces);

  const Canvas& canvas() const { return canvas_; }
  const CollageSettings& settings() const { return settings_; }
  const MatchingContext& context() const { return context_; }
  ShapeSource& shapes() { return shapes_; }
  /// The shape with its smoothing levels, which `shapes()` leaves in the library.
  Shape with_levels(ShapeId id) const;
  WeighedMatcher& matcher() { return *matcher_; }
  master::Collage& collage() { return collage_; }

  /// The middle of a square view of the canvas. It is `centre`, or as near to it as the view stays on the canvas.
  Vec2 middle_of_view(Vec2 centre, float view_px) const;
  /// The pieces and the canvas' edge.
  void draw(FigureSheet& sheet, const Similarity& sheet_from_canvas, const std::vector<Placement>& placements);
  void draw(FigureSheet& sheet, const Similarity& sheet_from_canvas) {
    draw(sheet, sheet_from_canvas, collage_.placements());
  }
  void draw_piece(FigureSheet& sheet, const Similarity& sheet_from_canvas, ShapeId shape,
                  const Similarity& canvas_from_shape, const Pen& pen);
  /// The outer boundary alone, by a few of its points: for very many pieces.
  void draw_roughly(FigureSheet& sheet, const Similarity& sheet_from_canvas, ShapeId shape,
                    const Similarity& canvas_from_shape, const Pen& pen);

 private:
  const LibraryFile& library_;
  Canvas canvas_;
  CollageSettings settings_;
  LibraryShapes shapes_;
  MatchingContext context_;
  std::unique_ptr<WeighedMatcher> matcher_;
  master::Collage collage_;
  RunStatistics statistics_;
  master::Filling filling_;
};

/// The target curve of a free field, as the master traces it.
struct TracedTarget {
  TracedTarget(const FreeField& free, const CollageSettings& settings);

  /// Brings it up to date after `changed` nodes of the free field.
  TargetCurve::Change update(const FreeField& free, const Window& changed);

  std::vector<TargetSample> samples() const;
  /// Closed polylines, canvas px, the free region on the left.
  std::vector<std::vector<Vec2>> contours(const FreeField& free) const;

  OpenedField opened;
  TargetCurve curve;
};

}  // namespace tessera::bench::concepts
