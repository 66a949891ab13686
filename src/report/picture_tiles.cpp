#include "report/picture_tiles.h"

#include <webp/encode.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "artwork/images/alpha.h"
#include "core/base/error.h"
#include "core/base/rank_pool.h"

namespace tessera {
namespace {

constexpr float kQuality = 82;  // of 100; below 80 flat colours of clip art show blocks when they are enlarged
constexpr int kMethod = 3;      // of 6: slower ones save 2 % of the bytes
/// A level is made smaller by at least this factor until it keeps to its limit.
constexpr double kLeastShrinking = 0.93;

struct FreePicture {
  void operator()(WebPPicture* picture) const { WebPPictureFree(picture); }
};

std::vector<std::uint8_t> encoded(const cv::Mat& bgra) {
  WebPConfig config;
  WebPPicture picture;
  if (!WebPConfigPreset(&config, WEBP_PRESET_DRAWING, kQuality) || !WebPPictureInit(&picture)) {
    throw EnvironmentError("WebP: the library has another version than its headers");
  }
  const std::unique_ptr<WebPPicture, FreePicture> owner(&picture);
  config.method = kMethod;
  picture.width = bgra.cols;
  picture.height = bgra.rows;
  WebPMemoryWriter writer;
  WebPMemoryWriterInit(&writer);
  picture.writer = WebPMemoryWrite;
  picture.custom_ptr = &writer;
  const bool done = WebPPictureImportBGRA(&picture, bgra.data, int(bgra.step)) && WebPEncode(&config, &picture);
  std::vector<std::uint8_t> bytes(writer.mem, writer.mem + writer.size);
  WebPMemoryWriterClear(&writer);
  if (!done) throw EnvironmentError("WebP: cannot encode a picture, error " + std::to_string(picture.error_code));
  return bytes;
}

/// A picture in another size; its pixels are averaged with their alpha.
cv::Mat resized(const cv::Mat& bgra, cv::Size size_px) {
  cv::Mat result;
  cv::resize(premultiplied(bgra), result, size_px, 0, 0, cv::INTER_AREA);
  straighten(result);
  return result;
}

cv::Rect tile_at(const cv::Mat& bgra, int columns, std::size_t tile) {
  const cv::Point at(int(tile) % columns * kPictureTile_px, int(tile) / columns * kPictureTile_px);
  return cv::Rect(at, cv::Size(kPictureTile_px, kPictureTile_px)) & cv::Rect({}, bgra.size());
}

PictureLevel level_of(const cv::Mat& bgra) {
  const auto tiles_along = [](int side_px) { return (side_px + kPictureTile_px - 1) / kPictureTile_px; };
  PictureLevel level{bgra.size(), tiles_along(bgra.cols), {}};
  level.tiles.resize(std::size_t(level.columns) * tiles_along(bgra.rows));
  parallel_for(level.tiles.size(),
               [&](std::size_t k) { level.tiles[k] = encoded(bgra(tile_at(bgra, level.columns, k))); });
  return level;
}

bool fits_a_tile(cv::Size size_px) { return std::max(size_px.width, size_px.height) <= kPictureTile_px; }

PicturePyramid whole_pyramid(cv::Mat bgra) {
  PicturePyramid pyramid;
  while (true) {
    pyramid.push_back(level_of(bgra));
    if (fits_a_tile(bgra.size())) return pyramid;
    bgra = resized(bgra, {(bgra.cols + 1) / 2, (bgra.rows + 1) / 2});
  }
}

/// The factor on the sides with which the pyramid probably has `most_bytes`, judged by every eighth tile of the first level.
double expected_scale(const cv::Mat& bgra, std::size_t most_bytes) {
  constexpr std::size_t kEvery = 8;
  constexpr double kLevels = 4. / 3;  // all levels, as a multiple of the first one's px
  const int columns = (bgra.cols + kPictureTile_px - 1) / kPictureTile_px;
  const int rows = (bgra.rows + kPictureTile_px - 1) / kPictureTile_px;
  const std::size_t tiles = std::size_t(columns) * rows;
  if (tiles < 2 * kEvery) return 1;
  std::vector<std::size_t> bytes(tiles / kEvery), px(tiles / kEvery);
  parallel_for(bytes.size(), [&](std::size_t k) {
    const cv::Mat tile = bgra(tile_at(bgra, columns, k * kEvery));
    bytes[k] = encoded(tile).size();
    px[k] = tile.total();
  });
  double sum_bytes = 0, sum_px = 0;
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    sum_bytes += double(bytes[k]);
    sum_px += double(px[k]);
  }
  const double expected_bytes = kLevels * double(bgra.total()) * sum_bytes / sum_px;
  return std::min(1., std::sqrt(double(most_bytes) / expected_bytes));
}

cv::Mat scaled(const cv::Mat& bgra, double scale) {
  if (scale >= 1) return bgra;
  const auto side = [&](int side_px) { return std::max(1, int(std::lround(side_px * scale))); };
  return resized(bgra, {side(bgra.cols), side(bgra.rows)});
}

}  // namespace

std::size_t bytes_of(const PicturePyramid& pyramid) {
  std::size_t bytes = 0;
  for (const PictureLevel& level : pyramid) {
    for (const std::vector<std::uint8_t>& tile : level.tiles) bytes += tile.size();
  }
  return bytes;
}

PicturePyramid picture_pyramid(const cv::Mat& bgra, std::size_t most_bytes) {
  double scale = expected_scale(bgra, most_bytes);
  while (true) {
    PicturePyramid pyramid = whole_pyramid(scaled(bgra, scale));
    const std::size_t bytes = bytes_of(pyramid);
    if (bytes <= most_bytes || (pyramid.size() == 1 && scale * std::max(bgra.cols, bgra.rows) < 64)) return pyramid;
    scale *= std::min(kLeastShrinking, std::sqrt(double(most_bytes) / double(bytes)));
  }
}

}  // namespace tessera
