// A colour as pictures store it: sRGB, coded red, green and blue, 0 to 255; with its CIELAB and grey values.
#pragma once

#include "core/colour/lab.h"

namespace tessera {

struct Srgb {
  float red = 0;
  float green = 0;
  float blue = 0;

  friend bool operator==(const Srgb&, const Srgb&) = default;
};

/// CIELAB with white D65. For measures only: its powers differ in the last bits between machines, so the placement of
/// pieces must not depend on it.
Lab lab_from_srgb(const Srgb& colour);

/// Luma of ITU-R BT.601, 0 to 255: the grey of image programs.
float grey_of(const Srgb& colour);

}  // namespace tessera
