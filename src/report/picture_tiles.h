// A picture as a pyramid of WebP tiles, for pages that zoom. web/src/data.ts (PictureData) has the page's side.
#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace tessera {

inline constexpr int kPictureTile_px = 512;

struct PictureLevel {
  cv::Size size_px;
  int columns = 0;
  std::vector<std::vector<std::uint8_t>> tiles;  // row by row
};

/// The largest level first; each further one has half the size, rounded up. The last one is a single tile.
using PicturePyramid = std::vector<PictureLevel>;

std::size_t bytes_of(const PicturePyramid& pyramid);

/// The pyramid of a picture of straight BGRA, CV_8UC4. Its first level has the picture's size, or is smaller so that all
/// tiles together have `most_bytes` or less; one tile is always made. The same picture gives the same bytes. Throws
/// EnvironmentError where WebP finds no memory.
PicturePyramid picture_pyramid(const cv::Mat& bgra, std::size_t most_bytes);

}  // namespace tessera
