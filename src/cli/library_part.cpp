#include "cli/library_part.h"

#include <cstdint>
#include <vector>

#include "core/ranks/partition.h"

namespace tessera::cli {

ShapeRange library_part(std::size_t shapes, int part, int parts) {
  const std::vector<std::uint64_t> weights(shapes, 1);
  return balanced_ranges(weights, parts)[std::size_t(part)];
}

}  // namespace tessera::cli
