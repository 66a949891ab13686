// A checkpoint as flat arrays, one for each data set of the file. Reader and writer both use the list in each_column.
#pragma once

#include <cstdint>
#include <vector>

#include "checkpoint/checkpoint_file.h"

namespace tessera {

struct CheckpointColumns {
  std::vector<std::uint8_t> job;
  std::vector<std::uint64_t> digests;  // library, canvas, rebuilt, colours
  std::vector<std::uint8_t> improving;
  std::vector<std::uint32_t> stage;
  std::vector<std::uint8_t> searches;
  std::vector<std::uint32_t> batch_pieces;
  std::vector<float> batch_worth;
  std::vector<std::uint8_t> batch_taken;
  std::vector<std::uint64_t> counts;
  std::vector<double> measures;
  std::vector<std::uint32_t> placed_shape;
  std::vector<float> placed_pose, placed_score, placed_matched;
  std::vector<std::uint32_t> moving_shape;
  std::vector<float> moving_pose, moving_score, moving_matched;
  std::vector<std::uint64_t> replaced;
  std::vector<float> size_factors;
  std::vector<std::uint64_t> best_missing;
  std::vector<std::uint32_t> best_shape;
  std::vector<float> best_pose, best_score, best_matched;
  std::vector<std::uint32_t> pool_edge;
  std::vector<std::uint8_t> pool_truncated;
  std::vector<std::uint32_t> pool_candidates;
  std::vector<std::uint32_t> shape, source, stance;
  std::vector<float> pose, terms, score;
  std::vector<std::uint8_t> exact;
  std::vector<std::int32_t> window;
  std::vector<float> shape_size;
  std::vector<std::uint32_t> stale, matches;
  std::vector<std::uint32_t> matched_edge;
  std::vector<float> matched_pad;
};

/// Calls visit(path, array, numbers in a row, unit, description) for each data set. A table has one data set for each
/// column. `Columns` is CheckpointColumns, const or not.
template <class Columns, class Visit>
void each_column(Columns& c, Visit visit) {
  visit("/job", c.job, 1, "", "the effective job, TOML");
  visit("/digests", c.digests, 1, "",
        "of the library's content, the canvas, the free region with its samples, colour.image");
  visit("/improving", c.improving, 1, "", "1: improving has begun");
  visit(
      "/stage", c.stage, 1, "",
      "region that is being filled, pieces that were given to it, attempt at its sizes, 1: the last one, digest of the "
      "pieces that the job gives (lower half, upper half)");
  visit("/searches", c.searches, 1, "",
        "which search of the stale samples goes on (0: none); searches of all samples (renewed ones had fewer)");
  visit(
      "/batch/pieces", c.batch_pieces, 1, "",
      "how many of the last placements belong to the open batch: candidates near them are still to be measured again");
  visit("/batch/worth", c.batch_worth, 1, "", "what the first of them was worth");
  visit("/batch/taken", c.batch_taken, 1, "",
        "1: a cell of 8 x 8 nodes of the free field that no other piece of the batch may touch; row by row");
  visit("/statistics/counts", c.counts, 1, "",
        "shapes, rounds, docking choices, dockings evaluated, refined, target samples, trials, trials kept");
  visit("/statistics/measures", c.measures, 1, "",
        "PADs a shape; then seconds: prune, dock, objective, merge, improve, total");
  visit("/placements/shape", c.placed_shape, 1, "", "index in the library; in the order in which they were placed");
  visit("/placements/canvas_from_shape", c.placed_pose, 4, "px", "a b tx ty: (a x - b y + tx, b x + a y + ty)");
  visit("/placements/score", c.placed_score, 1, "", "when it was placed");
  visit("/placements/matched", c.placed_matched, 1, "px", "boundary that touched when it was placed");
  visit("/moving/shape", c.moving_shape, 1, "", "while pieces are replaced: those that move, as in /placements");
  visit("/moving/canvas_from_shape", c.moving_pose, 4, "px", "as in /placements");
  visit("/moving/score", c.moving_score, 1, "", "as in /placements");
  visit("/moving/matched", c.moving_matched, 1, "px", "as in /placements");
  visit("/replaced", c.replaced, 1, "", "replacement trials so far");
  visit("/sizes/factors", c.size_factors, 1, "",
        "of this attempt, the least that was too large, the largest at which all pieces found a place, of the best");
  visit("/sizes/best_missing", c.best_missing, 1, "", "pieces that found no place in the best attempt so far");
  visit("/sizes/best_shape", c.best_shape, 1, "", "its pieces, as in /placements");
  visit("/sizes/best_canvas_from_shape", c.best_pose, 4, "px", "as in /placements");
  visit("/sizes/best_score", c.best_score, 1, "", "as in /placements");
  visit("/sizes/best_matched", c.best_matched, 1, "px", "as in /placements");
  visit("/pool/edge", c.pool_edge, 1, "", "target samples that have candidates, ascending");
  visit("/pool/truncated", c.pool_truncated, 1, "", "1: there were more candidates");
  visit("/pool/candidates", c.pool_candidates, 1, "", "how many of the rows of /candidates are this sample's");
  visit("/candidates/shape", c.shape, 1, "", "index in the library");
  visit("/candidates/source", c.source, 1, "", "PAD or draw that it came from");
  visit("/candidates/stance", c.stance, 1, "", "way of standing that the job's wishes allow");
  visit("/candidates/canvas_from_shape", c.pose, 4, "px", "as in /placements");
  visit("/candidates/terms", c.terms, 6, "px, px2, px4", "matched; overlap, gap; overlap, gap of squared areas");
  visit("/candidates/score", c.score, 1, "", "");
  visit("/candidates/exact", c.exact, 1, "", "1: the score is the exact one");
  visit("/candidates/window", c.window, 4, "nodes", "x0 y0 x1 y1: nodes whose change changes the score");
  visit("/candidates/shape_size", c.shape_size, 2, "shape units", "the shape's perimeter, radius");
  visit("/samples/stale", c.stale, 1, "", "target samples to be matched, ascending");
  visit("/samples/matches", c.matches, 3, "",
        "target sample, ascending, how often it was matched, and how often it was searched since it was renewed");
  visit("/samples/matched_edge", c.matched_edge, 1, "", "target samples whose PAD changed since, ascending");
  visit("/samples/matched_pad", c.matched_pad, 2 * kMaxPadLevels + 1, "px", "left and right arclengths, convexity");
}

CheckpointColumns to_columns(const Checkpoint& checkpoint);

/// Makes a checkpoint of the columns. Throws Hdf5Error where the columns contradict each other, or where a number is
/// outside its range. Collage::restore checks what needs the canvas and the library (shapes, target samples).
Checkpoint from_columns(const CheckpointColumns& columns);

}  // namespace tessera
