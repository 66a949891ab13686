#include "render/ground_strips.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

namespace tessera {
namespace {

/// The page at the size that it has in the picture: averaged where that is smaller, never enlarged.
cv::Mat as_in_picture(const cv::Mat& page, cv::Size2d tile_px) {
  const auto side = [](double px, int most) { return std::clamp(int(std::ceil(px - 1e-6)), 1, most); };
  const cv::Size size(side(tile_px.width, page.cols), side(tile_px.height, page.rows));
  if (size == page.size()) return page;
  cv::Mat tile;
  cv::resize(page, tile, size, 0, 0, cv::INTER_AREA);
  return tile;
}

}  // namespace

GroundStrips::GroundStrips(const GroundTile& tile, double picture_px, cv::Size picture) {
  if (tile.page.empty()) return;
  repeats_ = tile.repeats;
  const cv::Size2d tile_px(tile.size_px.width * picture_px, tile.size_px.height * picture_px);
  tile_ = as_in_picture(tile.page, tile_px);
  height_px_ = tile_px.height;
  for (int x = 0; x < picture.width; ++x) columns_.push_back(place_of(x, tile_px.width, tile_.cols));
}

GroundStrips::Place GroundStrips::place_of(int at, double tile_px, int tile_cells) const {
  const double tiles = (at + 0.5) / tile_px;
  const double cell = (tiles - std::floor(tiles)) * tile_cells - 0.5;
  const double before = std::floor(cell);
  const int second_share = int(std::lround((cell - before) * 256));
  if (!repeats_) {
    const int last = tile_cells - 1;
    return {std::clamp(int(before), 0, last), std::clamp(int(before) + 1, 0, last), second_share};
  }
  const int first = (int(before) + tile_cells) % tile_cells;
  return {first, (first + 1) % tile_cells, second_share};
}

cv::Mat GroundStrips::rows(int top, int count) const {
  cv::Mat drawn(count, int(columns_.size()), CV_8UC4);
  std::vector<cv::Vec4i> across(std::size_t(tile_.cols));  // of the tile, between two of its rows, times 256
  for (int y = 0; y < count; ++y) {
    const Place row = place_of(top + y, height_px_, tile_.rows);
    const cv::Vec4b* upper = tile_.ptr<cv::Vec4b>(row.first);
    const cv::Vec4b* lower = tile_.ptr<cv::Vec4b>(row.second);
    for (int x = 0; x < tile_.cols; ++x) {
      for (int c = 0; c < 4; ++c) {
        across[std::size_t(x)][c] = upper[x][c] * (256 - row.second_share) + lower[x][c] * row.second_share;
      }
    }
    cv::Vec4b* to = drawn.ptr<cv::Vec4b>(y);
    for (const Place& column : columns_) {
      const cv::Vec4i& left = across[std::size_t(column.first)];
      const cv::Vec4i& right = across[std::size_t(column.second)];
      for (int c = 0; c < 4; ++c) {
        const int sum = left[c] * (256 - column.second_share) + right[c] * column.second_share;
        (*to)[c] = std::uint8_t((sum + (1 << 15)) >> 16);
      }
      ++to;
    }
  }
  return drawn;
}

}  // namespace tessera
