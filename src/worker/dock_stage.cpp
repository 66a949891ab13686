#include "worker/dock_stage.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <numeric>
#include <utility>

namespace tessera::worker {
namespace {

constexpr std::size_t kDrawsPerGroup = 32;

static_assert(sizeof(Docking) == sizeof(DockingRecord) && offsetof(Docking, key) == offsetof(DockingRecord, key) &&
              offsetof(Docking, canvas_from_shape) == offsetof(DockingRecord, canvas_from_shape));

}  // namespace

struct DockStage::Part {
  std::uint32_t first;
  std::uint32_t end;
  std::uint32_t count() const { return end - first; }
};

DockStage::DockStage(const DeviceLibrary& library, PairStage& pairs)
    : library_(&library),
      pairs_(&pairs),
      dock_pairs_(library.session().kernel("dock_pairs")),
      dock_tangents_(library.session().kernel("dock_tangents")),
      keep_shortlist_(library.session().kernel("keep_shortlist")),
      paired_(library.session()),
      paired_keys_(library.session()),
      tangent_(library.session()),
      tangent_keys_(library.session()),
      shortlists_(library.session()),
      shortlist_counts_(library.session()),
      evaluated_(library.session()) {}

std::uint32_t DockStage::samples_at_a_time() const {
  const std::size_t paired = with_pairs_ ? library_->match().shapes * kDockingsPerShape : 0;
  const std::size_t bytes = (draws_ + paired) * (sizeof(DockingRecord) + sizeof(float));
  return std::uint32_t(std::max<std::size_t>(1, pairs_->stage_bytes() / std::max<std::size_t>(1, bytes)));
}

void DockStage::post(const DockRequest& request, std::vector<SampleRecord> samples) {
  samples_ = std::uint32_t(request.samples.size());
  draws_ = request.tangent_dockings;
  with_pairs_ = std::any_of(request.bin_limit.begin(), request.bin_limit.end(), [](std::uint32_t b) { return b > 0; });
  pairs_->set_samples(std::move(samples));
  shortlists_.reserve(std::size_t(samples_) * kShortlist);
  shortlist_counts_.reserve(samples_);
  evaluated_.clear(samples_);
  for (std::uint32_t first = 0; first < samples_; first += samples_at_a_time()) {
    post_part({first, std::min(samples_, first + samples_at_a_time())});
  }
  library_->session().flush();
}

void DockStage::post_part(const Part& part) {
  if (with_pairs_) dock_pairs(part);
  dock_tangents(part);
  const std::uint32_t paired = with_pairs_ ? library_->match().shapes * kDockingsPerShape : 0;
  launch(library_->session(), keep_shortlist_, {part.count()}, part.first, paired, paired_, paired_keys_, draws_,
         tangent_, tangent_keys_, shortlists_, shortlist_counts_, evaluated_);
}

void DockStage::dock_pairs(const Part& part) {
  const std::uint32_t first_paired = pairs_->need(part.first, part.end);
  const std::size_t places = std::size_t(part.count()) * library_->match().shapes * kDockingsPerShape;
  paired_.reserve(places);
  paired_keys_.reserve(places);
  launch(library_->session(), dock_pairs_, {part.count(), library_->match().shapes, kSamplesPerGroup},
         library_->match_buffer(), library_->stances().stances(), library_->stances().lists(),
         library_->stances().shape_class(), library_->size_map(), library_->field(), library_->colours().record(),
         library_->colours().texels(), library_->keypoints(), library_->contours(), library_->shapes(), part.first,
         part.end, pairs_->samples(), first_paired, pairs_->pairs(), pairs_->pair_count(), paired_, paired_keys_,
         evaluated_);
}

void DockStage::dock_tangents(const Part& part) {
  const std::size_t places = std::size_t(part.count()) * draws_;
  tangent_.reserve(places);
  tangent_keys_.reserve(places);
  const DeviceStances& stances = library_->stances();
  launch(library_->session(), dock_tangents_, {draws_, part.count(), kDrawsPerGroup}, library_->match_buffer(),
         stances.stances(), stances.lists(), stances.shape_class(), library_->size_map(), stances.open_count(),
         std::uint32_t(stances.all_open()), stances.open_shapes(), library_->field(), library_->colours().record(),
         library_->colours().texels(), library_->colours().near_shapes(), library_->contours(), library_->shapes(),
         part.first, pairs_->samples(), draws_, tangent_, tangent_keys_);
}

DockReply DockStage::take() {
  const std::vector<DockingRecord> shortlists = shortlists_.read(std::size_t(samples_) * kShortlist);
  const std::vector<std::uint32_t> counts = shortlist_counts_.read(samples_);
  const std::vector<std::uint32_t> evaluated = evaluated_.read(samples_);
  DockReply reply;
  reply.evaluated = std::accumulate(evaluated.begin(), evaluated.end(), std::uint64_t(0));
  for (std::uint32_t t = 0; t < samples_; ++t) {
    for (std::uint32_t i = 0; i < counts[t]; ++i) {
      reply.dockings.push_back(std::bit_cast<Docking>(shortlists[std::size_t(t) * kShortlist + i]));
    }
  }
  return reply;
}

}  // namespace tessera::worker
