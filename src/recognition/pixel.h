// A place in a grid of pixels.
#pragma once

namespace tessera {

struct Pixel {
  int x = 0;
  int y = 0;
};

}  // namespace tessera
