#include "render/pieces/piece_drawing.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/geometry/rasterise.h"

namespace tessera {
namespace {

// Sides of sprites are powers of two: pieces of about the same size share a sprite, and none is drawn much larger than
// needed.
constexpr int kLeastSprite_px = 256;
constexpr int kMostSprite_px = 4096;

cv::Rect rect_of(const Window& w) { return {w.x0, w.y0, w.width(), w.height()}; }

int sprite_side(const Artwork& artwork, double picture_px_per_artwork_px) {
  const double wanted = kSupersampling * picture_px_per_artwork_px * std::max(artwork.width_px, artwork.height_px);
  int side = kLeastSprite_px;
  while (side < wanted && side < kMostSprite_px) side *= 2;
  return side;
}

/// The affine map for cv::warpAffine with WARP_INVERSE_MAP: from nodes of rows that are `finer` times as fine as the
/// picture to nodes of the sprite, with pixel centres at whole numbers on both sides.
cv::Matx23d sprite_from_rows(const PieceDrawing& piece, double sprite_px, cv::Point corner, int finer) {
  const Similarity inverse = piece.picture_from_artwork.inverse();
  const double a = inverse.a * sprite_px / finer;
  const double b = inverse.b * sprite_px / finer;
  const double u = corner.x * finer + 0.5;
  const double v = corner.y * finer + 0.5;
  cv::Matx23d map(a, -b, a * u - b * v + inverse.tx * sprite_px - 0.5,  //
                  b, a, b * u + a * v + inverse.ty * sprite_px - 0.5);
  if (piece.mirrored_at_px) {
    // sum of x of a node and of its mirror image
    const double there_and_back = 2 * *piece.mirrored_at_px * sprite_px - 1;
    for (int column = 0; column < 3; ++column) map(0, column) = -map(0, column);
    map(0, 2) += there_and_back;
  }
  return map;
}

/// A sprite with fewer than so many px for one of the picture is an image in its own pixels. It is enlarged, or drawn in
/// its size, by a cubic filter alone, because an average over a finer grid would blur it.
constexpr double kEnlarged = 1.05;

/// Whether a sprite is so many times as fine as the picture that its pixels are averaged without another filter before.
bool is_whole(double ratio) {
  constexpr double kWhole = 0.005, kMost = 8;
  return ratio > 1.5 && ratio < kMost + 0.5 && std::abs(ratio - std::lround(ratio)) < kWhole;
}

/// Makes premultiplied BGRA valid again: a cubic filter overshoots at edges.
void limit_to_alpha(cv::Mat& bgra) {
  for (int y = 0; y < bgra.rows; ++y) {
    cv::Vec4b* row = bgra.ptr<cv::Vec4b>(y);
    for (int x = 0; x < bgra.cols; ++x) {
      for (int c = 0; c < 3; ++c) row[x][c] = std::min(row[x][c], row[x][3]);
    }
  }
}

template <class Pixel>
void lay_over_pixels(const cv::Mat& bgra, cv::Mat& picture) {
  for (int y = 0; y < bgra.rows; ++y) {
    const cv::Vec4b* from = bgra.ptr<cv::Vec4b>(y);
    Pixel* to = picture.ptr<Pixel>(y);
    for (int x = 0; x < bgra.cols; ++x) {
      const int rest = 255 - from[x][3];
      if (rest == 255) continue;
      for (int c = 0; c < Pixel::channels; ++c) {
        to[x][c] = std::uint8_t(std::min(255, from[x][c] + (to[x][c] * rest + 127) / 255));
      }
    }
  }
}

}  // namespace

Similarity picture_from_artwork(const Placement& placement, const Artwork& artwork, double picture_px) {
  const Similarity t = scaled(placement.canvas_from_shape, float(picture_px));
  const float unit = 1 / artwork.unit_px;
  Similarity m{t.a * unit, t.b * unit, 0, 0};
  const Vec2 moved = m.apply(artwork.centroid_px);
  m.tx = t.tx - moved.x;
  m.ty = t.ty - moved.y;
  return m;
}

PieceDrawing make_piece_drawing(const Placement& placement, std::size_t slot, const Shape& shape, const Outline& clip,
                                double line_px, double picture_px, cv::Size picture) {
  if (clip.curves.empty()) return {};
  const Similarity picture_from_shape = scaled(placement.canvas_from_shape, float(picture_px));
  cv::Rect reach = rect_of(bounding_window(clip, picture_from_shape).grown(1));
  if (line_px > 0) {
    reach |= rect_of(bounding_window(shape.outline, picture_from_shape).grown(1 + int(std::ceil(line_px / 2))));
  }
  PieceDrawing piece;
  piece.outline = {&shape.outline.curves, picture_from_shape};
  piece.slot = slot;
  piece.picture_from_artwork = picture_from_artwork(placement, shape.artwork, picture_px);
  if (shape.artwork.mirrored) piece.mirrored_at_px = shape.artwork.centroid_px.x;
  piece.box = reach & cv::Rect({0, 0}, picture);
  piece.sprite_side_px = sprite_side(shape.artwork, double(piece.picture_from_artwork.scale()));
  return piece;
}

cv::Mat draw_rows(const PieceDrawing& piece, const Sprite& sprite, int begin, int end) {
  const double picture_px = double(piece.picture_from_artwork.scale());  // for a px of the artwork
  const double ratio = sprite.px_per_artwork_px / picture_px;
  const bool enlarges = ratio < kEnlarged;
  const int finer = enlarges ? 1 : is_whole(ratio) ? int(std::lround(ratio)) : kSupersampling;
  const Sprite source = shrunk(sprite, finer * picture_px);
  cv::Mat drawn(end - begin, piece.box.width, CV_8UC4);
  for (int top = begin, next = 0; top < end; top = next) {
    next = std::min(end, (top / kStripRows + 1) * kStripRows);
    const cv::Size size(piece.box.width, next - top);
    const cv::Matx23d map = sprite_from_rows(piece, source.px_per_artwork_px, {piece.box.x, top}, finer);
    cv::Mat strip = drawn.rowRange(top - begin, next - begin);
    if (enlarges) {
      cv::warpAffine(source.bgra, strip, map, size, cv::INTER_CUBIC | cv::WARP_INVERSE_MAP);
      limit_to_alpha(strip);
    } else {
      cv::Mat fine;
      cv::warpAffine(source.bgra, fine, map, size * finer, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP);
      cv::resize(fine, strip, size, 0, 0, cv::INTER_AREA);
    }
  }
  return drawn;
}

void cut_to(const cv::Mat& coverage, cv::Mat& bgra) {
  for (int y = 0; y < bgra.rows; ++y) {
    const std::uint8_t* inside = coverage.ptr(y);
    cv::Vec4b* row = bgra.ptr<cv::Vec4b>(y);
    for (int x = 0; x < bgra.cols; ++x) {
      for (int c = 0; c < 4; ++c) row[x][c] = std::uint8_t((row[x][c] * inside[x] + 127) / 255);
    }
  }
}

void lay_over(const cv::Mat& bgra, cv::Mat picture) {
  if (picture.channels() == 4) {
    lay_over_pixels<cv::Vec4b>(bgra, picture);
  } else {
    lay_over_pixels<cv::Vec3b>(bgra, picture);
  }
}

}  // namespace tessera
