// Holds contours of a shard's shapes on a device: all of them, or, for a large shard, those that were needed last.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/matching/model_source.h"
#include "records.h"
#include "worker/devices/opencl_runtime.h"

namespace tessera::worker {

class DeviceContours {
 public:
  /// `places`: contours are read when they are needed, and so many of them are kept on the device, or as many as one
  /// question needs. New contours replace the ones that were read first. Without `places` all contours come by add().
  DeviceContours(const DeviceSession& session, const ShapeRange& shard, const ModelSource& models,
                 std::optional<std::uint32_t> places);

  /// Adds the contours of the shard's next shapes.
  void add(const std::vector<ShapeModel>& models);

  /// Whether contours are read when needed. Then need() must be called for all shapes that a launch looks at.
  bool reads() const { return reads_; }
  /// Puts the contours of these shapes of the library on the device, where they belong to the shard. They stay until the
  /// next call. Waits for posted work where something has to make room.
  void need(std::span<const ShapeId> shapes);

  const DeviceBuffer<float>& contours() const { return contours_; }
  /// The place of each shape's contour on the device, by shape of the shard.
  const DeviceBuffer<std::uint32_t>& places() const { return places_; }

 private:
  void make_places(std::size_t count);
  std::uint32_t next_place();
  void read(std::span<const std::uint32_t> shapes);

  ShapeRange shard_;
  const ModelSource* models_;
  bool reads_;
  std::uint32_t added_ = 0;
  DeviceBuffer<float> contours_;
  DeviceBuffer<std::uint32_t> places_;

  static constexpr std::uint32_t kNowhere = 0xffffffffu;
  struct Place {
    std::uint32_t shape = kNowhere;  // of the shard
    std::uint64_t needed = 0;        // number of the last question that needed it
  };
  std::vector<std::uint32_t> place_of_shape_;
  std::vector<Place> held_;       // by place
  std::uint32_t next_place_ = 0;  // the search for a free place goes on here
  std::uint64_t question_ = 0;
};

}  // namespace tessera::worker
