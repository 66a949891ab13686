#include "checkpoint/checkpoint_columns.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/settings/tuning.h"
#include "library/hdf5/hdf5_handles.h"

namespace tessera {
namespace {

constexpr std::size_t kLevels = kMaxPadLevels;
constexpr std::size_t kMaxJobBytes = 1 << 20;  // a job with every key and long paths has 5 KB
constexpr std::size_t kMatchedRow = 2 * kLevels + 1;

constexpr std::uint64_t RunStatistics::*kCounts[] = {
    &RunStatistics::shapes,          &RunStatistics::rounds,
    &RunStatistics::docking_choices, &RunStatistics::dockings_evaluated,
    &RunStatistics::refined,         &RunStatistics::target_samples,
    &RunStatistics::trials,          &RunStatistics::trials_kept};
constexpr double RunStatistics::*kMeasures[] = {
    &RunStatistics::pads_per_shape, &RunStatistics::prune_s,   &RunStatistics::dock_s, &RunStatistics::objective_s,
    &RunStatistics::merge_s,        &RunStatistics::improve_s, &RunStatistics::total_s};

void append(std::vector<float>& column, const Similarity& s) { column.insert(column.end(), {s.a, s.b, s.tx, s.ty}); }

Similarity pose_at(const std::vector<float>& column, std::size_t row) {
  const float* p = column.data() + 4 * row;
  return {p[0], p[1], p[2], p[3]};
}

void append_candidate(CheckpointColumns& to, const Candidate& c) {
  to.shape.push_back(index_of(c.shape));
  to.source.push_back(c.source);
  to.stance.push_back(c.stance);
  append(to.pose, c.canvas_from_shape);
  const DockingTerms& t = c.terms;
  to.terms.insert(to.terms.end(),
                  {t.matched_px, t.overlap_px2, t.gap_px2, t.overlap_px4, t.gap_px4, t.colour_difference});
  to.score.push_back(c.score);
  to.exact.push_back(c.exact);
  to.window.insert(to.window.end(), {c.window.x0, c.window.y0, c.window.x1, c.window.y1});
  to.shape_size.insert(to.shape_size.end(), {c.perimeter, c.radius});
}

Candidate candidate_at(const CheckpointColumns& from, std::size_t row) {
  Candidate c;
  c.shape = ShapeId{from.shape[row]};
  c.source = from.source[row];
  c.stance = from.stance[row];
  c.canvas_from_shape = pose_at(from.pose, row);
  const float* t = from.terms.data() + 6 * row;
  c.terms = {t[0], t[1], t[2], t[3], t[4], t[5]};
  c.score = from.score[row];
  c.exact = from.exact[row] != 0;
  const std::int32_t* w = from.window.data() + 4 * row;
  c.window = {w[0], w[1], w[2], w[3]};
  c.perimeter = from.shape_size[2 * row];
  c.radius = from.shape_size[2 * row + 1];
  return c;
}

void append_loop(CheckpointColumns& to, const CheckpointState& state) {
  to.improving.push_back(state.loop.phase != LoopPhase::filling);
  to.stage = {state.loop.region,
              state.given,
              state.sizes.attempt,
              std::uint32_t(state.sizes.over),
              std::uint32_t(state.begun_with),
              std::uint32_t(state.begun_with >> 32)};
  to.size_factors = {state.sizes.factor, state.sizes.too_large, state.sizes.fits, state.best.factor};
  to.best_missing = {state.best.missing};
  to.searches = {std::uint8_t(state.search), std::uint8_t(state.searched)};
  to.batch_pieces.push_back(state.batch_pieces);
  to.batch_worth.push_back(state.batch_worth);
  to.batch_taken = state.batch_taken;
  RunStatistics statistics = state.statistics;
  copy_to_statistics(statistics, state.loop);
  for (const auto count : kCounts) to.counts.push_back(statistics.*count);
  for (const auto measure : kMeasures) to.measures.push_back(statistics.*measure);
  to.replaced.push_back(state.loop.replaced);
}

void append_pieces(CheckpointColumns& to, const CheckpointState& state) {
  for (const Placement& p : state.placements) {
    to.placed_shape.push_back(index_of(p.shape));
    append(to.placed_pose, p.canvas_from_shape);
    to.placed_score.push_back(p.score);
    to.placed_matched.push_back(p.matched_px);
  }
  for (const Placement& p : state.loop.moving) {
    to.moving_shape.push_back(index_of(p.shape));
    append(to.moving_pose, p.canvas_from_shape);
    to.moving_score.push_back(p.score);
    to.moving_matched.push_back(p.matched_px);
  }
  for (const Placement& p : state.best.placements) {
    to.best_shape.push_back(index_of(p.shape));
    append(to.best_pose, p.canvas_from_shape);
    to.best_score.push_back(p.score);
    to.best_matched.push_back(p.matched_px);
  }
}

void append_pool(CheckpointColumns& to, const CheckpointState& state) {
  for (const PooledSample& sample : state.pool) {
    to.pool_edge.push_back(edge_number(sample.id));
    to.pool_truncated.push_back(sample.truncated);
    to.pool_candidates.push_back(std::uint32_t(sample.candidates.size()));
    for (const Candidate& c : sample.candidates) append_candidate(to, c);
  }
}

void append_samples(CheckpointColumns& to, const CheckpointState& state) {
  for (const SampleId id : state.stale) to.stale.push_back(edge_number(id));
  for (const SampleMatches& sample : state.matches)
    to.matches.insert(to.matches.end(), {edge_number(sample.id), sample.passes, sample.searches});
  for (const MatchedPad& pad : state.matched) {
    to.matched_edge.push_back(edge_number(pad.sample));
    to.matched_pad.insert(to.matched_pad.end(), pad.left.begin(), pad.left.end());
    to.matched_pad.insert(to.matched_pad.end(), pad.right.begin(), pad.right.end());
    to.matched_pad.push_back(pad.convexity);
  }
}

void require(bool holds, const std::string& what) {
  if (!holds) throw Hdf5Error("damaged: " + what);
}

template <class Number>
void require_finite(const std::vector<Number>& column, const char* name) {
  require(std::all_of(column.begin(), column.end(), [](Number v) { return std::isfinite(v); }),
          std::string(name) + ": a value is no number");
}

void require_flags(const std::vector<std::uint8_t>& column, const char* name) {
  require(std::all_of(column.begin(), column.end(), [](std::uint8_t v) { return v <= 1; }),
          std::string(name) + ": a value is out of range");
}

void require_ascending(const std::vector<std::uint32_t>& edges, const char* name) {
  require(std::adjacent_find(edges.begin(), edges.end(), std::greater_equal<>()) == edges.end(),
          std::string(name) + " does not ascend");
}

void check_values(const CheckpointColumns& c) {
  require(c.job.size() <= kMaxJobBytes, "/job is too long");
  require_finite(c.measures, "/statistics/measures");
  require(std::all_of(c.measures.begin(), c.measures.end(), [](double v) { return v >= 0; }),
          "/statistics/measures: a value is below 0");
  for (const auto* column : {&c.placed_pose, &c.placed_score, &c.placed_matched})
    require_finite(*column, "/placements");
  for (const auto* column : {&c.moving_pose, &c.moving_score, &c.moving_matched}) require_finite(*column, "/moving");
  for (const auto* column : {&c.size_factors, &c.best_pose, &c.best_score, &c.best_matched})
    require_finite(*column, "/sizes");
  require_finite(c.batch_worth, "/batch");
  require(c.batch_worth[0] >= 0, "/batch/worth: a value is out of range");
  require_flags(c.batch_taken, "/batch/taken");
  require(c.stage[3] <= 1, "/stage: a value is out of range");
  for (const auto* column : {&c.pose, &c.terms, &c.score, &c.shape_size}) require_finite(*column, "/candidates");
  require_finite(c.matched_pad, "/samples/matched_pad");
  require_flags(c.improving, "/improving");
  require_flags(c.pool_truncated, "/pool/truncated");
  require_flags(c.exact, "/candidates/exact");
  require_ascending(c.pool_edge, "/pool/edge");
  require_ascending(c.stale, "/samples/stale");
  require_ascending(c.matched_edge, "/samples/matched_edge");
}

/// Checks that all columns of a table have the same number of rows.
void check_rows(const CheckpointColumns& c) {
  require(c.digests.size() == 4 && c.improving.size() == 1 && c.stage.size() == 6 && c.searches.size() == 2 &&
              c.batch_pieces.size() == 1 && c.batch_worth.size() == 1 && c.replaced.size() == 1 &&
              c.size_factors.size() == 4 && c.best_missing.size() == 1 && c.counts.size() == std::size(kCounts) &&
              c.measures.size() == std::size(kMeasures),
          "a list of fixed length has another one");
  const std::size_t placed = c.placed_shape.size();
  require(c.placed_pose.size() == 4 * placed && c.placed_score.size() == placed && c.placed_matched.size() == placed,
          "/placements: columns of different length");
  const std::size_t moving = c.moving_shape.size();
  require(c.moving_pose.size() == 4 * moving && c.moving_score.size() == moving && c.moving_matched.size() == moving,
          "/moving: columns of different length");
  const std::size_t best = c.best_shape.size();
  require(c.best_pose.size() == 4 * best && c.best_score.size() == best && c.best_matched.size() == best,
          "/sizes: columns of different length");
  require(c.pool_truncated.size() == c.pool_edge.size() && c.pool_candidates.size() == c.pool_edge.size(),
          "/pool: columns of different length");
  const std::size_t rows = c.shape.size();
  require(c.source.size() == rows && c.stance.size() == rows && c.pose.size() == 4 * rows &&
              c.terms.size() == 6 * rows && c.score.size() == rows && c.exact.size() == rows &&
              c.window.size() == 4 * rows && c.shape_size.size() == 2 * rows,
          "/candidates: columns of different length");
  require(c.matched_pad.size() == kMatchedRow * c.matched_edge.size(), "/samples: columns of different length");
  std::uint64_t candidates = 0;
  for (const std::uint32_t count : c.pool_candidates) {
    require(count <= std::uint32_t(kPoolPerSample), "/pool/candidates: a value is out of range");
    candidates += count;
  }
  require(candidates == rows, "/pool/candidates does not count /candidates");
}

/// The phase that the columns show. The master refuses pieces that move while the canvas is being filled.
LoopPhase phase_of(const CheckpointColumns& from) {
  if (from.improving[0] == 0) return LoopPhase::filling;
  return from.moving_shape.empty() ? LoopPhase::trying : LoopPhase::replacing;
}

void read_loop(const CheckpointColumns& from, CheckpointState& state) {
  state.loop.phase = phase_of(from);
  state.loop.region = from.stage[0];
  state.given = from.stage[1];
  state.sizes = {from.stage[2], from.size_factors[0], from.size_factors[1], from.size_factors[2], from.stage[3] != 0};
  state.best.factor = from.size_factors[3];
  state.best.missing = from.best_missing[0];
  state.begun_with = from.stage[4] | std::uint64_t(from.stage[5]) << 32;
  state.search = from.searches[0];
  state.searched = from.searches[1];
  state.batch_pieces = from.batch_pieces[0];
  state.batch_worth = from.batch_worth[0];
  state.batch_taken = from.batch_taken;
  for (std::size_t i = 0; i < std::size(kCounts); ++i) state.statistics.*kCounts[i] = from.counts[i];
  for (std::size_t i = 0; i < std::size(kMeasures); ++i) state.statistics.*kMeasures[i] = from.measures[i];
  state.loop.trials = state.statistics.trials;
  state.loop.improve_s = state.statistics.improve_s;
  state.loop.run_s = state.statistics.total_s;
  state.loop.replaced = from.replaced[0];
}

void read_pieces(const CheckpointColumns& from, CheckpointState& state) {
  for (std::size_t i = 0; i < from.placed_shape.size(); ++i) {
    state.placements.push_back(
        {ShapeId{from.placed_shape[i]}, pose_at(from.placed_pose, i), from.placed_score[i], from.placed_matched[i]});
  }
  for (std::size_t i = 0; i < from.moving_shape.size(); ++i) {
    state.loop.moving.push_back(
        {ShapeId{from.moving_shape[i]}, pose_at(from.moving_pose, i), from.moving_score[i], from.moving_matched[i]});
  }
  for (std::size_t i = 0; i < from.best_shape.size(); ++i) {
    state.best.placements.push_back(
        {ShapeId{from.best_shape[i]}, pose_at(from.best_pose, i), from.best_score[i], from.best_matched[i]});
  }
}

void read_pool(const CheckpointColumns& from, CheckpointState& state) {
  std::size_t row = 0;
  for (std::size_t i = 0; i < from.pool_edge.size(); ++i) {
    PooledSample sample{SampleId{from.pool_edge[i]}, from.pool_truncated[i] != 0, {}};
    for (std::uint32_t k = 0; k < from.pool_candidates[i]; ++k) sample.candidates.push_back(candidate_at(from, row++));
    state.pool.push_back(std::move(sample));
  }
}

void read_samples(const CheckpointColumns& from, CheckpointState& state) {
  for (const std::uint32_t edge : from.stale) state.stale.push_back(SampleId{edge});
  for (std::size_t i = 0; i + 2 < from.matches.size(); i += 3) {
    state.matches.push_back({SampleId{from.matches[i]}, from.matches[i + 1], from.matches[i + 2]});
  }
  for (std::size_t i = 0; i < from.matched_edge.size(); ++i) {
    const float* row = from.matched_pad.data() + kMatchedRow * i;
    MatchedPad pad;
    pad.sample = SampleId{from.matched_edge[i]};
    std::copy_n(row, kLevels, pad.left.begin());
    std::copy_n(row + kLevels, kLevels, pad.right.begin());
    pad.convexity = row[2 * kLevels];
    state.matched.push_back(pad);
  }
}

}  // namespace

CheckpointColumns to_columns(const Checkpoint& checkpoint) {
  CheckpointColumns to;
  to.job.assign(checkpoint.job.begin(), checkpoint.job.end());
  to.digests = {checkpoint.library_digest, checkpoint.canvas_digest, checkpoint.state.rebuilt_digest,
                checkpoint.overlay_digest};
  append_loop(to, checkpoint.state);
  append_pieces(to, checkpoint.state);
  append_pool(to, checkpoint.state);
  append_samples(to, checkpoint.state);
  return to;
}

Checkpoint from_columns(const CheckpointColumns& columns) {
  check_rows(columns);
  check_values(columns);
  Checkpoint checkpoint;
  checkpoint.job.assign(columns.job.begin(), columns.job.end());
  checkpoint.library_digest = columns.digests[0];
  checkpoint.canvas_digest = columns.digests[1];
  checkpoint.overlay_digest = columns.digests[3];
  checkpoint.state.rebuilt_digest = columns.digests[2];
  read_loop(columns, checkpoint.state);
  read_pieces(columns, checkpoint.state);
  read_pool(columns, checkpoint.state);
  read_samples(columns, checkpoint.state);
  return checkpoint;
}

}  // namespace tessera
