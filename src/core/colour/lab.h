// A colour in CIELAB (D65): lightness 0 (black) to 100, a from green to red, b from blue to yellow.
#pragma once

namespace tessera {

struct Lab {
  float lightness = 0;
  float a = 0;
  float b = 0;

  friend bool operator==(const Lab&, const Lab&) = default;
};

}  // namespace tessera
