// A digest of one part of a shape as its columns hold it (outline, field, a smoothing level). The library file stores it,
// so that a few bytes for each shape identify the library, and every part that is read is compared with it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "core/base/digest.h"
#include "core/shape/shape.h"

namespace tessera {

class PartDigest {
 public:
  /// Adds the number of bytes, then the bytes.
  template <class T>
  PartDigest& add(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    add_bytes(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    return *this;
  }
  template <class T>
  PartDigest& add(const T& value) {
    return add(std::span<const T>(&value, 1));
  }

  std::uint64_t value() const {
    Digest whole;
    for (const Digest& lane : lanes_) whole.add(lane.value());
    return whole.value();
  }

 private:
  /// Words are digested in four independent chains, which takes a third of the time of one chain.
  static constexpr std::size_t kLanes = 4;

  void add_bytes(const char* bytes, std::size_t count) {
    std::array<std::uint64_t, kLanes> words{};
    lanes_[0].add(count);
    while (count > 0) {
      const std::size_t part = count < sizeof words ? count : sizeof words;
      if (part < sizeof words) words.fill(0);
      std::memcpy(words.data(), bytes, part);
      for (std::size_t k = 0; k < kLanes; ++k) lanes_[k].add(words[k]);
      bytes += part;
      count -= part;
    }
  }

  std::array<Digest, kLanes> lanes_;
};

inline std::uint64_t outline_digest(const Outline& outline) {
  PartDigest digest;
  for (const std::vector<Vec2>& curve : outline.curves) digest.add(std::span<const Vec2>(curve));
  return digest.value();
}

/// `quantised`: the distances in steps of `step` shape units.
inline std::uint64_t field_digest(std::span<const std::int16_t> quantised, float step, float extent) {
  return PartDigest().add(quantised).add(step).add(extent).value();
}

/// A smoothing level in the form of the file.
struct LevelRows {
  std::span<const Vec2> points;
  float perimeter;
  std::span<const float> lengths;
  std::span<const Vec2> keypoints;
  std::span<const float> convexity;
};

inline std::uint64_t level_digest(const LevelRows& level) {
  PartDigest digest;
  digest.add(level.points).add(level.perimeter).add(level.lengths).add(level.keypoints).add(level.convexity);
  return digest.value();
}

}  // namespace tessera
