// The style of a drawing in a few numbers, and the distance of two styles: weight of lines, palette, texture and
// shading. The paper names style as an aspect that its collages ignore (section 6).
#pragma once

#include <array>
#include <cstddef>

namespace tessera {

/// Features of a drawing's style. They do not change with the drawing's size, position, quarter turns or mirroring.
/// They also do not change with the hues of its colours, as far as CIELAB is perfect.
struct StyleFeatures {
  float line_width = 0;  // shape units: mean width of dark lines; 0: there are none
  float line_part = 0;   // fraction of the drawing's area that is dark lines, 0..1
  float outlined = 0;    // fraction of its boundary that is a dark line, 0..1
  float palette = -1;    // bits: entropy of its colours, so that it uses 2^palette colours; negative: unknown
  float chroma = 0;      // CIELAB, mean
  float texture = 0;     // CIELAB: mean difference of a pixel from its neighbours' mean, away from edges
  float shading = 0;     // fraction of the area away from edges where the colour changes gradually, 0..1
  float detail = 0;      // fraction of the area beside edges, 0..1

  /// Whether the style is known; libraries of older versions have none.
  bool known() const { return palette >= 0; }

  friend bool operator==(const StyleFeatures&, const StyleFeatures&) = default;
};

inline constexpr std::size_t kStyleNumbers = 8;
static_assert(sizeof(StyleFeatures) == kStyleNumbers * sizeof(float));

/// A style as a point in a space whose distances are differences of style. One unit is about the spread of a feature
/// over Debian's clip art.
using StylePlace = std::array<float, kStyleNumbers>;

StylePlace style_place(const StyleFeatures& features);

/// The Euclidean distance: 0 for equal styles, symmetric, and with the triangle inequality. Two random drawings of
/// Debian's clip art have a distance of about 3 to 4.
float style_distance(const StylePlace& a, const StylePlace& b);

}  // namespace tessera
