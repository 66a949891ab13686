// The ground of the pieces, or what is laid over them, as pixels, strip by strip.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "layers/ground_tile.h"

namespace tessera {

class GroundStrips {
 public:
  /// A px of the canvas has `picture_px` of the picture. Without a tile there is nothing to draw.
  GroundStrips(const GroundTile& tile, double picture_px, cv::Size picture);

  bool empty() const { return tile_.empty(); }

  /// So many rows of the picture from row `top` on, in its full width: premultiplied BGRA, CV_8UC4. A tile that is a
  /// whole number of px of the picture large, and no larger than its page, is not blurred. Rows do not depend on each
  /// other.
  cv::Mat rows(int top, int count) const;

 private:
  /// What lies at the middle of a px of the picture: two neighbours in the tile, and how much of 256 the second has.
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
