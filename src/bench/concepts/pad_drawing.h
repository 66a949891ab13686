// PADs as figures show them: the intervals of all levels along a curve, and the elements as bars.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "bench/concepts/figure_sheet.h"
#include "core/pad/pad.h"

namespace tessera::bench::concepts {

/// Colours of the levels, the shortest level (0) darkest.
inline constexpr std::array<const char*, kMaxPadLevels> kLevelColours = {"#08306b", "#2171b5", "#5fa2ce",
                                                                         "#9ecae1", "#c9def0", "#e3eef8"};

/// Draws the intervals of a pyramid over a curve, longer levels broader below shorter ones. `curve` is closed and evenly spaced, in any
/// frame. The pyramid belongs to its point `at`, and has the curve's unit of length.
void draw_pad_levels(FigureSheet& sheet, const Similarity& sheet_from_curve, const std::vector<Vec2>& curve,
                     std::size_t at, const ArclengthPyramid& pyramid, int levels);

/// The least element of a PAD: a point whose least element is large is seen well on all levels.
float least_element(const Pad& pad, int levels);

/// Draws the elements of s·m(p) as bars: levels n-2 to 0 of the left side, then 0 to n-2 of the right side.
/// The bars of a convex point stand on the lower edge of the box; the bars of a concave point hang from its upper edge.
void draw_pad_bars(FigureSheet& sheet, const Box& box, const Pad& pad, int levels);

}  // namespace tessera::bench::concepts
