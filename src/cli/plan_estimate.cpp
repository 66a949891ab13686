#include "cli/plan_estimate.h"

#include <algorithm>
#include <cmath>

#include "core/matching_context.h"
#include "core/tuning.h"
#include "worker/opencl_matcher.h"
#include "worker/shard.h"

namespace tessera::cli {
namespace {

// Measured with release builds on two cores of a shared Xeon (2.0 GHz, PoCL 3.1, other work beside it): libraries of 5,
// 232 and 815 shapes, canvases of 500, 1000 and 1500 px, pieces of 14-90, 20-160 and 30-240 px, one process, 14 runs;
// and one canvas of 3000 px with 1,642 pieces. Between the runs of a constant lie factors of 1.5 to 2.

// Pieces: canvas area by pieces, in products of the smallest and the largest scale: 1.4 (5 shapes) to 2.9 (815).
constexpr double kAreaOfAPiece = 1.8;
// card.json, target_samples by pieces: 62 to 82; 104 on 3000 px.
constexpr double kSamplesOfAPiece = 80;
// The most samples that were open at a time, by the pieces of the whole collage: 10.3 to 11.6 (four runs).
constexpr double kOpenSamplesOfAPiece = 11;

// prune_s by samples and PADs of the library: 0.9e-9 to 1.5e-9.
constexpr double kPairs_s = 1.1e-9;
// dock_s by samples, a line through 5 shapes (100 to 200 us), 232 (120 to 360) and 815 (265 to 380).
constexpr double kDocking_s = 170e-6;
constexpr double kDockingOfAShape_s = 0.28e-6;
// objective_s + merge_s: 2 to 9 ms a piece, and for reading shapes when they are first seen.
constexpr double kMasterOfAPiece_s = 5e-3;
constexpr double kReadingAShape_s = 0.9e-3;
// improve_s by trials (50 trials): about 95 samples are matched anew; what is left of 45 and 69 ms.
constexpr double kSamplesOfATrial = 95;
constexpr double kMasterOfATrial_s = 8e-3;
// From the start to the first round and from the last to the files: kernels (0.1 s, or 1 to 8 when they are compiled
// for the first time), library, card, pictures (1 s for one of 2000 px); 20 s in all with 1,642 pieces.
constexpr double kOverhead_s = 3;
constexpr double kWritingAPiece_s = 10e-3;

// Peak resident memory of the ranks of 3-rank runs and of single processes, /proc's maximum.
constexpr double kMasterProcess_bytes = 95e6;
constexpr double kWorkerProcess_bytes = 155e6;
constexpr double kBothProcess_bytes = 175e6;
// Master, while quality is counted: 60 bytes a canvas px at 1 and 4 Mpx; beyond, 18 more for each (16 Mpx), as it is
// counted coarser there.
constexpr double kCountedNode_bytes = 60;
constexpr double kCoarseNode_bytes = 18;
constexpr double kFineCanvas_px2 = 4e6;
// Master, while the picture is drawn: 40 bytes a picture px at 4 Mpx, 32 at 16, 18 at 64 with five plain drawings, 60
// at 4 Mpx with 232 of openclipart; and the canvas' fields.
constexpr double kPicture_bytes = 60;
constexpr double kFarPicture_bytes = 14;
constexpr double kFinePicture_px2 = 16e6;
constexpr double kDrawnNode_bytes = 5;
// Worker, by canvas px: the field on the host and on the device.
constexpr double kFieldNode_bytes = 10;
// Beyond models and shards, which are counted: reading, allocator, staging. 135 KB a shape were seen (815 shapes beside
// 232) where 90 are counted.
constexpr double kLibraryExcess = 1.5;

// The checkpoint's format, not a measurement: bytes of a piece, of an open target sample with as many candidates as the
// pool keeps of it, of a sample that was matched; the empty file.
constexpr double kCheckpointPiece_bytes = 28;
constexpr double kCheckpointSample_bytes = 69 + 65. * kPoolPerSample;
constexpr double kCheckpointPass_bytes = 8;
constexpr double kCheckpoint_bytes = 50e3;

/// Up to `edge` at one price, beyond it at another.
double priced(double amount, double edge, double price, double price_beyond) {
  return price * std::min(amount, edge) + price_beyond * std::max(0., amount - edge);
}

double expected_pieces(const PlanInput& input) {
  const CollageSettings& s = input.settings;
  const double full = input.canvas_px2 / (kAreaOfAPiece * s.pieces.min_scale_px * s.pieces.max_scale_px);
  double pieces = std::max(1., full * s.stop.coverage);
  if (s.stop.pieces > 0) pieces = std::min(pieces, double(s.stop.pieces));
  if (s.pieces.uses > 0) pieces = std::min(pieces, double(s.pieces.uses) * double(input.shapes));
  return pieces;
}

double model_bytes(const PlanEstimate& plan) {
  return double(sizeof(ShapeModel) + kMaxInteriorPoints * sizeof(Vec2)) +
         double(plan.pads_per_shape * sizeof(ModelSample));
}

/// While the library is loaded: models, the shard on its way, and the shard on a device that is the host itself.
void add_memory(const PlanInput& input, const MatchingContext& context, PlanEstimate& plan) {
  const double shapes = double(plan.shapes_per_worker);
  const double shard = double(worker::shard_bytes(context, plan.shapes_per_worker));
  const double field = kFieldNode_bytes * input.canvas_nodes;
  plan.device_bytes = shard + sizeof(float) * input.canvas_nodes + 2 * double(worker::kStageBytes);
  const double library = kLibraryExcess * (shapes * model_bytes(plan) + shard * (input.host_devices ? 2 : 1));
  const double counting = priced(input.canvas_nodes, kFineCanvas_px2, kCountedNode_bytes, kCoarseNode_bytes);
  const double drawing = kDrawnNode_bytes * input.canvas_nodes +
                         priced(input.picture_px2, kFinePicture_px2, kPicture_bytes, kFarPicture_bytes);
  const double master = std::max(counting, drawing);  // one after the other
  plan.worker_bytes = kWorkerProcess_bytes + field + library;
  plan.master_bytes = kMasterProcess_bytes + master;
  if (input.ranks == 1) plan.worker_bytes = plan.master_bytes = kBothProcess_bytes + field + library + master;
  plan.node_bytes = plan.master_bytes + (plan.ranks_per_node - 1) * plan.worker_bytes;
}

/// With limits in seconds the times add up to no more than these.
double limited(double seconds, double limit_s) { return limit_s > 0 ? std::min(seconds, limit_s) : seconds; }

void add_times(const PlanInput& input, PlanEstimate& plan) {
  const CollageSettings& s = input.settings;
  const double shapes = double(input.shapes);
  const double sample_s = kPairs_s * shapes * double(plan.pads_per_shape) + kDocking_s + kDockingOfAShape_s * shapes;
  const double filling_s = plan.pieces * kSamplesOfAPiece * sample_s;
  const double trial_s = kSamplesOfATrial * sample_s;
  const double trials = s.improve.trials > 0    ? double(s.improve.trials)
                        : s.improve.seconds > 0 ? s.improve.seconds / (trial_s / plan.workers + kMasterOfATrial_s)
                                                : 0;
  plan.matching_s = filling_s + trials * trial_s;
  plan.master_s = plan.pieces * kMasterOfAPiece_s + shapes * kReadingAShape_s + trials * kMasterOfATrial_s;
  const double improving_s = limited(trials * (trial_s / plan.workers + kMasterOfATrial_s), s.improve.seconds);
  const double loop_s = filling_s / plan.workers + plan.pieces * kMasterOfAPiece_s + shapes * kReadingAShape_s;
  plan.total_s = kOverhead_s + plan.pieces * kWritingAPiece_s + limited(loop_s + improving_s, s.stop.seconds);
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
      kCheckpoint_bytes + plan.pieces * (kCheckpointPiece_bytes + kOpenSamplesOfAPiece * kCheckpointSample_bytes +
                                         kSamplesOfAPiece * kCheckpointPass_bytes);
  return plan;
}

}  // namespace tessera::cli
