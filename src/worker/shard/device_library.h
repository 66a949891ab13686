// Holds what stays on a device from request to request: the shard and the free field.
#pragma once

#include <optional>

#include "core/matching/matching_context.h"
#include "core/matching/model_source.h"
#include "worker/devices/kernel_options.h"
#include "worker/devices/opencl_runtime.h"
#include "worker/shard/device_colours.h"
#include "worker/shard/device_contours.h"
#include "worker/shard/device_index.h"
#include "worker/shard/device_stances.h"
#include "worker/shard/pair_keypoints.h"
#include "worker/shard/shard.h"

namespace tessera::worker {

class DeviceLibrary {
 public:
  DeviceLibrary(const cl::Device& device, const MatchingContext& context, const ShapeRange& shapes,
                std::shared_ptr<const ModelSource> models, const BetweenLaunches& between_launches = {},
                const HeldShapes& held = {}, std::optional<DockingLanes> lanes = std::nullopt);

  void start_field(int width, int height, Vec2 origin);
  void update_field(const std::vector<FieldPatch>& patches);
  void limit(const StanceLimits& limits);

  const DeviceSession& session() const { return session_; }
  int pad_levels() const { return pad_levels_; }
  DockingLanes lanes() const { return lanes_; }
  const MatchRecord& match() const { return match_; }
  const DeviceBuffer<MatchRecord>& match_buffer() const { return match_buffer_; }
  const DeviceIndex& index() const { return index_; }
  const PairKeypoints& keypoints() const { return keypoints_; }
  const DeviceBuffer<float>& sketches() const { return sketches_; }
  const DeviceContours& contours() const { return contours_; }
  DeviceContours& contours() { return contours_; }
  const DeviceBuffer<ShapeRecord>& shapes() const { return shapes_; }
  const DeviceBuffer<float>& field() const { return field_; }
  const DeviceBuffer<float>& size_map() const { return size_map_; }
  /// The stances in which shapes may stand at the moment.
  const StanceTable& standing() const { return context_.stances; }
  const DeviceStances& stances() const { return stances_; }
  const DeviceColours& colours() const { return colours_; }
  DeviceColours& colours() { return colours_; }

 private:
  void load(const BetweenLaunches& between_launches);
  /// Models of some shapes, and their PADs where the models come without levels.
  struct Loaded {
    std::vector<ShapeModel> models;
    std::vector<LibraryPad> pads;
  };
  void add(Loaded loaded, std::uint32_t first);

  std::shared_ptr<const ModelSource> models_;
  int pad_levels_;
  bool reads_;
  DockingLanes lanes_;
  DeviceSession session_;
  MatchRecord match_;
  DeviceBuffer<MatchRecord> match_buffer_;
  DeviceIndex index_;
  PairKeypoints keypoints_;
  DeviceBuffer<float> sketches_;
  DeviceContours contours_;
  DeviceBuffer<ShapeRecord> shapes_;
  DeviceBuffer<float> field_;
  DeviceBuffer<float> size_map_;
  StanceTable all_stances_;
  MatchingContext context_;  // within the limits
  float size_factor_ = 1;    // of the limits
  DeviceStances stances_;
  DeviceColours colours_;
};

}  // namespace tessera::worker
