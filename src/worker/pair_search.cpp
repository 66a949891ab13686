#include "worker/pair_search.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace tessera::worker {
namespace {

constexpr std::uint32_t kSamplesAtATime = 256;  // whose blocks wait at once
constexpr std::size_t kSamplesPerGroup = 16;    // they share a root's boxes in a cache
constexpr std::uint32_t kBlocksPerGroup = 16;

std::uint32_t records_in(std::size_t bytes, std::size_t record_bytes) {
  return std::uint32_t(std::max<std::size_t>(1, bytes / record_bytes));
}

/// Room for so many and, as buffers grow, for twice as many as there was room for. Counts are 32 bits wide.
std::uint32_t grown(std::uint32_t capacity, std::uint32_t needed) {
  if (needed <= capacity) return capacity;
  if (needed > std::uint32_t(1) << 31) throw EnvironmentError("more pairs of shapes and gaps are near than can be counted");
  return std::bit_ceil(needed);
}

}  // namespace

PairSearch::PairSearch(const DeviceLibrary& library, std::size_t stage_bytes)
    : library_(&library),
      find_blocks_(library.session().kernel("find_blocks")),
      find_pairs_(library.session().kernel("find_pairs")),
      block_capacity_(records_in(stage_bytes / 2, sizeof(BlockRecord))),
      pair_capacity_(records_in(stage_bytes / 2, sizeof(PairRecord))),
      blocks_(library.session()),
      block_counts_(library.session()),
      pairs_(library.session()),
      pair_count_(library.session()) {}

void PairSearch::post(const DeviceBuffer<SampleRecord>& samples, std::uint32_t count) {
  samples_ = &samples;
  count_ = count;
  parts_ = (count + kSamplesAtATime - 1) / kSamplesAtATime;
  blocks_.reserve(block_capacity_);
  pairs_.reserve(pair_capacity_);
  block_counts_.clear(parts_);
  pair_count_.clear(1);
  for (std::uint32_t part = 0; part < parts_; ++part) {
    launch_part(part * kSamplesAtATime, std::min(count, (part + 1) * kSamplesAtATime), part);
  }
  library_->session().flush();
}

void PairSearch::launch_part(std::uint32_t first, std::uint32_t end, std::uint32_t part) {
  const DeviceIndex& index = library_->index();
  const DeviceStances& stances = library_->stances();
  const DeviceColours& colours = library_->colours();
  launch(library_->session(), find_blocks_, {end - first, index.root_count(), kSamplesPerGroup}, index.roots(),
         index.node_boxes(), index.block_boxes(), look_at_boxes_, *samples_, first, end, block_capacity_, part,
         block_counts_, blocks_);
  // How many blocks there are is known on the device alone: as many work items as keep it busy share them.
  const std::uint32_t stride = library_->session().compute_units() * 16 * kBlocksPerGroup;
  launch(library_->session(), find_pairs_, {stride, 1, kBlocksPerGroup}, library_->match_buffer(), stances.stances(),
         stances.lists(), stances.shape_class(), index.rows(), index.places(), library_->keypoints(), colours.record(), colours.near_bits(), *samples_, stride, part,
         block_counts_, block_capacity_, blocks_, pair_capacity_, pair_count_, pairs_);
}

std::vector<PairRecord> PairSearch::take() {
  while (true) {
    const std::vector<std::uint32_t> blocks = block_counts_.read(parts_);
    const std::uint32_t most_blocks = blocks.empty() ? 0 : *std::max_element(blocks.begin(), blocks.end());
    const std::uint32_t pairs = pair_count_.read(1).front();
    if (most_blocks <= block_capacity_ && pairs <= pair_capacity_) {
      blocks_visited_ = std::accumulate(blocks.begin(), blocks.end(), std::uint64_t(0));
      return pairs_.read(pairs);
    }
    block_capacity_ = grown(block_capacity_, most_blocks);
    pair_capacity_ = grown(pair_capacity_, pairs);
    post(*samples_, count_);
  }
}

}  // namespace tessera::worker
