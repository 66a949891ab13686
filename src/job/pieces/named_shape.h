// The properties of a shape that wishes of a job refer to.
#pragma once

#include <string>

#include "core/style/style_features.h"

namespace tessera {

struct NamedShape {
  std::string name;          // a mirror image has the name of its drawing
  float drawn_scale_px = 0;  // Shape::drawn_scale_px
  bool mirrored = false;     // it is the drawing's mirror image
  StyleFeatures style = {};
};

}  // namespace tessera
