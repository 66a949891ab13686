#include "core/deform/deformation.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

#include "core/base/rank_pool.h"
#include "core/deform/boundary_map.h"
#include "core/deform/piece_deformer.h"
#include "core/field/field_lookup.h"

namespace tessera {
namespace {

/// Rounds of steps; each closes half of the remaining distance.
constexpr int kRounds = 12;
constexpr int kVoronoiRounds = 24;  // each moves 2 px at most
/// Rounds in which overlapping pieces move back afterwards.
constexpr int kClearingRounds = 4;
/// Clearing rounds with a wished gap: distance that is cleared here, with a small margin, need not be taken from whole pieces
/// later.
constexpr int kGapClearingRounds = 12;
constexpr float kGapMargin_px = 0.05f;
/// Rounds in which pieces nearer to each other than the wished gap are deformed less. After these, such pieces lose
/// their deformation, and so do pieces that are then too near to them.
constexpr int kGapRounds = 12;

/// The edge of the region that the piece lies in, or of the whole canvas.
FieldView edge_round(const Canvas& canvas, Vec2 centre_px) {
  const CanvasField* edge = &canvas.distance;
  float deepest = 0;
  for (const CanvasRegion& region : canvas.regions) {
    const float depth = field_value(FieldView(region.distance), centre_px);
    if (depth <= deepest) continue;
    deepest = depth;
    edge = &region.distance;
  }
  return FieldView(*edge);
}

class Deformation {
 public:
  Deformation(const Canvas& canvas, const std::vector<DeformablePiece>& pieces, const DeformSettings& settings,
              const PadParameters& pad, float gap_px)
      : canvas_(canvas),
        pieces_(pieces),
        settings_(settings),
        gap_px_(gap_px),
        deformers_(pieces.size()),
        outlines_px_(pieces.size()) {
    for (const DeformablePiece& piece : pieces)
      edges_.push_back(edge_round(canvas, piece.canvas_from_shape.translation()));
    parallel_for(pieces.size(), [&](std::size_t i) {
      deformers_[i] = std::make_unique<PieceDeformer>(pieces[i], std::uint32_t(i), settings, pad);
    });
  }

  std::vector<DeformedPiece> run() {
    const BoundaryMap undeformed = map();
    each_moving([&](PieceDeformer& piece) { piece.set_limits(undeformed); });
    const int rounds = settings_.kind == DeformKind::voronoi ? kVoronoiRounds : kRounds;
    for (int round = 0; round < rounds; ++round) step(gap_px_, false);
    each_moving([](PieceDeformer& piece) { piece.grow_less(); });
    clear();
    const BoundaryMap last = map();
    each_moving([&](PieceDeformer& piece) {
      piece.undo_where_crossed(last);
      piece.weaken();
    });
    if (gap_px_ > 0) keep_gaps();
    std::vector<DeformedPiece> results(pieces_.size());
    parallel_for(pieces_.size(), [&](std::size_t i) { results[i] = deformers_[i]->result(); });
    return results;
  }

 private:
  void clear() {
    const bool keeps_gap = gap_px_ > 0;
    const int rounds = keeps_gap ? kGapClearingRounds : kClearingRounds;
    for (int round = 0; round < rounds; ++round) step(keeps_gap ? gap_px_ + kGapMargin_px : 0, true);
  }

  void step(float gap_px, bool clears) {
    const BoundaryMap now = map();
    parallel_for(pieces_.size(), [&](std::size_t i) {
      if (!pieces_[i].stays) deformers_[i]->step(now, edges_[i], gap_px, clears);
    });
  }

  void keep_gaps() {
    for (int round = 1; true; ++round) {
      const std::vector<std::uint8_t> gives_way = too_near();
      if (std::none_of(gives_way.begin(), gives_way.end(), [](std::uint8_t g) { return g != 0; })) return;
      parallel_for(pieces_.size(), [&](std::size_t i) {
        if (gives_way[i] == 0) return;
        if (round <= kGapRounds) {
          deformers_[i]->shrink();
        } else {
          deformers_[i]->undo();
        }
      });
    }
  }

  /// Tells for each piece whether it is deformed and nearer to another than the gap. Both pieces of a pair count: only
  /// one of them has the near point, but the other one may have moved.
  std::vector<std::uint8_t> too_near() {
    const BoundaryMap now = map();
    std::vector<std::vector<std::uint32_t>> others(pieces_.size());
    parallel_for(pieces_.size(), [&](std::size_t i) { others[i] = deformers_[i]->nearer_than(gap_px_, now); });
    std::vector<std::uint8_t> is_near(pieces_.size());
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      for (const std::uint32_t other : others[i]) is_near[i] = is_near[other] = 1;
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) is_near[i] = is_near[i] != 0 && deformers_[i]->is_deformed();
    return is_near;
  }

  BoundaryMap map() {
    parallel_for(pieces_.size(), [&](std::size_t i) { outlines_px_[i] = deformers_[i]->outline_px(); });
    return BoundaryMap(outlines_px_, canvas_.period);
  }

  template <class F>
  void each_moving(F f) {
    parallel_for(pieces_.size(), [&](std::size_t i) {
      if (!pieces_[i].stays) f(*deformers_[i]);
    });
  }

  const Canvas& canvas_;
  const std::vector<DeformablePiece>& pieces_;
  const DeformSettings& settings_;
  const float gap_px_;
  std::vector<std::unique_ptr<PieceDeformer>> deformers_;
  std::vector<FieldView> edges_;  // the edge that each piece keeps within
  std::vector<Outline> outlines_px_;
};

}  // namespace

std::vector<DeformedPiece> deformed_pieces(const Canvas& canvas, const std::vector<DeformablePiece>& pieces,
                                           const DeformSettings& settings, const PadParameters& pad, float gap_px) {
  return Deformation(canvas, pieces, settings, pad, gap_px).run();
}

}  // namespace tessera
