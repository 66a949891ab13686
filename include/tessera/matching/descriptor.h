/// @file
/// Descriptors of shapes as an interface: PAD's own, and anyone's.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "tessera/matching/export.h"
#include "tessera/matching/outline.h"
#include "tessera/matching/pad.h"

namespace tessera::matching {

/// The numbers by which a descriptor describes an outline. Only the descriptor knows what the numbers mean.
using Description = std::vector<double>;

/// Implement it to compare a descriptor of your own with PAD.
class TESSERA_MATCHING_API Descriptor {
 public:
  virtual ~Descriptor();

  virtual std::string name() const = 0;

  /// `outline` has passed check().
  virtual Description describe(const Outline& outline) const = 0;

  /// How much the query differs from what is known, 0 or more; 0 for one and the same description. The query may show a
  /// part of a shape, so that the order of both may matter.
  virtual double distance(const Description& query, const Description& known) const = 0;
};

/// PADs at the samples of pads_of(). The distance is the mean, over the query's PADs, of that to the nearest PAD that is known
/// (pad_distance()); PADs that cannot be compared count 2. So an open curve differs from itself by more than 0, and a straight
/// line by 2; a query without PADs differs by 2 from everything. Throws Error where a setting is out of its range.
TESSERA_MATCHING_API std::unique_ptr<Descriptor> make_pad_descriptor(const PadSettings& settings = {});

/// A table of numbers, row by row.
struct Matrix {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<double> values;  ///< rows * columns

  double operator()(std::size_t row, std::size_t column) const { return values[row * columns + column]; }
};

/// The distance of each query (a row) to each known outline (a column). Each outline is described once. The
/// descriptor is called by this thread alone. Throws Error, which names the outline, as check() does.
TESSERA_MATCHING_API Matrix distance_matrix(const Descriptor& descriptor, const std::vector<Outline>& queries,
                                            const std::vector<Outline>& known);

}  // namespace tessera::matching
