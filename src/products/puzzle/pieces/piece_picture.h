// The picture on a puzzle piece. Across a cut the pictures of both pieces continue each other.
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

  /// The mean of the opaque part of the 3 x 3 px round a point of the piece; empty beyond the picture and where all of it
  /// is transparent.
  std::optional<Colour> at(Vec2 piece_point) const;

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<Colour> colours_;  // negative: transparent
  Similarity px_from_piece_;
};

/// The Euclidean distance of two colours, in steps of 8-bit channels.
float colour_distance(const PiecePicture::Colour& a, const PiecePicture::Colour& b);

}  // namespace tessera
