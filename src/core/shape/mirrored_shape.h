// The mirror image of a library shape.
#pragma once

#include "core/shape/shape.h"

namespace tessera {

/// The shape mirrored at the y axis of the shape frame. Its curves run backwards, so that the interior stays on the
/// left. The only computation is x -> -x: exact values stay exact, and the mirror image of the mirror image is the
/// shape itself. `pad_levels`: number of levels of the shape's pyramids. Parts that were not read stay empty. The
/// artwork is the same, marked as mirrored (Artwork::mirrored).
Shape mirror_image(Shape shape, int pad_levels);

}  // namespace tessera
