// The style of a drawing in a few numbers, and how far two styles lie apart: the weight of its lines, its palette, its
// texture and its shading. The paper names style as what its collages do not regard (section 6).
#pragma once

#include <array>
#include <cstddef>

namespace tessera {

/// None of them changes with the drawing's size, where it lies, a quarter turn or a mirror image, nor (but for what
/// CIELAB is no perfect measure of) with the hues of its colours.
struct StyleFeatures {
  float line_width = 0;  // shape units: mean width of dark lines; 0: there are none
  float line_part = 0;   // of the drawing's area that is dark lines, 0..1
  float outlined = 0;    // part of its boundary that is a dark line, 0..1
  float palette = -1;    // bits: the entropy of its colours, so that 2^palette of them are in use; negative: unknown
  float chroma = 0;      // CIELAB, mean
  float texture = 0;     // CIELAB: mean difference of a pixel from its neighbours' mean, away from edges
  float shading = 0;     // part of what lies away from edges in which the colour changes little by little, 0..1
  float detail = 0;      // part of the area that lies beside edges, 0..1

  /// Libraries of older versions do not know.
  bool known() const { return palette >= 0; }

  friend bool operator==(const StyleFeatures&, const StyleFeatures&) = default;
};

inline constexpr std::size_t kStyleNumbers = 8;
static_assert(sizeof(StyleFeatures) == kStyleNumbers * sizeof(float));

/// A style as a place in a space in which distances are differences of style: one unit is about the spread of a feature
/// over Debian's clip art.
using StylePlace = std::array<float, kStyleNumbers>;

StylePlace style_place(const StyleFeatures& features);

/// Euclid's: 0 for equal styles, symmetric, and no way is shorter by a third style. Two drawings of Debian's clip art
/// that are drawn at random are some 3 to 4 apart.
float style_distance(const StylePlace& a, const StylePlace& b);

}  // namespace tessera
