// tessera card: the measures of a quality card for pieces that anybody laid, and for mosaics that anybody made.
#pragma once

#include <string>
#include <vector>

namespace tessera {

struct CardArguments {
  std::string pieces;            // GeoJSON, a picture, or the folder of a result
  std::string image;             // the picture that it shows; empty: that of a result's job, if any
  int shown_pieces = 0;          // how many pieces a picture has; 0: not given
  std::string canvas;            // SVG, image or job; empty: a rectangle of this size
  std::vector<int> size_px;      // width and height; empty: not given
  std::vector<double> sizes_px;  // of pieces, the smallest and the largest that might be; empty: not given
  bool json = false;
};

/// Prints the measures. Returns the exit code; throws InputError and EnvironmentError.
int run_card(const CardArguments& arguments);

}  // namespace tessera
