// The contours of a shard's shapes on a device: all of them, or of a large shard those that were needed last.
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
  /// `places`: contours are read as they are needed, so many are kept on the device, or as many as one question needs;
  /// what is read takes the places of what was read first. Nothing: all come by add().
  DeviceContours(const DeviceSession& session, const ShapeRange& shard, const ModelSource& models,
                 std::optional<std::uint32_t> places);

  /// The contours of the shard's next shapes.
  void add(const std::vector<ShapeModel>& models);

  /// Whether contours are read: then need() must be called for all that a launch looks at.
  bool reads() const { return reads_; }
  /// From here on to the next call the contours of these shapes of the library are on the device, if they are of the
  /// shard. Waits for what was posted where something has to make room.
  void need(std::span<const ShapeId> shapes);

  const DeviceBuffer<float>& contours() const { return contours_; }
  /// By shape of the shard: the place of its contour among those on the device.
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
    std::uint64_t needed = 0;        // the last question that needed it
  };
  std::vector<std::uint32_t> place_of_shape_;
  std::vector<Place> held_;  // by place
  std::uint32_t hand_ = 0;   // where the search for a free place goes on
  std::uint64_t question_ = 0;
};

}  // namespace tessera::worker
