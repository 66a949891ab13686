// Holds the index of a shard's PADs on a device.
#pragma once

#include "core/matching/model_source.h"
#include "worker/devices/opencl_runtime.h"
#include "worker/shard/index_rows.h"

namespace tessera::worker {

class DeviceIndex {
 public:
  /// `models` may know the order of the PADs that are added.
  DeviceIndex(const DeviceSession& session, const MatchRecord& match, const IndexKind& kind, const ModelSource& models);

  /// Adds the PADs of the shard's next shapes, all sources of each shape. To be called until all shapes are there.
  void add(IndexedPads pads);

  const IndexKind& kind() const { return kind_; }
  const DeviceBuffer<RootRecord>& roots() const { return roots_; }
  std::uint32_t root_count() const { return root_count_; }
  /// The number of blocks, including those that fill up nodes.
  std::uint32_t block_count() const;
  const DeviceBuffer<std::uint8_t>& node_boxes() const { return node_boxes_; }
  const DeviceBuffer<std::uint8_t>& block_boxes() const { return block_boxes_; }
  const DeviceBuffer<std::uint8_t>& rows() const { return rows_; }
  const DeviceBuffer<std::uint16_t>& places() const { return places_; }
  /// The chords, empty where no rotation is limited.
  const DeviceBuffer<ChordRecord>& chords() const { return chords_; }

 private:
  void add_segment();
  IndexRows rows_of(const IndexPart& part) const;
  void upload(const IndexPart& part, IndexRows made);

  const DeviceSession* session_;
  MatchRecord match_;
  IndexKind kind_;
  const ModelSource* models_;
  std::vector<IndexPart> parts_;
  std::size_t next_part_ = 0;
  IndexedPads waiting_;  // PADs of the next part's segment, from its first shape on
  std::uint32_t root_count_ = 0;
  DeviceBuffer<RootRecord> roots_;
  DeviceBuffer<std::uint8_t> node_boxes_;
  DeviceBuffer<std::uint8_t> block_boxes_;
  DeviceBuffer<std::uint8_t> rows_;
  DeviceBuffer<std::uint16_t> places_;
  DeviceBuffer<ChordRecord> chords_;
};

}  // namespace tessera::worker
