// A colour as pictures store it: sRGB, red, green and blue as they are coded, 0 to 255. CIELAB and grey of it.
#pragma once

#include "core/colour/lab.h"

namespace tessera {

struct Srgb {
  float red = 0;
  float green = 0;
  float blue = 0;

  friend bool operator==(const Srgb&, const Srgb&) = default;
};

/// CIELAB with D65 as white. It is for measures alone: the powers in it differ in the last bits from machine to
/// machine, and nothing that places a piece may follow from them.
Lab lab_from_srgb(const Srgb& colour);

/// Luma of ITU-R BT.601, 0 to 255: what image programs mean by grey.
float grey_of(const Srgb& colour);

}  // namespace tessera
