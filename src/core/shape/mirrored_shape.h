// The mirror image of a library shape.
#pragma once

#include "core/shape/shape.h"

namespace tessera {

/// Mirrored at the y axis of the shape frame, and run through backwards, so that the interior stays on the left. No
/// number is computed but x -> -x: what was exact stays exact, and the mirror image of the mirror image is the shape.
/// `pad_levels`: of the shape's pyramids. Parts that were not read stay empty. The artwork is the same, and said to be
/// mirrored (Artwork::mirrored).
Shape mirror_image(Shape shape, int pad_levels);

}  // namespace tessera
