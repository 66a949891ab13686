#include "io/result/png_output.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/field/field_lookup.h"
#include "core/geometry/rasterise.h"
#include "io/parallel_for.h"
#include "io/result/artwork_original.h"
#include "io/result/sprite.h"

namespace tessera::io {
namespace {

// Pieces are warped at twice the picture's resolution and averaged: a warp alone either blurs or leaves jagged edges.
constexpr int kSupersampling = 2;
constexpr int kMaxSprite_px = 4096;
constexpr int kStripRows = 128;  // warped at a time, so that a piece as large as the picture needs little memory
constexpr double kBandPixels = 64e6;  // of the picture drawn at a time: all its tiles are in memory at once

/// A piece ready to be laid over the picture: premultiplied BGRA, upper left corner at (x, y) of the picture.
struct Tile {
  int x = 0;
  int y = 0;
  cv::Mat bgra;
};

cv::Vec3b parse_colour(const std::string& hex) {
  const unsigned long rgb = std::stoul(hex.substr(1), nullptr, 16);
  return {std::uint8_t(rgb), std::uint8_t(rgb >> 8), std::uint8_t(rgb >> 16)};
}

int picture_width_px(const CollageReport& report, bool quick) {
  const int wanted_px = report.job->output.width_px;
  return quick ? std::min(wanted_px, kQuickWidth_px) : wanted_px;
}

/// The background colour fades over one pixel of the picture at the canvas' edge.
cv::Mat draw_canvas(const CollageReport& report, int width_px) {
  const double px = double(width_px) / report.canvas->width_px;
  cv::Mat picture(std::max(1, cvRound(report.canvas->height_px * px)), width_px, CV_8UC3);
  const cv::Vec3b colour = parse_colour(report.job->output.background);
  const FieldView distance(report.canvas->distance);
  parallel_for(std::size_t(picture.rows), [&](std::size_t y) {
    cv::Vec3b* row = picture.ptr<cv::Vec3b>(int(y));
    for (int x = 0; x < picture.cols; ++x) {
      const Vec2 p{float((x + 0.5) / px), float((double(y) + 0.5) / px)};
      const double inside = std::clamp(double(field_value(distance, p)) * px + 0.5, 0., 1.);
      for (int c = 0; c < 3; ++c) row[x][c] = std::uint8_t(std::lround(255 + (colour[c] - 255) * inside));
    }
  });
  return picture;
}

/// Picture px from artwork px for a piece.
Similarity picture_from_artwork(const Placement& placement, const Artwork& artwork, double picture_px) {
  const Similarity t = scaled(placement.canvas_from_shape, float(picture_px));
  const float unit = 1 / artwork.unit_px;
  Similarity m{t.a * unit, t.b * unit, 0, 0};
  const Vec2 moved = m.apply(artwork.centroid_px);
  m.tx = t.tx - moved.x;
  m.ty = t.ty - moved.y;
  return m;
}

/// Where the artwork's page lies in the picture.
cv::Rect page_box(const Artwork& artwork, const Similarity& picture_from_artwork) {
  const auto [w, h] = std::pair(float(artwork.width_px), float(artwork.height_px));
  const Outline page{{{{0, 0}, {w, 0}, {w, h}, {0, h}}}};
  const Window box = bounding_window(page, picture_from_artwork).grown(1);
  return {box.x0, box.y0, box.width(), box.height()};
}

/// The affine map that cv::warpAffine wants with WARP_INVERSE_MAP: sprite node from node of the supersampled tile, pixel
/// centres at whole numbers on both sides.
cv::Matx23d sprite_from_tile(const Similarity& picture_from_artwork, double sprite_px, cv::Point tile_corner) {
  const Similarity inverse = picture_from_artwork.inverse();
  const double a = inverse.a * sprite_px / kSupersampling;
  const double b = inverse.b * sprite_px / kSupersampling;
  const double u = tile_corner.x * kSupersampling + 0.5;
  const double v = tile_corner.y * kSupersampling + 0.5;
  return {a, -b, a * u - b * v + inverse.tx * sprite_px - 0.5,  //
          b, a,  b * u + a * v + inverse.ty * sprite_px - 0.5};
}

Tile draw_piece(const Sprite& sprite, const Similarity& picture_from_artwork, const cv::Rect& box) {
  const Sprite source = shrunk(sprite, kSupersampling * double(picture_from_artwork.scale()));
  Tile tile{box.x, box.y, cv::Mat(box.size(), CV_8UC4)};
  for (int top = 0; top < box.height; top += kStripRows) {
    const int rows = std::min(kStripRows, box.height - top);
    cv::Mat fine;
    cv::warpAffine(source.bgra, fine,
                   sprite_from_tile(picture_from_artwork, source.px_per_artwork_px, {box.x, box.y + top}),
                   cv::Size(box.width, rows) * kSupersampling, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP);
    cv::Mat strip = tile.bgra.rowRange(top, top + rows);
    cv::resize(fine, strip, strip.size(), 0, 0, cv::INTER_AREA);
  }
  return tile;
}

void lay_over(const Tile& tile, cv::Mat& picture) {
  for (int y = 0; y < tile.bgra.rows; ++y) {
    const cv::Vec4b* from = tile.bgra.ptr<cv::Vec4b>(y);
    cv::Vec3b* to = picture.ptr<cv::Vec3b>(tile.y + y) + tile.x;
    for (int x = 0; x < tile.bgra.cols; ++x) {
      const int rest = 255 - from[x][3];
      if (rest == 255) continue;
      for (int c = 0; c < 3; ++c) to[x][c] = std::uint8_t(std::min(255, from[x][c] + (to[x][c] * rest + 127) / 255));
    }
  }
}

/// The placements of each of the report's shapes.
std::vector<std::vector<std::size_t>> placements_by_shape(const CollageReport& report) {
  std::vector<std::vector<std::size_t>> by_shape(report.shapes.size());
  for (std::size_t i = 0; i < report.placements.size(); ++i) {
    by_shape[report.slot_of(report.placements[i].shape)].push_back(i);
  }
  return by_shape;
}

int sprite_side(const Artwork& artwork, double picture_px_per_artwork_px) {
  const double side = kSupersampling * picture_px_per_artwork_px * std::max(artwork.width_px, artwork.height_px);
  return int(std::clamp(std::ceil(side), 1., double(kMaxSprite_px)));
}

/// Draws the pieces of one shape that reach into `band`; the artwork is rendered once, at the largest size needed.
void draw_shape(const CollageReport& report, std::size_t slot, const std::vector<std::size_t>& uses, const cv::Rect& band,
                SpriteSource source, std::vector<Tile>& tiles) {
  const Shape& shape = report.shapes[slot];
  const double px = double(band.width) / report.canvas->width_px;  // a band is as wide as the picture
  std::vector<std::pair<std::size_t, Similarity>> visible;
  float largest = 0;
  for (const std::size_t i : uses) {
    const Similarity t = picture_from_artwork(report.placements[i], shape.artwork, px);
    if ((page_box(shape.artwork, t) & band).empty()) continue;
    visible.emplace_back(i, t);
    largest = std::max(largest, t.scale());
  }
  if (visible.empty()) return;
  const Sprite sprite = make_sprite(shape, sprite_side(shape.artwork, largest), source);
  for (const auto& [i, t] : visible) tiles[i] = draw_piece(sprite, t, page_box(shape.artwork, t) & band);
}

}  // namespace

cv::Mat draw_collage(const CollageReport& report, bool quick) {
  cv::Mat picture = draw_canvas(report, picture_width_px(report, quick));
  const auto by_shape = placements_by_shape(report);
  const SpriteSource source = quick ? SpriteSource::thumbnail : SpriteSource::original;
  const int band_rows = std::max(1, int(kBandPixels / picture.cols));
  for (int top = 0; top < picture.rows; top += band_rows) {
    const cv::Rect band(0, top, picture.cols, std::min(band_rows, picture.rows - top));
    std::vector<Tile> tiles(report.placements.size());
    parallel_for(by_shape.size(),
                 [&](std::size_t slot) { draw_shape(report, slot, by_shape[slot], band, source, tiles); });
    for (const Tile& tile : tiles) lay_over(tile, picture);
  }
  return picture;
}

std::vector<std::uint8_t> collage_png(const CollageReport& report, bool quick) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", draw_collage(report, quick), bytes, {cv::IMWRITE_PNG_COMPRESSION, quick ? 1 : 6});
  return bytes;
}

}  // namespace tessera::io
