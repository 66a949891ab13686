#include "worker/pair_search.h"

#include <algorithm>

#include "worker/list_room.h"

namespace tessera::worker {
namespace {

/// Work items of a sample in find_blocks, and of a block in find_pairs; and those of a group (kernels/pad_index.cl).
struct SearchItems {
  std::size_t together = 1;
  std::size_t group = 16;  // they share a root's boxes in a cache
  std::size_t groups_per_unit = 16;
};

SearchItems search_items(DockingLanes lanes) {
  return lanes == DockingLanes::items ? SearchItems{16, 32, 32} : SearchItems{};
}

}  // namespace

PairSearch::PairSearch(const DeviceLibrary& library, std::size_t stage_bytes)
    : library_(&library),
      find_blocks_(library.session().kernel("find_blocks")),
      find_pairs_(library.session().kernel("find_pairs")),
      block_room_(room_in(stage_bytes / 2, sizeof(BlockRecord))),
      pair_room_(room_in(stage_bytes / 2, sizeof(PairRecord))),
      most_bytes_(kMostGrowth * stage_bytes),
      blocks_(library.session()),
      block_count_(library.session()),
      pairs_(library.session()),
      pair_count_(library.session()) {}

void PairSearch::post(const DeviceBuffer<SampleRecord>& samples, std::uint32_t count, std::uint32_t segment_stride) {
  samples_ = &samples;
  count_ = count;
  segment_stride_ = segment_stride;
  blocks_.reserve(block_room_);
  pairs_.reserve(pair_room_);
  block_count_.clear(1);
  pair_count_.clear(1);
  const DeviceIndex& index = library_->index();
  const DeviceStances& stances = library_->stances();
  const DeviceColours& colours = library_->colours();
  const SearchItems search = search_items(library_->lanes());
  launch(library_->session(), find_blocks_, {count * search.together, index.root_count(), search.group}, index.roots(),
         index.node_boxes(), index.block_boxes(), look_at_boxes_, segment_stride, samples, count, block_room_,
         block_count_, blocks_);
  // How many blocks there are is known on the device alone: as many work groups as keep it busy share them, all in one
  // launch.
  const std::size_t items =
      std::min(library_->session().compute_units() * search.groups_per_unit * search.group, kMostWorkItems / 2);
  launch(library_->session(), find_pairs_, {items, 1, search.group}, library_->match_buffer(), stances.stances(),
         stances.lists(), stances.shape_class(), index.rows(), index.places(), index.chords(), colours.record(),
         colours.near_bits(), samples, block_count_, block_room_, blocks_, pair_room_, pair_count_, pairs_);
  library_->session().flush();
}

std::optional<std::vector<PairRecord>> PairSearch::take() {
  while (true) {
    const std::uint32_t blocks = block_count_.read(1).front();
    const std::uint32_t pairs = pair_count_.read(1).front();
    if (blocks <= block_room_ && pairs <= pair_room_) {
      blocks_visited_ += blocks;
      return pairs_.read(pairs);
    }
    const bool too_many =
        blocks > most_bytes_ / 2 / sizeof(BlockRecord) || pairs > most_bytes_ / 2 / sizeof(PairRecord);
    if (too_many && count_ > 1) return std::nullopt;
    block_room_ = grown_room(block_room_, blocks);
    pair_room_ = grown_room(pair_room_, pairs);
    post(*samples_, count_, segment_stride_);
  }
}

}  // namespace tessera::worker
