#include "worker/shard/shard.h"

#include <cstddef>
#include <stdexcept>

namespace tessera::worker {
namespace {

static_assert(kSmoothingLevelCount == kSmoothingLevels.size());
static_assert(kBoundaryPoints % (kLanes * kMediumStride) == 0 && kBoundaryPoints % (kLanes * kCoarseStride) == 0);
static_assert(kMaxInteriorPoints % kLanes == 0);
static_assert(std::tuple_size_v<decltype(Pad::element)> == kMaxPadElements);
static_assert(std::tuple_size_v<Keypoints> == kMaxKeypoints);

void check_points(const ShapeModel& model) {
  if (model.interior.size() > kMaxInteriorPoints) throw std::logic_error("a shape model has too many points");
}

void check_levels(const MatchRecord& match, const ShapeModel& model) {
  bool fits = model.levels.size() == match.level_count;
  for (std::size_t k = 0; fits && k < model.levels.size(); ++k) {
    fits = model.levels[k].samples.size() == match.level[k].count;
  }
  if (!fits) throw std::logic_error("a shape model does not have the levels and samples of its matching context");
}

void append_level(IndexedPads& pads, const ModelLevel& level, const IndexKind& kind) {
  for (const ModelSample& sample : level.samples) {
    pads.pads.push_back({sample.pad, sample.scale_length, sample.convexity});
    if (!kind.with_chords) continue;
    const Vec2 across = chord(sample, kind.pad_levels);
    pads.chords.push_back({across.x, across.y});
  }
}

/// Puts every stride-th point, all x and then all y, into a set with room for `room` points.
template <class Points>
void put_points(float* set, const Points& points, std::size_t stride, std::size_t room) {
  for (std::size_t i = 0, at = 0; i < points.size(); i += stride, ++at) {
    set[at] = points[i].x;
    set[room + at] = points[i].y;
  }
}

void put_colours(float* cells, const ColourModel& colour) {
  put_points(cells, colour.at, 1, kColourCells);
  for (std::size_t i = 0; i < kColourCells; ++i) {
    cells[2 * kColourCells + i] = colour.colour[i].lightness;
    cells[3 * kColourCells + i] = colour.colour[i].a;
    cells[4 * kColourCells + i] = colour.colour[i].b;
    cells[5 * kColourCells + i] = colour.part[i];
  }
}

/// Appends `count` zeros and returns the first of them.
float* append_floats(std::vector<float>& floats, std::size_t count) {
  floats.resize(floats.size() + count, 0.f);
  return floats.data() + floats.size() - count;
}

void append_sketch(std::vector<float>& sketches, const ShapeModel& model) {
  float* const sketch = append_floats(sketches, kSketchFloats);
  put_points(sketch + kCoarseAt, model.boundary, kCoarseStride, kCoarsePoints);
  put_points(sketch + kCoarseInteriorAt, model.interior, kInteriorStride, kCoarseInteriorPoints);
}

ShapeRecord shape_record(const ShapeModel& model) {
  const ColourModel& colour = model.colour;
  return {model.perimeter,
          model.radius,
          keypoint_step(model.radius),
          model.disc_centre.x,
          model.disc_centre.y,
          model.disc_radius,
          u32(model.interior.size()),
          colour.mean.lightness,
          colour.mean.a,
          colour.mean.b,
          colour.cell};
}

}  // namespace

void append_contour(std::vector<float>& contours, const ShapeModel& model) {
  float* const contour = append_floats(contours, kContourFloats);
  put_points(contour + kFineAt, model.boundary, 1, kBoundaryPoints);
  put_points(contour + kTangentAt, model.tangent, 1, kBoundaryPoints);
  put_points(contour + kMediumAt, model.boundary, kMediumStride, kMediumPoints);
  put_points(contour + kInteriorAt, model.interior, 1, kMaxInteriorPoints);
  put_colours(contour + kColourCellsAt, model.colour);
}

void append_keypoints(std::vector<std::int16_t>& keypoints, const ShapeModel& model, int pad_levels) {
  const std::size_t count = std::size_t(2 * pad_levels + 1);
  for (const ModelLevel& level : model.levels) {
    for (const ModelSample& sample : level.samples) {
      for (std::size_t i = 0; i < count; ++i) keypoints.push_back(sample.keypoint[i].x);
      for (std::size_t i = 0; i < count; ++i) keypoints.push_back(sample.keypoint[i].y);
    }
  }
}

MatchRecord make_match_record(const MatchingContext& c, const ShapeRange& shapes) {
  MatchRecord m{};
  m.seed = c.seed;
  m.beta_steps = c.beta_steps;
  m.delta_px = c.delta_px;
  m.hard_depth_px = c.hard_depth_px;
  m.first_shape = shapes.begin;
  m.shapes = shapes.end - shapes.begin;
  if (c.size_map) {
    m.size_width = u32(c.size_map->part.width());
    m.size_height = u32(c.size_map->part.height());
    m.size_cells_per_px = c.size_map->cells_per_px;
  }
  m.level_count = u32(c.levels.size());
  for (std::size_t k = 0; k < c.levels.size(); ++k) {
    const u32 count = u32(kSmoothingLevels[c.levels[k]].samples);
    m.level[k].first = m.sources;
    m.level[k].count = count;
    m.sources += count;
  }
  set_sizes(m, c);
  return m;
}

void set_sizes(MatchRecord& match, const MatchingContext& context) {
  match.max_scale_px = context.max_scale_px;
  match.gap_px = context.gap_px;
  for (std::size_t k = 0; k < context.level_range.size(); ++k) {
    match.level[k].scale_low_px = context.level_range[k].low;
    match.level[k].scale_high_px = context.level_range[k].high;
  }
}

Shard make_shard(const MatchRecord& match, const IndexKind& kind, const std::vector<ShapeModel>& models,
                 std::vector<LibraryPad> pads) {
  Shard shard;
  const bool have_levels = pads.empty();
  if (!have_levels && (kind.with_chords || pads.size() != models.size() * match.sources)) {
    throw std::logic_error("PADs of other shapes, or without the chords that they need");
  }
  shard.pads.pads = std::move(pads);
  shard.pads.pads.reserve(models.size() * match.sources);
  shard.sketches.reserve(models.size() * kSketchFloats);
  for (const ShapeModel& model : models) {
    check_points(model);
    if (have_levels) {
      check_levels(match, model);
      for (const ModelLevel& level : model.levels) append_level(shard.pads, level, kind);
    }
    append_sketch(shard.sketches, model);
    shard.shapes.push_back(shape_record(model));
  }
  return shard;
}

ShardBytes shard_bytes(const MatchingContext& context, std::size_t shapes, bool reads) {
  const MatchRecord match = make_match_record(context, {0, u32(shapes)});
  const HeldShapes held;
  const bool whole = !reads || held.holds_all(shapes);
  const std::size_t contours = whole ? shapes : held.contours;
  const std::size_t keypoints = whole ? shapes * match.sources * keypoint_numbers(context.pad.levels) : 0;
  BufferBytes buffers = index_bytes(match, index_kind(context));
  buffers.add(shapes * kSketchFloats * sizeof(float));
  buffers.add(shapes * sizeof(ShapeRecord));
  buffers.add(contours * kContourFloats * sizeof(float));
  return {.device = buffers.all, .host = keypoints * sizeof(std::int16_t), .largest_buffer = buffers.largest};
}

}  // namespace tessera::worker
