// The part of an artwork that is drawn: its silhouette and a narrow rim. A soft shadow or a speck beside it would cover
// neighbours or the outside of the canvas.
#pragma once

#include "core/shape/shape.h"

namespace tessera {

/// The shape's outline, wider by a fiftieth of its size, in the shape frame, for even-odd filling.
Outline artwork_clip(const Shape& shape);

/// The outline of the artwork's whole page, for output.clip = "none".
Outline artwork_page_outline(const Shape& shape);

}  // namespace tessera
