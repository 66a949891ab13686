// A known outline in the form that recognition needs: like a shape of a library, but in no file.
#pragma once

#include "core/geometry/polygon.h"
#include "core/shape/shape_model.h"
#include "tessera/matching/outline.h"

namespace tessera::matching {

struct KnownShape {
  ShapeModel model;          // with the levels that are searched
  tessera::Outline outline;  // shape frame
  Similarity shape_from_own;
};

/// Makes the shape of the closed curve with the largest area and the holes within it. Throws Error as KnownOutlines does.
KnownShape make_known_shape(const Outline& outline);

}  // namespace tessera::matching
