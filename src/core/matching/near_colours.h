// Lists of the shapes whose colour is near the colour of a place of the target. Pairs and most random dockings use
// these shapes only, so that no slot is spent on colours that would not be chosen. Places of similar colour share a
// list. Lists follow from target, library and limits alone, so that every rank makes the same.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "core/colour/colour_wish.h"
#include "core/field/target_sample.h"
#include "core/matching/stances.h"

namespace tessera {

class NearColours {
 public:
  /// The number of a list, or kAny for any shape.
  using List = std::uint32_t;
  static constexpr List kAny = 0xffffffffu;

  NearColours() = default;
  /// `depth_px`: distance from a sample into the free region at which the colour is looked up.
  NearColours(ColourWish wish, float depth_px) : wish_(std::move(wish)), depth_px_(depth_px) {}
  void set_depth(float depth_px) { depth_px_ = depth_px; }

  /// Begins new lists of the shapes that may stand by this table; the former lists are gone. The order of shapes by
  /// colour stays in a cache, so that this may be called each round.
  void start(const StanceTable& stances);
  /// The list for the sample. Makes the list if there is none yet.
  List list_for(const TargetSample& sample);

  /// The number of shapes in each list.
  std::uint32_t length() const { return length_; }
  /// The shapes of a list, nearest first.
  std::span<const std::uint32_t> shapes(List list) const {
    return {shapes_.data() + std::size_t(list) * length_, length_};
  }
  bool holds(List list, ShapeId shape) const;

  // All lists, one after the other: length() shapes each, and a bit for each shape of the library in words() numbers
  // each.
  const std::vector<std::uint32_t>& all_shapes() const { return shapes_; }
  const std::vector<std::uint32_t>& all_bits() const { return bits_; }
  std::uint32_t words() const { return words_; }

 private:
  using Point = std::array<int, 3>;  // of the lattice in CIELAB
  const std::vector<std::uint32_t>& nearest(const Point& point);
  List make_list(const Point& point);

  ColourWish wish_;
  float depth_px_ = 0;
  std::map<Point, std::vector<std::uint32_t>> nearest_;  // cache: all shapes of the library, whatever the limits
  std::vector<bool> open_;
  std::uint32_t length_ = 0;
  std::uint32_t words_ = 0;
  std::map<Point, List> lists_;
  std::vector<std::uint32_t> shapes_;
  std::vector<std::uint32_t> bits_;
};

}  // namespace tessera
