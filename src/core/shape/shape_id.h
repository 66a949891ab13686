// Names of shapes and of parts of a library.
#pragma once

#include <cstdint>

namespace tessera {

/// A shape, by its index in the whole library: the same on every rank, whatever part of the library it holds. An index
/// within a part is a plain number.
enum class ShapeId : std::uint32_t {};

constexpr std::uint32_t index_of(ShapeId shape) { return std::uint32_t(shape); }

/// The shapes [begin, end) of the library.
struct ShapeRange {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  std::uint32_t size() const { return end - begin; }
  bool contains(ShapeId shape) const { return index_of(shape) >= begin && index_of(shape) < end; }
  /// The index of a shape within the range, and the shape at such an index.
  std::uint32_t position_of(ShapeId shape) const { return index_of(shape) - begin; }
  ShapeId at(std::uint32_t position) const { return ShapeId(begin + position); }
};

}  // namespace tessera
