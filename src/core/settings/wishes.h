// Wishes: which shape may stand where, how large and how turned, and how often. A job's tables and lists are resolved
// to this once, by the names of the library's shapes and of the canvas' regions (job/pieces/wish_resolution.h).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry/similarity.h"
#include "core/shape/shape_id.h"

namespace tessera {

/// Both ends belong to it; one value is an interval.
struct Interval {
  float min = 0;
  float max = 0;

  friend bool operator==(const Interval&, const Interval&) = default;
};

/// What a pose may be. An empty list: as the wish above it says.
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

/// Of all shapes of a class.
struct ShapeWish {
  PoseWish poses;
  float weight = 1;                     // of the score; 0: never
  std::optional<int> uses;              // at most so many of each shape; 0 = no limit; empty: as the job says
  std::optional<int> least_uses;        // at least so many of each, while there is room; empty: as the job says
  std::optional<ApartWish> apart;       // empty: those of one silhouette, as the job says
  bool deforms = true;                  // its pieces may be deformed (core/deform)
  std::vector<std::uint8_t> in_region;  // per region: whether they may stand there; empty = everywhere

  friend bool operator==(const ShapeWish&, const ShapeWish&) = default;
};

struct RegionWish {
  PoseWish poses;

  friend bool operator==(const RegionWish&, const RegionWish&) = default;
};

/// Stands before the first round.
struct GivenPiece {
  ShapeId shape{};
  Similarity canvas_from_shape;
  bool locked = true;    // stands to the end; else improving may take it out
  bool for_good = true;  // what is locked is so in the result, too: later runs leave it where it is
  float score = 0;       // of an earlier collage in which it was placed, as in Placement
  float matched_px = 0;

  friend bool operator==(const GivenPiece&, const GivenPiece&) = default;
};

/// Stood in the collage that this one begins from, and was taken out of it.
struct FormerPiece {
  ShapeId shape{};
  Similarity canvas_from_shape;

  friend bool operator==(const FormerPiece&, const FormerPiece&) = default;
};

struct Wishes {
  std::vector<ShapeWish> classes;             // empty: one class, without wishes
  std::vector<std::uint32_t> class_of_shape;  // per shape of the library; empty: all of class 0
  std::vector<RegionWish> regions;            // of the canvas, in the order in which they are filled; empty: one

  std::vector<GivenPiece> given;      // the locked ones first
  std::vector<FormerPiece> not_back;  // nothing of such a piece's silhouette comes in where it lay (former_pieces.h)

  /// So many of the given pieces stand to the end.
  std::size_t locked() const {
    return std::size_t(std::count_if(given.begin(), given.end(), [](const GivenPiece& piece) { return piece.locked; }));
  }

  friend bool operator==(const Wishes&, const Wishes&) = default;
};

}  // namespace tessera
