// When two drawings of one silhouette are one shape.
#pragma once

#include <array>
#include <cmath>

namespace tessera {

/// They are kept both where their mean colours differ by more than this distance in CIELAB: a clear difference beside
/// each other (a just noticeable one is about 2.3). The edge of a drawing that was exported in another size changes it
/// by less than 1.
inline constexpr float kLeastColourDifference = 5;

inline bool same_colour(const std::array<float, 3>& lab_a, const std::array<float, 3>& lab_b) {
  return std::hypot(lab_a[0] - lab_b[0], lab_a[1] - lab_b[1], lab_a[2] - lab_b[2]) <= kLeastColourDifference;
}

}  // namespace tessera
