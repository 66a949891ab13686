/// @file
/// Libraries of shapes, as `tessera library build` makes them (HDF5).
///
/// HDF5 serves one thread at a time. This library takes turns with itself; where your program uses HDF5 too, see that no
/// other thread does while one of these functions is called.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "tessera/matching/export.h"
#include "tessera/matching/outline.h"
#include "tessera/matching/pad.h"

namespace tessera::matching {

/// The PADs of a shape are stored at so many smoothing levels; 0 is the coarsest.
inline constexpr int kLibraryLevels = 5;

/// A library file, opened for reading. Shapes are read when they are asked for.
class TESSERA_MATCHING_API Library {
 public:
  /// Throws Error, which names the file, where it is missing, damaged or no library.
  explicit Library(const std::string& path);
  ~Library();
  Library(Library&&) noexcept;
  Library& operator=(Library&&) noexcept;

  std::size_t size() const;

  /// The names of all shapes, in the shapes' order. No name occurs twice.
  const std::vector<std::string>& names() const;

  /// The outline of a shape: its outer curve has 512 evenly spaced points. The origin is the centroid of its area, and the
  /// unit of length is the square root of that area. Throws Error where there is no such shape.
  Outline outline(std::size_t shape) const;

  /// The PADs of a shape's outer curve at a smoothing level, 0 to kLibraryLevels - 1, in units of its outline.
  std::vector<Pad> pads(std::size_t shape, int level) const;

  /// Width of the Gaussian of a level, in units of the outlines: 0.177, and half as wide from level to level.
  static double smoothing(int level);

  /// The parameters with which the library's PADs were made: levels on each side, and the turning of level 0.
  int pad_levels() const;
  double pad_delta_tau_rad() const;

 private:
  friend class KnownOutlines;
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tessera::matching
