// The shapes that may be placed at the moment (open shapes), and their sizes. Open are the stances of the present region,
// without shapes that are used up or find no place. With fit = "all" sizes leave room for the missing pieces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/collage/placement.h"
#include "core/collage/pool.h"
#include "core/matching/matching_context.h"
#include "core/settings/settings.h"
#include "core/shape/shape_source.h"
#include "master/rules/scoring.h"
#include "master/rules/shortage.h"

namespace tessera::master {

class OpenShapes {
 public:
  /// `context`: at size factor 1. The sizes in `pieces` are already multiplied by `size_factor`. `scoring` knows which
  /// pieces stand. It and `shapes` outlive this object.
  OpenShapes(const MatchingContext& context, const PieceSettings& pieces, const Scoring& scoring, ShapeSource& shapes,
             float size_factor);

  /// Begins a region of the canvas. The first `given` pieces of the collage stay to its end.
  void begin(std::uint32_t region, std::size_t given);
  std::size_t given() const { return given_; }

  /// Updates limits() for the pieces that stand; the result follows from these pieces alone. `shut_out`: the shapes that
  /// find no place for other reasons, ascending. `free_px2`: the free area of the canvas. Returns whether the limits have
  /// changed.
  bool update(const std::vector<ShapeId>& shut_out, double free_px2);

  const StanceLimits& limits() const { return limits_; }
  /// A number that changes with limits(), never 0.
  std::uint64_t version() const { return version_; }
  /// The context of matching within the limits.
  const MatchingContext& context() const { return context_; }
  /// The stances in which shapes may come in now.
  const StanceTable& stances() const { return context_.stances; }
  /// Whether the candidate's shape is open and its size within the limits. acceptance.h checks all else.
  bool allows(const Candidate& candidate) const;

  /// The shapes of which fewer pieces stand than the job wants at least, ascending.
  std::vector<ShapeId> missing() const;
  Shortage shortage() const;
  /// Whether any shape may still stand, by the uses that are left.
  bool may_go_on() const;

  /// The poses that a standing piece may have: those of its stance. Where no stance holds its pose, that pose alone.
  PoseRange poses_of(const Placement& placement) const;

 private:
  void limit(const StanceLimits& limits);
  float most_scale_for(const std::vector<ShapeId>& missing, double free_px2) const;

  MatchingContext context_;     // within the limits
  StanceTable all_stances_;     // at size factor 1
  StanceTable region_stances_;  // of the present region
  StanceLimits limits_;
  std::uint64_t version_ = 0;
  std::size_t given_ = 0;
  bool fit_all_;
  const Scoring& scoring_;
  ShapeSource& shapes_;
};

}  // namespace tessera::master
