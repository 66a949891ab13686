// An outline with one part replaced by a part of another outline (paper, Fig. 4b).
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "core/geometry/vec2.h"
#include "core/replacing/draws.h"

namespace tessera::bench {

struct ChangedOutline {
  std::vector<Vec2> points;  // closed; px of the first outline, interior on the left
  std::size_t kept = 0;      // number of first points from the first outline, from one end of the kept arc to the other
};

/// Replaces a random arc of the outline. `outline`, `other`: closed, interior on the left. `part`: replaced part of the
/// outline's length. The new arc is one of `other` with about the same chord and length; it leaves the old course and
/// crosses nothing. `other` is first scaled to the outline's area. Nullopt where no such arcs were found among a few
/// hundred random ones.
std::optional<ChangedOutline> changed_outline(const std::vector<Vec2>& outline, const std::vector<Vec2>& other,
                                              double part, Draws& draws);

/// The longest contour of a mask (CV_8U).
std::vector<Vec2> outer_outline(const cv::Mat& mask);

/// The area within a closed polygon, as a mask with a margin of clear pixels.
cv::Mat filled_mask(const std::vector<Vec2>& polygon);

}  // namespace tessera::bench
