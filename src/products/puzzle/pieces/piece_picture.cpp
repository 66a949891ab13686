#include "products/puzzle/pieces/piece_picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tessera {

PiecePicture::PiecePicture(int width, int height, const std::vector<std::uint8_t>& bgra,
                           const Similarity& px_from_piece)
    : width_(width),
      height_(height),
      colours_(std::size_t(width) * std::size_t(height), Colour{-1, -1, -1}),
      px_from_piece_(px_from_piece) {
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::array<int, 4> sum{};
      for (int j = std::max(0, y - 1); j <= std::min(height - 1, y + 1); ++j) {
        for (int i = std::max(0, x - 1); i <= std::min(width - 1, x + 1); ++i) {
          const std::uint8_t* pixel = &bgra[4 * (std::size_t(j) * std::size_t(width) + std::size_t(i))];
          for (std::size_t c = 0; c < 3; ++c) sum[c] += int(pixel[c]) * pixel[3];
          sum[3] += pixel[3];
        }
      }
      if (sum[3] == 0) continue;
      Colour& colour = colours_[std::size_t(y) * std::size_t(width) + std::size_t(x)];
      for (std::size_t c = 0; c < 3; ++c) colour[c] = float(sum[c]) / float(sum[3]);
    }
  }
}

std::optional<PiecePicture::Colour> PiecePicture::at(Vec2 piece_point) const {
  const Vec2 p = px_from_piece_.apply(piece_point);
  if (!(p.x >= 0 && p.y >= 0 && p.x < float(width_) && p.y < float(height_))) return {};
  const Colour& colour = colours_[std::size_t(p.y) * std::size_t(width_) + std::size_t(p.x)];
  if (colour[0] < 0) return {};
  return colour;
}

float colour_distance(const PiecePicture::Colour& a, const PiecePicture::Colour& b) {
  float squares = 0;
  for (std::size_t c = 0; c < 3; ++c) squares += (a[c] - b[c]) * (a[c] - b[c]);
  return std::sqrt(squares);
}

}  // namespace tessera
