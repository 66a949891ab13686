// Wishes: which shape may stand where, how large, how turned, and how often. A job's tables and lists are resolved to
// these once, by the names of the library's shapes and of the canvas' regions (job/pieces/wish_resolution.h).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry/similarity.h"
#include "core/shape/shape_id.h"

namespace tessera {

/// A closed interval; one value is an interval, too.
struct Interval {
  float min = 0;
  float max = 0;

  friend bool operator==(const Interval&, const Interval&) = default;
};

/// Allowed poses. An empty list means: as the more general wish says.
struct PoseWish {
  std::vector<Interval> scale_px;
  std::vector<Interval> rotation_rad;  // clockwise

  friend bool operator==(const PoseWish&, const PoseWish&) = default;
};

/// Pieces of one company keep this distance from each other.
struct ApartWish {
  std::uint32_t company = 0;
  float distance_px = 0;  // between their outlines; 0: any

  friend bool operator==(const ApartWish&, const ApartWish&) = default;
};

/// A wish for all shapes of a class.
struct ShapeWish {
  PoseWish poses;
  float weight = 1;                     // factor of the score; 0: these shapes are never placed
  std::optional<int> uses;              // largest number of pieces of each shape; 0 = no limit; empty: the job's
  std::optional<int> least_uses;        // least number of pieces of each, while there is room; empty: the job's
  std::optional<ApartWish> apart;       // empty: pieces of one silhouette keep the job's distance
  bool deforms = true;                  // its pieces may be deformed (core/deform)
  std::vector<std::uint8_t> in_region;  // per region: whether these shapes may stand there; empty = everywhere

  friend bool operator==(const ShapeWish&, const ShapeWish&) = default;
};

struct RegionWish {
  PoseWish poses;

  friend bool operator==(const RegionWish&, const RegionWish&) = default;
};

/// A piece that stands before the first round.
struct GivenPiece {
  ShapeId shape{};
  Similarity canvas_from_shape;
  bool locked = true;    // stands to the end; otherwise improving may take it out
  bool for_good = true;  // a locked piece is locked in the result, too: later runs leave it where it is
  float score = 0;       // from an earlier collage in which it was placed, as in Placement
  float matched_px = 0;

  friend bool operator==(const GivenPiece&, const GivenPiece&) = default;
};

/// A piece that stood in the collage from which this one begins, and was taken out of it.
struct FormerPiece {
  ShapeId shape{};
  Similarity canvas_from_shape;

  friend bool operator==(const FormerPiece&, const FormerPiece&) = default;
};

struct Wishes {
  std::vector<ShapeWish> classes;             // empty: one class, without wishes
  std::vector<std::uint32_t> class_of_shape;  // per shape of the library; empty: all shapes are of class 0
  std::vector<RegionWish> regions;            // of the canvas, in the order of filling; empty: one region

  std::vector<GivenPiece> given;      // the locked pieces first
  std::vector<FormerPiece> not_back;  // no piece of such a piece's silhouette may lie where it lay (former_pieces.h)

  /// The number of given pieces that stand to the end.
  std::size_t locked() const {
    return std::size_t(std::count_if(given.begin(), given.end(), [](const GivenPiece& piece) { return piece.locked; }));
  }

  friend bool operator==(const Wishes&, const Wishes&) = default;
};

}  // namespace tessera
