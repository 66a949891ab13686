/// @file
/// Libraries of shapes, as `tessera library build` makes them (HDF5).
///
/// HDF5 serves one thread at a time. This library takes care of its own calls. Where your program uses HDF5, too, let no
/// other thread use HDF5 during a call of these functions.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "tessera/matching/export.h"
#include "tessera/matching/outline.h"
#include "tessera/matching/pad.h"

namespace tessera::matching {

/// The number of smoothing levels at which a shape's PADs are stored; 0 is the coarsest level.
inline constexpr int kLibraryLevels = 5;

/// A library file, opened for reading. Shapes are read when they are needed.
class TESSERA_MATCHING_API Library {
 public:
  /// Throws Error that names the file where it is missing, damaged or no library.
  explicit Library(const std::string& path);
  ~Library();
  Library(Library&&) noexcept;
  Library& operator=(Library&&) noexcept;

  std::size_t size() const;

  /// The names of all shapes, in the order of the shapes. No name occurs twice.
  const std::vector<std::string>& names() const;

  /// The outline of a shape. Its outer curve has 512 evenly spaced points. The origin is the centroid of its area, the unit
  /// of length is the square root of that area. Throws Error where there is no such shape.
  Outline outline(std::size_t shape) const;

  /// The PADs of a shape's outer curve at a smoothing level, 0 to kLibraryLevels - 1, in units of its outline.
  std::vector<Pad> pads(std::size_t shape, int level) const;

  /// The width of a level's Gaussian, in units of the outlines: 0.177 at level 0, and half as wide at each next level.
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
