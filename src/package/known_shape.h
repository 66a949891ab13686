// A known outline as recognition needs it: a shape of a library that lies in no file.
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

/// The closed curve with the largest area, with the holes within it. Throws Error as KnownOutlines does.
KnownShape make_known_shape(const Outline& outline);

}  // namespace tessera::matching
