// Whether the parts of a shape belong together. A library file may come from anywhere: a field that is not its
// outline's would let pieces overlap without anyone noticing.
#pragma once

#include <string>

#include "core/shape/shape.h"

namespace tessera {

/// Looks at outline, perimeter, radius and field: area 1, lengths that are the outline's, and a field that has the
/// right sign at every node, changes no faster than a distance can, is zero along the outline and exact at one node of
/// every 8 x 8 (which one depends on the shape). It takes half a millisecond. The text is empty where nothing
/// contradicts, otherwise it says what does.
std::string shape_contradiction(const Shape& shape);

}  // namespace tessera
