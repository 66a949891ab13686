// Holds the deck of a question on a device: the shapes that its random dockings draw from (core/matching/deck.h).
#pragma once

#include <vector>

#include "core/matching/deck.h"
#include "core/matching/matcher.h"
#include "worker/shard/device_library.h"

namespace tessera::worker {

class DeviceDeck {
 public:
  explicit DeviceDeck(DeviceLibrary& library);

  /// Draws the deck for these samples. Where the library reads contours when needed, the contours of all shapes of the deck
  /// are on the device afterwards.
  void draw(const std::vector<TargetSample>& samples);

  /// The shapes of the deck, as shapes of the library; empty where all_open().
  const DeviceBuffer<std::uint32_t>& open_shapes() const;
  std::uint32_t open_count() const;
  /// Whether any shape of the library may be drawn.
  bool all_open() const { return deck_.open.empty() && library_->standing().all_open(); }
  /// The first near_length() shapes of each list of about one colour, the nearest first.
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
