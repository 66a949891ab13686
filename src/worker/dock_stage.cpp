#include "worker/dock_stage.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <numeric>

#include "core/base/rank_pool.h"
#include "worker/devices/kernel_options.h"
#include "worker/docked_shortlist.h"
#include "worker/list_room.h"

namespace tessera::worker {
namespace {

constexpr std::size_t kSamplesOfATask = 32;
constexpr std::size_t kPairsPerGroup = 32;  // where the kernel does not need groups of a docking's lanes

static_assert(sizeof(Docking) == sizeof(DockingRecord) && offsetof(Docking, key) == offsetof(DockingRecord, key) &&
              offsetof(Docking, canvas_from_shape) == offsetof(DockingRecord, canvas_from_shape));

}  // namespace

DockStage::DockStage(DeviceLibrary& library, PairStage& pairs, std::size_t stage_bytes)
    : library_(&library),
      pairs_(&pairs),
      dock_pairs_(library.session(), "dock_pairs"),
      dock_tangents_(library.session(), "dock_tangents"),
      deck_(library),
      samples_(library.session()),
      docked_pairs_(library.session()),
      pair_keypoints_(library.session()),
      dockings_(library.session()),
      docking_count_(library.session()),
      evaluated_(library.session()),
      docking_capacity_(room_in(stage_bytes, sizeof(DockingRecord))) {}

void DockStage::post(const DockRequest& request, std::vector<SampleRecord> samples) {
  sample_count_ = std::uint32_t(samples.size());
  draws_ = request.tangent_dockings;
  first_drawn_ = request.first_drawn;
  samples_.write(samples);
  if (draws_ > 0) deck_.draw(request.samples);
  make_room();
  launch_tangents();  // posted first, so that the device works while key points are read
  std::vector<PairRecord> pairs = pairs_->pairs_of(std::move(samples), request.bin_limit);
  pair_count_ = std::uint32_t(pairs.size());
  pair_keypoints_.post(library_->keypoints().of(pairs));
  docked_pairs_.post(std::move(pairs));
  launch_pairs();
}

void DockStage::make_room() {
  dockings_.reserve(docking_capacity_);
  docking_count_.clear(1);
  evaluated_.clear(sample_count_);
}

void DockStage::launch_pairs() {
  const std::size_t group = items_of_docking(library_->lanes());
  const DeviceStances& stances = library_->stances();
  const DeviceColours& colours = library_->colours();
  dock_pairs_.launch({pair_count_, 1, group == 1 ? kPairsPerGroup : group}, {{"match", library_->match_buffer()},
                                                                             {"stances", stances.stances()},
                                                                             {"stance_lists", stances.lists()},
                                                                             {"shape_class", stances.shape_class()},
                                                                             {"size_map", library_->size_map()},
                                                                             {"field_value", library_->field()},
                                                                             {"colour", colours.record()},
                                                                             {"texels", colours.texels()},
                                                                             {"sketches", library_->sketches()},
                                                                             {"shapes", library_->shapes()},
                                                                             {"samples", samples_},
                                                                             {"count", pair_count_},
                                                                             {"pairs", docked_pairs_},
                                                                             {"pair_keypoints", pair_keypoints_},
                                                                             {"evaluated", evaluated_},
                                                                             {"capacity", docking_capacity_},
                                                                             {"docking_count", docking_count_},
                                                                             {"dockings", dockings_}});
  library_->session().flush();
}

void DockStage::launch_tangents() {
  const DockingLanes lanes = library_->lanes();
  const DeviceStances& stances = library_->stances();
  const DeviceColours& colours = library_->colours();
  const std::uint32_t items = (draws_ + draws_per_item(lanes) - 1) / draws_per_item(lanes);
  dock_tangents_.launch({items, sample_count_, items_of_docking(lanes)},
                        {{"match", library_->match_buffer()},
                         {"stances", stances.stances()},
                         {"stance_lists", stances.lists()},
                         {"shape_class", stances.shape_class()},
                         {"size_map", library_->size_map()},
                         {"open_count", deck_.open_count()},
                         {"all_open", deck_.all_open()},
                         {"open_shapes", deck_.open_shapes()},
                         {"near_length", deck_.near_length()},
                         {"near_shapes", deck_.near_shapes()},
                         {"field_value", library_->field()},
                         {"colour", colours.record()},
                         {"texels", colours.texels()},
                         {"contours", library_->contours().contours()},
                         {"contour_places", library_->contours().places()},
                         {"sketches", library_->sketches()},
                         {"shapes", library_->shapes()},
                         {"samples", samples_},
                         {"draws", draws_},
                         {"evaluated", evaluated_},
                         {"capacity", docking_capacity_},
                         {"docking_count", docking_count_},
                         {"dockings", dockings_}});
  library_->session().flush();
}

DockReply DockStage::take() {
  std::uint32_t count = docking_count_.read(1).front();
  if (count > docking_capacity_) {  // the kernel counted all of them
    docking_capacity_ = grown_room(docking_capacity_, count);
    make_room();
    launch_tangents();
    launch_pairs();
    count = docking_count_.read(1).front();
  }
  DockReply reply;
  const std::vector<std::uint32_t> evaluated = evaluated_.read(sample_count_);
  reply.evaluated = std::accumulate(evaluated.begin(), evaluated.end(), std::uint64_t(0));
  std::vector<std::vector<Docking>> of_sample(sample_count_);
  for (const DockingRecord& record : dockings_.read(count)) {
    of_sample[record.sample].push_back(std::bit_cast<Docking>(record));
  }
  parallel_for_portions(of_sample.size(), kSamplesOfATask, [&](std::size_t i) {
    if (first_drawn_) rank_by_draw(of_sample[i]);
    keep_docked_shortlist(of_sample[i]);
  });
  for (const std::vector<Docking>& dockings : of_sample)
    reply.dockings.insert(reply.dockings.end(), dockings.begin(), dockings.end());
  return reply;
}

}  // namespace tessera::worker
