// What is on a puzzle piece: along a cut the pictures of both pieces go on in each other.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry/similarity.h"
#include "core/geometry/vec2.h"

namespace tessera {

class PiecePicture {
 public:
  using Colour = std::array<float, 3>;

  /// `bgra`: rows of straight 8-bit pixels, whose centres have the coordinates x + 0.5, y + 0.5.
  PiecePicture(int width, int height, const std::vector<std::uint8_t>& bgra, const Similarity& px_from_piece);

  /// Mean of the opaque part of the 3 x 3 px round a place of the piece; nothing beyond the picture and where all of it
  /// is transparent.
  std::optional<Colour> at(Vec2 piece_point) const;

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<Colour> colours_;  // negative: transparent
  Similarity px_from_piece_;
};

/// From 0; as of pixels.
float colour_distance(const PiecePicture::Colour& a, const PiecePicture::Colour& b);

}  // namespace tessera
