// Which shapes have about the colour of a place of the target: pairs and most random dockings are made of these alone,
// so that no slot is spent on colours that will not be chosen. Places of about one colour share a list. It follows from
// target, library and limits alone, so that every rank makes the same.
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
  /// A list, or that any shape will do.
  using List = std::uint32_t;
  static constexpr List kAny = 0xffffffffu;

  NearColours() = default;
  /// `depth_px`: how far inside the region, seen from a sample, the colour is looked up.
  NearColours(ColourWish wish, float depth_px) : wish_(std::move(wish)), depth_px_(depth_px) {}
  void set_depth(float depth_px) { depth_px_ = depth_px; }

  /// The lists are of shapes that may stand by this table. Those there were are gone; which shapes are nearest to a
  /// colour is not looked for again, so that it may be called each round.
  void start(const StanceTable& stances);
  /// The list for the sample, made where there is none yet.
  List list_for(const TargetSample& sample);

  /// So many shapes are in each list.
  std::uint32_t length() const { return length_; }
  /// Nearest first.
  std::span<const std::uint32_t> shapes(List list) const {
    return {shapes_.data() + std::size_t(list) * length_, length_};
  }
  bool holds(List list, ShapeId shape) const;

  // The same of all lists one after the other: length() shapes each; a bit for each shape of the library, words()
  // numbers each.
  const std::vector<std::uint32_t>& all_shapes() const { return shapes_; }
  const std::vector<std::uint32_t>& all_bits() const { return bits_; }
  std::uint32_t words() const { return words_; }

 private:
  using Point = std::array<int, 3>;  // of the lattice
  const std::vector<std::uint32_t>& nearest(const Point& point);
  List make_list(const Point& point);

  ColourWish wish_;
  float depth_px_ = 0;
  std::map<Point, std::vector<std::uint32_t>> nearest_;  // of the whole library, whatever the limits: a cache
  std::vector<bool> open_;
  std::uint32_t length_ = 0;
  std::uint32_t words_ = 0;
  std::map<Point, List> lists_;
  std::vector<std::uint32_t> shapes_;
  std::vector<std::uint32_t> bits_;
};

}  // namespace tessera
