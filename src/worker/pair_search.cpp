#include "worker/pair_search.h"

#include <algorithm>

#include "worker/list_room.h"

namespace tessera::worker {
namespace {

/// The number of work items for a sample in find_blocks and for a block in find_pairs, and of items in a group
/// (kernels/pad_index.cl).
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
      find_blocks_(library.session(), "find_blocks"),
      find_pairs_(library.session(), "find_pairs"),
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
  launch_blocks();
  launch_pairs();
  library_->session().flush();
}

void PairSearch::launch_blocks() {
  const DeviceIndex& index = library_->index();
  const SearchItems search = search_items(library_->lanes());
  find_blocks_.launch({count_ * search.together, index.root_count(), search.group},
                      {{"roots", index.roots()},
                       {"node_boxes", index.node_boxes()},
                       {"block_boxes", index.block_boxes()},
                       {"look_at_boxes", look_at_boxes_},
                       {"segment_stride", segment_stride_},
                       {"samples", *samples_},
                       {"sample_count", count_},
                       {"capacity", block_room_},
                       {"block_count", block_count_},
                       {"blocks", blocks_}});
}

/// Posts one launch of as many work groups as keep the device busy; they share the blocks that were found, whose number the
/// host does not know yet.
void PairSearch::launch_pairs() {
  const DeviceIndex& index = library_->index();
  const DeviceStances& stances = library_->stances();
  const DeviceColours& colours = library_->colours();
  const SearchItems search = search_items(library_->lanes());
  const std::size_t items =
      std::min(library_->session().compute_units() * search.groups_per_unit * search.group, kMostWorkItems / 2);
  find_pairs_.launch({items, 1, search.group}, {{"match", library_->match_buffer()},
                                                {"stances", stances.stances()},
                                                {"stance_lists", stances.lists()},
                                                {"shape_class", stances.shape_class()},
                                                {"index_rows", index.rows()},
                                                {"index_places", index.places()},
                                                {"index_chords", index.chords()},
                                                {"colour", colours.record()},
                                                {"near_bits", colours.near_bits()},
                                                {"samples", *samples_},
                                                {"block_count", block_count_},
                                                {"block_capacity", block_room_},
                                                {"blocks", blocks_},
                                                {"capacity", pair_room_},
                                                {"pair_count", pair_count_},
                                                {"pairs", pairs_}});
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
