// The picture that the pieces show together: its colours over the canvas at several levels, each coarser than the one
// before. So the mean colour of a place of any size is one look-up. kernels/colour.cl does the same look-up, bit for
// bit.
#pragma once

#include <cstdint>
#include <vector>

#include "core/colour/lab.h"
#include "core/geometry/grid.h"
#include "core/geometry/vec2.h"

namespace tessera {

/// A mean colour times its weight (0..1), and the weight. The weight says how much the colour is wished; transparent
/// places have none.
struct Texel {
  float lightness = 0;
  float a = 0;
  float b = 0;
  float weight = 0;

  Lab colour() const { return {lightness / weight, a / weight, b / weight}; }
  friend bool operator==(const Texel&, const Texel&) = default;
};

struct ColourLevel {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t first = 0;  // index of its first texel among the texels of all levels
  float texels_per_px = 1;  // canvas px
};

inline constexpr int kMaxColourLevels = 16;
/// A texel with less weight wishes nothing.
inline constexpr float kLeastColourWeight = 0.02f;

class ColourTarget {
 public:
  /// `finest` covers the canvas from its upper left corner on, with texels of `px_per_texel` px in each direction. Each
  /// further level has texels twice as long, down to a single texel.
  ColourTarget(const Grid<Texel>& finest, float px_per_texel);

  /// Length of a texel of the finest level.
  float px_per_texel() const { return px_per_texel_; }
  const std::vector<ColourLevel>& levels() const { return levels_; }
  const std::vector<Texel>& texels() const { return texels_; }

  /// The coarsest level whose texels are no longer than `length_px`, or the finest level.
  int level_for(float length_px) const;
  /// Bilinear look-up; points beyond the picture get the value at its edge.
  Texel at(int level, Vec2 p_px) const;

 private:
  float px_per_texel_;
  std::vector<ColourLevel> levels_;
  std::vector<Texel> texels_;
};

}  // namespace tessera
