// What a job's wishes need to know of a shape.
#pragma once

#include <string>

#include "core/style/style_features.h"

namespace tessera {

struct NamedShape {
  std::string name;          // a mirror image has that of its drawing
  float drawn_scale_px = 0;  // Shape::drawn_scale_px
  bool mirrored = false;     // the drawing's mirror image
  StyleFeatures style = {};
};

}  // namespace tessera
