// The data that host and kernels exchange; both include this file, so that they cannot differ. Plain structs of 4-byte
// members (8-byte members first) without padding. The host takes the constants from core's headers; the kernels get
// them under the same names as build options (src/worker/devices/kernel_options.cpp).
#ifndef TESSERA_KERNELS_RECORDS_H
#define TESSERA_KERNELS_RECORDS_H

#ifdef __OPENCL_VERSION__
typedef uint u32;
typedef ulong u64;
#else
#include <cstdint>

#include "core/base/lanes.h"
#include "core/colour/colour_target.h"
#include "core/pad/pad.h"
#include "core/shape/shape_model.h"
#include "core/settings/tuning.h"

namespace tessera::worker {
using u32 = std::uint32_t;
using u64 = std::uint64_t;
#endif

// The kernels handle boundary points and interior points in 16 lanes (lanes.cl).
enum RecordSizes {
  kSmoothingLevelCount = 5,
  kFilterLanes = 64,  // PADs in a block of the index, boxes in a row
  kMaxKeypoints = 2 * kMaxPadLevels + 1,
  kMediumPoints = kBoundaryPoints / kMediumStride,
  kCoarsePoints = kBoundaryPoints / kCoarseStride,
  kCoarseInteriorPoints = (kMaxInteriorPoints / kInteriorStride + kLanes) / kLanes * kLanes,

  // The points of a shape as a structure of arrays, in shape units: all x, then all y of each set. The sketch is used
  // for the first, cheap test of a docking:
  kCoarseAt = 0,
  kCoarseInteriorAt = kCoarseAt + 2 * kCoarsePoints,
  kSketchFloats = kCoarseInteriorAt + 2 * kCoarseInteriorPoints,
  // The contour is used to make dockings and to refine them:
  kFineAt = 0,
  kTangentAt = kFineAt + 2 * kBoundaryPoints,  // of the fine points
  kMediumAt = kTangentAt + 2 * kBoundaryPoints,
  kInteriorAt = kMediumAt + 2 * kMediumPoints,
  kColourCellsAt = kInteriorAt + 2 * kMaxInteriorPoints,  // x, y, lightness, a, b and share of 16 cells
  kContourFloats = kColourCellsAt + 6 * kLanes
};

// A smoothing level in use: its PADs are [first, first + count) of each shape.
typedef struct LevelRecord {
  u32 first;
  u32 count;
  float scale_low_px;
  float scale_high_px;
} LevelRecord;

// The numbers that all kernels share, from MatchingContext, the shard and the field.
typedef struct MatchRecord {
  u64 seed;
  u32 beta_steps;
  float delta_px;
  float hard_depth_px;
  float max_scale_px;
  float gap_px;
  u32 first_shape;  // library index of the shard's first shape
  u32 shapes;       // in the shard
  u32 level_count;
  u32 sources;      // PADs of a shape
  int field_width;  // nodes
  int field_height;
  float field_origin_x;  // canvas px of node (0, 0)
  float field_origin_y;
  u32 size_width;  // SizeMap; 0: none
  u32 size_height;
  float size_cells_per_px;
  LevelRecord level[kSmoothingLevelCount];
} MatchRecord;

// ColourLevel
typedef struct ColourLevelRecord {
  u32 width;
  u32 height;
  u32 first;
  float texels_per_px;
} ColourLevelRecord;

// ColourWish, and its data on the device.
typedef struct ColourRecord {
  u32 levels;  // 0: the job wishes for no colours
  float weight;
  u32 near_words;  // NearColours
  ColourLevelRecord level[kMaxColourLevels];
} ColourRecord;

// Stance
typedef struct StanceRecord {
  float min_scale_px;
  float max_scale_px;
  float log2_scale_ratio;
  float weight;
  float rotation_middle_x;  // DirectionRange of the poses
  float rotation_middle_y;
  float rotation_edge_x;
  float rotation_edge_y;
  float docked_edge_x;  // of docked_rotations, which have the same middle
  float docked_edge_y;
} StanceRecord;

// StanceList, of a class of shapes.
typedef struct StanceListRecord {
  u32 first;
  u32 count;
  float min_scale_px;
  float max_scale_px;
} StanceListRecord;

typedef struct ShapeRecord {
  float perimeter;
  float radius;
  float keypoint_step;
  float disc_x;  // centre of the largest disc inside
  float disc_y;
  float disc_radius;
  u32 interior_points;
  float mean_lightness;  // ColourModel
  float mean_a;
  float mean_b;
  float colour_cell;
} ShapeRecord;

// A target sample, in canvas px.
typedef struct SampleRecord {
  float position_x;
  float position_y;
  float tangent_x;
  float tangent_y;
  u32 edge;
  u32 pass;
  u32 reach;           // in steps; only nearer pairs are found
  float scale_length;  // of the interval that estimates the scale before the alignment
  float convexity;
  u32 element[kMaxPadElements];  // steps
  // From core/pad/pad_filter.h: allowed signs, PadWindow for the reach, ScaleWindow for each level in use.
  u32 signs;
  u32 pad_low[kMaxPadElements];
  u32 pad_high[kMaxPadElements];
  u32 scale_low[kSmoothingLevelCount];
  u32 scale_high[kSmoothingLevelCount];
  float chord_x;  // between the ends of level kChordLevel; it estimates the rotation before the alignment
  float chord_y;
  float keypoint_x[kMaxKeypoints];
  float keypoint_y[kMaxKeypoints];
  u32 near_list;  // NearColours
} SampleRecord;

// The chord of a PAD in the index, in steps of its shape's key points. The index has chords only where rotations are
// limited.
typedef struct ChordRecord {
  float x;
  float y;
} ChordRecord;

// Up to kFilterLanes nodes of the index, all of one level.
typedef struct RootRecord {
  u32 first_node;
  u32 level;
  u32 segment;  // of the library
} RootRecord;

// A block of the index and a target sample that may have pairs in it.
typedef struct BlockRecord {
  u32 sample;
  u32 block;
  u32 level;
} BlockRecord;

// PadPair of a target sample.
typedef struct PairRecord {
  u32 sample;
  u32 source;    // within the shard: shape in it * MatchRecord::sources + source of the shape
  u32 distance;  // steps
} PairRecord;

// Similarity
typedef struct PoseRecord {
  float a;
  float b;
  float tx;
  float ty;
} PoseRecord;

// Docking
typedef struct DockingRecord {
  u32 sample;
  u32 shape;
  u32 source;
  u32 stance;
  float key;
  PoseRecord canvas_from_shape;
} DockingRecord;

// DockingTerms
typedef struct TermsRecord {
  float matched_px;
  float overlap_px2;
  float gap_px2;
  float overlap_px4;
  float gap_px4;
  float colour_difference;
} TermsRecord;

// Extent
typedef struct ExtentRecord {
  float low_x;
  float low_y;
  float high_x;
  float high_y;
} ExtentRecord;

// The result of refinement. Everything except the pose and `feasible` is set only for feasible dockings.
typedef struct RefinedRecord {
  PoseRecord canvas_from_shape;
  TermsRecord terms;
  ExtentRecord extent;
  float perimeter;
  float radius;
  u32 feasible;
} RefinedRecord;

// The operations whose results are compared with IEEE 754.
enum ProbeOperation {
  kProbeProductAndSum,
  kProbeProductAndDifference,
  kProbeProduct,
  kProbeQuotient,
  kProbeRoot,
  kProbeSum,
  kProbeFromInt,
  kProbeFromUint,
  kProbeToInt,
  kProbeFloor
};

// An operation and the bits of its operands.
typedef struct ProbeRecord {
  u32 operation;
  u32 a;
  u32 b;
  u32 c;
} ProbeRecord;

#ifndef __OPENCL_VERSION__
}  // namespace tessera::worker
#endif
#endif
