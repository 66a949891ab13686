// The search for pairs within reach on a device: the index says which blocks may hold some, their PADs are tested
// (kernels/pad_index.cl, pairs.cl).
#pragma once

#include <optional>

#include "worker/devices/device_kernel.h"
#include "worker/shard/device_library.h"

namespace tessera::worker {

inline constexpr std::size_t kMostGrowth = 32;

class PairSearch {
 public:
  /// `stage_bytes`: of blocks and pairs on the device at first; where a question finds more, it is asked again with
  /// more room, up to kMostGrowth times as much for several samples, and as much as it takes for one.
  PairSearch(const DeviceLibrary& library, std::size_t stage_bytes);

  /// Searches for pairs nearer than each sample's reach, in every segment whose number is a multiple of
  /// `segment_stride`. `samples` must stay until they are taken.
  void post(const DeviceBuffer<SampleRecord>& samples, std::uint32_t count, std::uint32_t segment_stride = 1);
  /// In no particular order. Nothing where several samples have more than there may be room for: ask for fewer at a time.
  std::optional<std::vector<PairRecord>> take();

  /// From here on all blocks are looked at, to measure what the index saves.
  void scan_all() { look_at_boxes_ = 0; }
  /// Of all questions so far.
  std::uint64_t blocks_visited() const { return blocks_visited_; }

 private:
  void launch_blocks();
  void launch_pairs();

  const DeviceLibrary* library_;
  DeviceKernel find_blocks_;
  DeviceKernel find_pairs_;
  const DeviceBuffer<SampleRecord>* samples_ = nullptr;
  std::uint32_t count_ = 0;
  std::uint32_t segment_stride_ = 1;
  std::uint32_t look_at_boxes_ = 1;
  std::uint32_t block_room_;
  std::uint32_t pair_room_;
  std::size_t most_bytes_;
  std::uint64_t blocks_visited_ = 0;
  DeviceBuffer<BlockRecord> blocks_;
  DeviceBuffer<std::uint32_t> block_count_;
  DeviceBuffer<PairRecord> pairs_;
  DeviceBuffer<std::uint32_t> pair_count_;
};

}  // namespace tessera::worker
