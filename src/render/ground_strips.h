// Draws the ground below the pieces, or the overlay above them, as pixels, strip by strip.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "layers/ground_tile.h"

namespace tessera {

class GroundStrips {
 public:
  /// `picture_px`: px of the picture for one px of the canvas. Without a tile there is nothing to draw.
  GroundStrips(const GroundTile& tile, double picture_px, cv::Size picture);

  bool empty() const { return tile_.empty(); }

  /// The rows from `top` on, `count` of them, in the full width of the picture: premultiplied BGRA, CV_8UC4. A tile is not
  /// blurred where its size is a whole number of px of the picture and not larger than its page. Rows do not depend on each
  /// other.
  cv::Mat rows(int top, int count) const;

 private:
  /// The place of a pixel's middle in the tile: two neighbouring px, and the share of the second in 256ths.
  struct Place {
    int first = 0;
    int second = 0;
    int second_share = 0;
  };

  Place place_of(int at, double tile_px, int tile_cells) const;

  bool repeats_ = true;
  cv::Mat tile_;          // premultiplied BGRA, as large as in the picture or smaller
  double height_px_ = 0;  // of a tile, px of the picture
  std::vector<Place> columns_;
};

}  // namespace tessera
