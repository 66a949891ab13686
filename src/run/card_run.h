// tessera card: measures the quality of pieces that anybody laid, and of mosaics that anybody made.
#pragma once

#include <string>
#include <vector>

namespace tessera {

struct CardArguments {
  std::string pieces;            // GeoJSON, a picture, or the folder of a result
  std::string image;             // the picture that it shows; empty: the one of a result's job, if any
  int shown_pieces = 0;          // the number of pieces in a picture; 0: not given
  std::string canvas;            // SVG, image or job; empty: a rectangle of this size
  std::vector<int> size_px;      // width and height; empty: not given
  std::vector<double> sizes_px;  // smallest and largest possible piece; empty: not given
  bool json = false;
};

/// Prints the measures. Returns the exit code; throws InputError and EnvironmentError.
int run_card(const CardArguments& arguments);

}  // namespace tessera
