/// @file
/// Descriptors of shapes behind one interface: PAD and your own.
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

/// The interface of a descriptor. Implement it to compare your own descriptor with PAD.
class TESSERA_MATCHING_API Descriptor {
 public:
  virtual ~Descriptor();

  virtual std::string name() const = 0;

  /// The description of an outline that has passed check().
  virtual Description describe(const Outline& outline) const = 0;

  /// The difference of the query from a known description: 0 or more, and 0 for the same description. The query may show
  /// only a part of a shape, so the order of the two may matter.
  virtual double distance(const Description& query, const Description& known) const = 0;
};

/// The descriptor of PADs at the samples of pads_of(). The distance is the mean, over the query's PADs, of pad_distance()
/// to the nearest known PAD. PADs that cannot be compared count 2. So an open curve differs from itself by more than 0, and
/// a straight line by 2; a query without PADs differs from everything by 2. Throws Error where a setting is out of its
/// range.
TESSERA_MATCHING_API std::unique_ptr<Descriptor> make_pad_descriptor(const PadSettings& settings = {});

/// A table of numbers, row by row.
struct Matrix {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<double> values;  ///< rows * columns

  double operator()(std::size_t row, std::size_t column) const { return values[row * columns + column]; }
};

/// The distance of each query (a row) to each known outline (a column). Each outline is described once. Only this thread
/// calls the descriptor. Throws Error that names the outline, like check().
TESSERA_MATCHING_API Matrix distance_matrix(const Descriptor& descriptor, const std::vector<Outline>& queries,
                                            const std::vector<Outline>& known);

}  // namespace tessera::matching
