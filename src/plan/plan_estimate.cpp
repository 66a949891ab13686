#include "plan/plan_estimate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/kept_memory.h"
#include "core/collage/missing_pieces.h"
#include "core/matching/matching_context.h"
#include "core/replacing/canvas_windows.h"
#include "core/settings/tuning.h"
#include "master/replacing.h"
#include "products/mosaic/mosaic_plan.h"
#include "run/progress/time_estimate.h"
#include "worker/device_room.h"
#include "worker/shard/shard.h"

namespace tessera {
namespace {

// The constants were measured with release builds on two cores of 2 GHz with PoCL 3.1. Times and memory of the filling:
// docs/measurements/engine.md has the runs, of 720 to 46,054 pieces. The other constants: 12 runs in one process, libraries
// of 120 to 10,000 shapes, canvases of 500 to 1500 px. A range says how far single runs differ.

// Canvas area for each piece, divided by the product of smallest and largest scale: 1.4 (5 shapes) to 2.9 (815 shapes).
constexpr double kAreaOfAPiece = 1.8;
// Target samples for each piece (card.json, target_samples): 43 to 54; of a mosaic 25, as its batches are larger.
constexpr double kSamplesOfAPiece = 45;
constexpr double kSamplesInAMosaic = 25;
// Largest number of open samples at a time, divided by the pieces of the whole collage: 10.3 to 11.6 (four runs).
constexpr double kOpenSamplesOfAPiece = 11;

// prune_s for each sample: 43 us with 234 shapes, 97 us with 6,082. It grows with the cube root of the library's PADs, as the
// best pairs are nearer in a denser library.
constexpr double kPairsOfCubeRoot_s = 1.1e-6;
// dock_s for each sample, with the searches: 172 to 191 us; it grows with the square root of the number of shapes.
constexpr double kDocking_s = 165e-6;
constexpr double kDockingOfRoot_s = 0.2e-6;
// objective_s + merge_s for each piece: 2.7 to 3.0 ms.
constexpr double kMasterOfAPiece_s = 2.8e-3;
// Attempts at sizes with fit = "all": 1 to 5 of at most twelve (seven jobs).
constexpr double kAttempts = 3;
// improve_s for each trial: 19 ms (185 shapes) and 30 ms (1,138 shapes).
constexpr double kSamplesOfATrial = 60;
constexpr double kMasterOfATrial_s = 7e-3;
// Time of one replacement trial: 2,000 trials with pieces of 60 to 120 px took 18 s on one core.
constexpr double kReplacement_s = 9e-3;
// Time before the first round and after the last one: kernels (0.1 s, or 1 to 8 s when they are compiled for the first
// time), card, pictures (1 s for one of 2000 px); and a worker's part of the library. Writing and drawing 97,507 pieces
// took 70 s, 20,359 pieces 33 s.
constexpr double kOverhead_s = 2;
constexpr double kLoadingAShape_s = 0.45e-3;
constexpr double kWritingAPiece_s = 1.5e-3;

// Peak resident memory of the ranks of 3-rank runs and of single processes (the maximum in /proc). Freed memory was not
// kept in these runs, so kKeptFreed_bytes is added.
constexpr double kMasterProcess_bytes = 95e6 + kKeptFreed_bytes;
constexpr double kWorkerProcess_bytes = 155e6 + kKeptFreed_bytes;
constexpr double kBothProcess_bytes = 175e6 + kKeptFreed_bytes;
// Master, for each canvas px while quality is measured.
constexpr double kCountedNode_bytes = 18;
// Master, for each piece: its outline, the samples round it and their candidates, and at the end its text in the files.
// 1,835 pieces of 20 to 80 px, 11,521 of 5 to 20 px and 97,507 of 11 to 45 px took 42 to 50 KB each.
constexpr double kPiece_bytes = 46e3;
// Master, while the picture is drawn: bytes for each picture px (at 4 Mpx with 232 drawings of openclipart). From 14
// Mpx on it is what PictureLimits allows (picture_drawing.h) with the bands and copies. The canvas' fields are added.
constexpr double kPicture_bytes = 60;
constexpr double kMostPicture_bytes = 850e6;
constexpr double kDrawnNode_bytes = 5;
// Worker, for each canvas px: the field on the host and on the device.
constexpr double kFieldNode_bytes = 10;
// Whole shapes: the master keeps the last kKeptShapes; at most kPassingShapes are on their way to a worker's device.
constexpr double kWholeShape_bytes = 80e3;
constexpr double kKeptShapes = 1024;
constexpr double kPassingShapes = 512;

// These follow from the checkpoint's format: bytes of a piece, of an open target sample with as many candidates as the
// pool keeps for it, and of the empty file.
constexpr double kCheckpointPiece_bytes = 28;
constexpr double kCheckpointSample_bytes = 81 + 65. * kPoolPerSample;
constexpr double kCheckpoint_bytes = 50e3;

std::vector<std::uint32_t> drawings_of(const PlanInput& input) {
  std::vector<std::uint32_t> drawings = input.drawings;
  if (!drawings.empty()) return drawings;
  drawings.resize(input.shapes);
  std::iota(drawings.begin(), drawings.end(), 0u);
  return drawings;
}

/// Pieces that fit = "all" asks for; the sizes follow from their number.
double wanted_pieces(const PlanInput& input) {
  double pieces = 0;
  for (const MissingPieces& missing : missing_pieces(input.settings, drawings_of(input), {})) pieces += missing.wanted;
  return pieces;
}

bool is_mosaic(const PlanInput& input) { return bool(input.settings.colour); }

/// Pieces for each px² where the largest may have the size `largest_px`.
double pieces_per_px2(const PlanInput& input, double largest_px) {
  const double smallest_px = input.settings.pieces.min_scale_px;
  if (is_mosaic(input)) return mosaic_pieces_per_px2(smallest_px, largest_px);
  return 1 / (kAreaOfAPiece * smallest_px * largest_px);
}

/// The mean of pieces_per_px2() over the canvas: a size map says how large pieces may be at each place.
double mean_pieces_per_px2(const PlanInput& input) {
  const PieceSettings& pieces = input.settings.pieces;
  if (!pieces.size_map) return pieces_per_px2(input, pieces.max_scale_px);
  const std::vector<float>& parts = pieces.size_map->part.data();
  const double range = std::log(double(pieces.max_scale_px) / pieces.min_scale_px);
  const double sum = std::accumulate(parts.begin(), parts.end(), 0., [&](double before, float part) {
    return before + pieces_per_px2(input, pieces.min_scale_px * std::exp(part * range));
  });
  return sum / double(parts.size());
}

/// Pieces of a filled canvas, as if [stop] had no limits.
double pieces_when_filled(const PlanInput& input, double coverage) {
  const PieceSettings& pieces = input.settings.pieces;
  if (pieces.fit_all) return coverage * wanted_pieces(input);
  const double room = input.canvas_px2 * mean_pieces_per_px2(input);
  return std::min(coverage * room, most_pieces(input.settings, drawings_of(input)));
}

double expected_pieces(const PlanInput& input) {
  const StopSettings& stop = input.settings.stop;
  const double pieces = std::max(1., pieces_when_filled(input, stop.coverage));
  return stop.pieces > 0 ? std::min(pieces, double(stop.pieces)) : pieces;
}

/// Adds the memory. A device that is the host itself (a CPU) keeps its part of the library and the lists of pairs in
/// the worker's memory.
void add_memory(const PlanInput& input, const MatchingContext& context, PlanEstimate& plan) {
  const double shapes = double(plan.shapes_per_worker);
  const worker::ShardBytes shard = worker::shard_bytes(context, plan.shapes_per_worker, input.reads);
  const double lists = double(worker::list_bytes(plan.shapes_per_worker));
  const double passing = kWholeShape_bytes * std::min(shapes, kPassingShapes);
  const double field = kFieldNode_bytes * input.canvas_nodes;
  plan.device_bytes = double(worker::device_bytes(context, plan.shapes_per_worker,
                                                  {.reads_models = input.reads, .field_nodes = input.canvas_nodes}));
  plan.largest_buffer_bytes = double(std::max(shard.largest_buffer, worker::list_bytes(plan.shapes_per_worker)));
  const double on_host = input.host_devices ? double(shard.device) + lists : 0;
  const double library = passing + double(shard.host) + on_host;
  const double kept = kWholeShape_bytes * std::min(double(input.shapes), kKeptShapes);
  const double counting = kCountedNode_bytes * input.canvas_nodes;
  const double drawing =
      kDrawnNode_bytes * input.canvas_nodes + std::min(kPicture_bytes * input.picture_px2, kMostPicture_bytes);
  const double pieces = kPiece_bytes * plan.pieces;
  const double master = kept + pieces + std::max(counting, drawing);  // measuring and drawing do not overlap
  plan.worker_bytes = kWorkerProcess_bytes + field + library;
  plan.master_bytes = kMasterProcess_bytes + master;
  if (input.ranks == 1) plan.worker_bytes = plan.master_bytes = kBothProcess_bytes + field + library + master;
  plan.node_bytes = plan.master_bytes + (plan.ranks_per_node - 1) * plan.worker_bytes;
}

/// The time within a limit in seconds; 0: no limit.
double limited(double seconds, double limit_s) { return limit_s > 0 ? std::min(seconds, limit_s) : seconds; }

/// Time of so many trials. Each rank works with its cores, but at most one worker works for each window.
double replacing_s(const PlanInput& input, const PlanEstimate& plan, double trials) {
  const double window_px = double(least_window_px(input.settings.pieces));
  const double windows = std::max(1., input.canvas_px2 / (window_px * window_px));
  return trials * double(master::kReplacementsPerTrial) * kReplacement_s / std::min(double(plan.workers), windows);
}

/// Number of improvement trials. A limit that ends the filling leaves nothing to improve; a number of pieces that is
/// not reached is no limit.
double expected_trials(const PlanInput& input, double trials_a_second) {
  const ImproveSettings& improve = input.settings.improve;
  StopSettings stop = input.settings.stop;
  if (stop.pieces > pieces_when_filled(input, 1)) stop.pieces = 0;
  if (ends_before_improving(stop)) return 0;
  return improve.trials > 0 ? double(improve.trials) : improve.seconds * trials_a_second;
}

void add_times(const PlanInput& input, PlanEstimate& plan) {
  const CollageSettings& s = input.settings;
  const double shapes = double(input.shapes);
  const double pads = shapes * double(plan.pads_per_shape);
  const double sample_s = kPairsOfCubeRoot_s * std::cbrt(pads) + kDocking_s + kDockingOfRoot_s * std::sqrt(shapes);
  const double attempts = s.pieces.fit_all ? kAttempts : 1;
  const double samples_of_a_piece = is_mosaic(input) ? kSamplesInAMosaic : kSamplesOfAPiece;
  const double matching_s = attempts * plan.pieces * samples_of_a_piece * sample_s;
  const double placing_s = attempts * plan.pieces * kMasterOfAPiece_s;
  const double trial_s = kSamplesOfATrial * sample_s;
  const double trials = expected_trials(input, 1 / (trial_s / plan.workers + kMasterOfATrial_s));
  const double replaced = master::pays_to_replace(s) ? master::kPartReplaced * trials : 0;
  const double others = trials - replaced;
  const double improving_s = limited(
      others * (trial_s / plan.workers + kMasterOfATrial_s) + replacing_s(input, plan, replaced), s.improve.seconds);
  const double loop_s = matching_s / plan.workers + placing_s;
  plan.filling_s = limited(loop_s, s.stop.seconds);
  plan.improving_s = limited(loop_s + improving_s, s.stop.seconds) - plan.filling_s;
  plan.beside_s = kOverhead_s + double(plan.shapes_per_worker) * kLoadingAShape_s + plan.pieces * kWritingAPiece_s;
  plan.total_s = plan.filling_s + plan.improving_s + plan.beside_s;
}

}  // namespace

PlanEstimate estimate(const PlanInput& input) {
  const MatchingContext context = make_matching_context(input.settings, std::uint32_t(input.shapes));
  PlanEstimate plan;
  plan.workers = std::max(1, input.ranks - 1);
  plan.workers_per_node = (plan.workers + input.nodes - 1) / input.nodes;
  plan.ranks_per_node = (input.ranks + input.nodes - 1) / input.nodes;
  plan.levels = context.levels.size();
  plan.pads_per_shape = pads_per_shape(context);
  plan.shapes_per_worker = (input.shapes + std::size_t(plan.workers) - 1) / std::size_t(plan.workers);
  plan.pieces = expected_pieces(input);
  add_memory(input, context, plan);
  add_times(input, plan);
  plan.checkpoint_bytes =
      kCheckpoint_bytes + plan.pieces * (kCheckpointPiece_bytes + kOpenSamplesOfAPiece * kCheckpointSample_bytes);
  return plan;
}

}  // namespace tessera
