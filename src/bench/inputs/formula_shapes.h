// Shapes made from formulas, for benchmarks that need no library.
#pragma once

#include <cstdint>
#include <vector>

#include "core/matching/matching_context.h"
#include "core/shape/outline.h"

namespace tessera::bench {

/// A smooth blob with a few lobes and no straight part; the same number gives the same blob.
TracedOutline blob_outline(std::uint32_t number);

/// Blobs 0 to count - 1, made on all cores.
std::vector<Shape> blob_shapes(std::size_t count);

std::vector<ShapeModel> models_of(const std::vector<Shape>& shapes, const MatchingContext& context);

}  // namespace tessera::bench
