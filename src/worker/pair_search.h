// Searches for pairs within reach on a device. The index says which blocks may hold such pairs; the PADs of these blocks
// are tested (kernels/pad_index.cl, pairs.cl).
#pragma once

#include <optional>

#include "worker/devices/device_kernel.h"
#include "worker/shard/device_library.h"

namespace tessera::worker {

inline constexpr std::size_t kMostGrowth = 32;

class PairSearch {
 public:
  /// `stage_bytes`: room for blocks and pairs on the device at first. A question that finds more is asked again with
  /// more room: for several samples up to kMostGrowth times as much, for one sample as much as needed.
  PairSearch(const DeviceLibrary& library, std::size_t stage_bytes);

  /// Searches for pairs nearer than each sample's reach, in every `segment_stride`-th segment. `samples` must stay until
  /// take() has returned.
  void post(const DeviceBuffer<SampleRecord>& samples, std::uint32_t count, std::uint32_t segment_stride = 1);
  /// The pairs, in no particular order. Empty where several samples have more pairs than there may be room for: post fewer
  /// samples then.
  std::optional<std::vector<PairRecord>> take();

  /// Makes later searches look at all blocks, to measure what the index saves.
  void scan_all() { look_at_boxes_ = 0; }
  /// The number of blocks visited by all searches so far.
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
