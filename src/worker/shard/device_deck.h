// Which shapes the random dockings of a question draw from (core/matching/deck.h), on a device.
#pragma once

#include <vector>

#include "core/matching/deck.h"
#include "core/matching/matcher.h"
#include "worker/shard/device_library.h"

namespace tessera::worker {

class DeviceDeck {
 public:
  explicit DeviceDeck(DeviceLibrary& library);

  /// For the draws of these samples. Where the library reads contours, those that may be drawn are there then.
  void deal(const std::vector<TargetSample>& samples);

  /// Shapes of the library; nothing is in it where all_open().
  const DeviceBuffer<std::uint32_t>& open_shapes() const;
  std::uint32_t open_count() const;
  /// Any shape of the library may be drawn.
  bool all_open() const { return deck_.open.empty() && library_->standing().all_open(); }
  /// near_length() shapes of each list of about one colour, the nearest first.
  const DeviceBuffer<std::uint32_t>& near_shapes() const;
  std::uint32_t near_length() const;

 private:
  std::vector<std::uint32_t> open_of_deck() const;
  std::vector<std::uint32_t> near_of_deck() const;
  std::vector<ShapeId> all_drawn() const;

  DeviceLibrary* library_;
  Deck deck_;
  DeviceBuffer<std::uint32_t> open_shapes_;  // of the deck
  DeviceBuffer<std::uint32_t> near_shapes_;  // of the deck
};

}  // namespace tessera::worker
