#include "core/colour/colour_target.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/geometry/cell_lookup.h"

namespace tessera {
namespace {

Texel mixed(const Texel& p, const Texel& q, float t) {
  return {p.lightness * (1 - t) + q.lightness * t, p.a * (1 - t) + q.a * t, p.b * (1 - t) + q.b * t,
          p.weight * (1 - t) + q.weight * t};
}

/// Means of 2 x 2 texels; with odd sizes the last row and column count twice.
Grid<Texel> halved(const Grid<Texel>& fine) {
  Grid<Texel> coarse((fine.width() + 1) / 2, (fine.height() + 1) / 2);
  for (int y = 0; y < coarse.height(); ++y) {
    for (int x = 0; x < coarse.width(); ++x) {
      const int right = std::min(2 * x + 1, fine.width() - 1);
      const int below = std::min(2 * y + 1, fine.height() - 1);
      coarse(x, y) = mixed(mixed(fine(2 * x, 2 * y), fine(right, 2 * y), 0.5f),
                           mixed(fine(2 * x, below), fine(right, below), 0.5f), 0.5f);
    }
  }
  return coarse;
}

}  // namespace

ColourTarget::ColourTarget(const Grid<Texel>& finest, float px_per_texel) : px_per_texel_(px_per_texel) {
  // otherwise the vector would reserve twice the memory
  texels_.reserve(finest.data().size() * 4 / 3 + 4 * kMaxColourLevels);
  Grid<Texel> level = finest;
  for (;;) {
    levels_.push_back(
        {std::uint32_t(level.width()), std::uint32_t(level.height()), std::uint32_t(texels_.size()), 1 / px_per_texel});
    texels_.insert(texels_.end(), level.data().begin(), level.data().end());
    if ((level.width() == 1 && level.height() == 1) || levels_.size() == kMaxColourLevels) return;
    level = halved(level);
    px_per_texel *= 2;
  }
}

int ColourTarget::level_for(float length_px) const {
  int level = 0;
  while (level + 1 < int(levels_.size()) && levels_[std::size_t(level) + 1].texels_per_px * length_px >= 1) ++level;
  return level;
}

Texel ColourTarget::at(int level, Vec2 p_px) const {
  const ColourLevel& l = levels_[std::size_t(level)];
  const CellLookup c(p_px, l.texels_per_px, int(l.width), int(l.height));
  const Texel* upper = texels_.data() + l.first + std::size_t(c.upper) * l.width;
  const Texel* lower = texels_.data() + l.first + std::size_t(c.lower) * l.width;
  return mixed(mixed(upper[c.left], upper[c.right], c.s), mixed(lower[c.left], lower[c.right], c.s), c.t);
}

}  // namespace tessera
