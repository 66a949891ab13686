// Every parameter of the algorithm that a job can set. Units stand in the names; defaults are those of the job format
// (docs/job-format.md). Fixed numbers are in core/settings/tuning.h.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/colour/colour_wish.h"
#include "core/geometry/size_map.h"
#include "core/pad/pad.h"
#include "core/settings/wishes.h"

namespace tessera {

struct PieceSettings {
  float min_scale_px = 20;  // size: square root of the area; the smallest that any wish allows
  float max_scale_px = 160;
  float min_rotation_rad = -3.14159265f;
  float max_rotation_rad = 3.14159265f;
  PoseWish several = {};     // if there are several intervals; empty: those from min to max
  int uses = 0;              // largest number of pieces of one shape; 0 = unlimited
  int least_uses = 0;        // each shape gets this number of pieces before any gets more, while there is room
  bool fit_all = false;      // sizes are relative: they are multiplied so that every shape finds its place
  float least_scale_px = 2;  // with fit_all: no piece becomes smaller than this
  float padding_px = 0;      // distance kept between pieces, and between pieces and the canvas' edge
  float apart_px = 0;        // distance kept between the outlines of pieces of one silhouette
  std::shared_ptr<const SizeMap> size_map = {};  // limits a shape's sizes from place to place; empty: no limits
  float overlap_px = 1.4f;  // without padding: largest depth of a vertex in another piece, and beyond the edge

  /// The poses that are allowed where no shape or region wishes otherwise.
  PoseWish poses() const {
    PoseWish wish = several;
    if (wish.scale_px.empty()) wish.scale_px = {{min_scale_px, max_scale_px}};
    if (wish.rotation_rad.empty()) wish.rotation_rad = {{min_rotation_rad, max_rotation_rad}};
    return wish;
  }
};

/// The start of a collage.
struct StartSettings {
  bool grow_outward = false;  // pieces dock to standing pieces only, never to the canvas' edge
};

struct MatchSettings {
  PadParameters pad;
  float top_percent = 2;       // K of the paper: best pairs kept, in percent of all pairs of a target sample
  int most_pairs = 200;        // best pairs kept, however large the library; 0 = no limit
  float beta = 0.12f;          // largest PAD distance
  int tangent_dockings = 600;  // random tangent-aligned dockings per target sample
  float delta_px = 2.5f;       // a boundary point nearer than this to the boundary counts as matched
};

enum class Objective { scale_aware, paper };

struct ObjectiveSettings {
  Objective kind = Objective::scale_aware;
  float overlap_weight = 3;
  float gap_weight = 1;
  float length_exponent = 0.5f;
  float scale_exponent = 0.7f;
  float balance = 0;                 // of sizes, 0 (contrast) to 1 (even); for scale_aware only
  float repetition_exponent = 0.3f;  // score times (1 + uses)^-exponent; also the cost of copies in replacement
  float near_twin_factor = 0.7f;     // score times this for each near copy
};

struct StopSettings {
  int pieces = 0;      // 0 = no limit
  float coverage = 1;  // fraction of the canvas
  double seconds = 0;  // 0 = no limit
};

/// Improving, after no piece fits any more. Ends at the first limit that is reached. Both limits 0: no improving.
struct ImproveSettings {
  int trials = 0;      // 0 = no limit
  double seconds = 0;  // 0 = no limit
  bool relax = true;   // all pieces move, turn and grow together at the beginning, and again after many trials
};

enum class DeformKind { none, capped, voronoi };

/// Deformation of the finished collage: boundaries move to close gaps and overlaps (core/deform).
struct DeformSettings {
  DeformKind kind = DeformKind::none;
  /// Largest movement of a boundary, px, and as a fraction of the piece's size; the smaller one applies.
  float most_px = 4;
  float most_part = 0.06f;
  float most_area = 0.2f;  // largest change of a piece's area, as a fraction of it
  float most_pad = 0.2f;   // largest PAD distance of a piece to its shape before, the mean along its outline
};

struct CollageSettings {
  std::uint64_t seed = 1;
  PieceSettings pieces;
  Wishes wishes;
  StartSettings start;
  MatchSettings match;
  ObjectiveSettings objective;
  ImproveSettings improve;
  StopSettings stop;
  DeformSettings deform;
  ColourWish colour;
  bool settle = true;  // chosen pieces are pushed clear and grown; off for comparisons (src/bench), no job key
};

}  // namespace tessera
