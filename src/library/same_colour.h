// Decides whether two drawings of one silhouette become one shape.
#pragma once

#include <array>
#include <cmath>

namespace tessera {

/// Both drawings are kept where their mean colours differ by more than this distance in CIELAB: side by side that is a
/// clear difference (about 2.3 is just noticeable). Exporting a drawing in another size changes its edge, and the mean by
/// less than 1.
inline constexpr float kLeastColourDifference = 5;

inline bool same_colour(const std::array<float, 3>& lab_a, const std::array<float, 3>& lab_b) {
  return std::hypot(lab_a[0] - lab_b[0], lab_a[1] - lab_b[1], lab_a[2] - lab_b[2]) <= kLeastColourDifference;
}

}  // namespace tessera
