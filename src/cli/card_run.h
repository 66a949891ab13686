// tessera card: the measures of a quality card for pieces that anybody laid.
#pragma once

#include <string>
#include <vector>

namespace tessera::cli {

struct CardArguments {
  std::string pieces;            // GeoJSON
  std::string canvas;            // SVG, image or job; empty: a rectangle of this size
  std::vector<int> size_px;      // width and height; empty: not given
  std::vector<double> sizes_px;  // of pieces, the smallest and the largest that might be; empty: not given
  bool json = false;
};

/// Prints the measures. Returns the exit code; throws InputError and EnvironmentError.
int run_card(const CardArguments& arguments);

}  // namespace tessera::cli
