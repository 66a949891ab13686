// Checks candidates on the present free field before one is chosen: computes their exact areas, and the pieces that they
// become. Many candidates are checked at a time, on all cores of the rank, before somebody asks for the answers.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "core/collage/exact_terms.h"
#include "core/collage/pool.h"
#include "core/shape/shape_source.h"
#include "master/choosing/settling.h"

namespace tessera::master {

/// The piece that a candidate becomes.
struct SettledPiece {
  bool fits = false;  // without this the rest says nothing
  Similarity canvas_from_shape;
  DockingTerms terms;  // along the contour
  ExactAreas areas;
};

/// areas() and settled() answer; compute_areas_ahead() and settle_ahead() change how long that takes, never the answers.
class PieceChecks {
 public:
  /// All arguments outlive the checks. `context`: has the present sizes and stances.
  PieceChecks(ShapeSource& shapes, const FreeField& free, const OpenedField& opened, const Settling& settling,
              const PieceSettings& pieces, const MatchingContext& context)
      : shapes_(shapes),
        free_(free),
        opened_(opened),
        settling_(settling),
        pieces_(pieces),
        context_(context) {}

  ExactAreas areas(const Candidate& candidate);
  SettledPiece settled(const Candidate& candidate);

  /// Whether areas() need not compute.
  bool knows_areas(const Candidate& candidate) const { return areas_.contains(key_of(candidate)); }
  void compute_areas_ahead(const std::vector<Candidate>& candidates);
  void settle_ahead(const std::vector<Candidate>& candidates);

  /// Forgets what a new piece changes. `stamped`: the nodes of the free field that it changed.
  void forget_near(const Shape& shape, const Similarity& canvas_from_shape, const Window& stamped);
  /// Forgets what depends on nodes or outlines within this window, because pieces or the opened field changed there.
  void forget(const Window& changed);
  void forget_all();

 private:
  /// Shape, stance and pose of a candidate, and the largest size that it may have, which jobs may lower from piece to piece.
  using Key = std::tuple<ShapeId, std::uint32_t, float, float, float, float, float>;
  template <class Answer>
  struct Known {
    Answer answer;
    Window read;  // the nodes on which the answer depends, and those of outlines
  };
  template <class Answer>
  using KnownAnswers = std::map<Key, Known<Answer>>;

  PoseRange poses_of(const Candidate& candidate) const;
  Key key_of(const Candidate& candidate) const;
  Known<ExactAreas> compute_areas(const Shape& shape, const Similarity& canvas_from_shape) const;
  Known<SettledPiece> settle(const Shape& shape, const ShapeModel& model, const Candidate& candidate) const;
  template <class Answer, class Compute>
  void compute_ahead(const std::vector<Candidate>& candidates, KnownAnswers<Answer>& known, Compute compute);

  ShapeSource& shapes_;
  const FreeField& free_;
  const OpenedField& opened_;
  const Settling& settling_;
  const PieceSettings& pieces_;
  const MatchingContext& context_;
  KnownAnswers<ExactAreas> areas_;
  KnownAnswers<SettledPiece> settled_;
};

}  // namespace tessera::master
