// What of an artwork is drawn: its silhouette and a narrow rim. A soft shadow or a speck beside it would paint over the
// neighbours, or outside the canvas.
#pragma once

#include "core/shape/shape.h"

namespace tessera {

/// The shape's outline, wider by a fiftieth of its size; shape frame, for even-odd filling.
Outline artwork_clip(const Shape& shape);

/// The whole page of the artwork, for who wants all of it.
Outline artwork_page_outline(const Shape& shape);

}  // namespace tessera
