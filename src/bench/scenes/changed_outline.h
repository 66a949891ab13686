// An outline of which a part was replaced by a part of another one (paper, Fig. 4b).
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "core/geometry/vec2.h"
#include "core/replacing/draws.h"

namespace tessera::bench {

struct ChangedOutline {
  std::vector<Vec2> points;  // closed; px of the first outline, interior on the left
  std::size_t kept = 0;  // the first so many points are the first outline's, from one end of the kept arc to the other
};

/// `outline`, `other`: closed, interior on the left. `part`: of the outline's length that is replaced, by an arc of `other` of about
/// the same chord and length that leaves the old course and crosses nothing. `other` is taken as large as the outline. Empty
/// where no such pair of arcs was found among a few hundred random ones.
std::optional<ChangedOutline> changed_outline(const std::vector<Vec2>& outline, const std::vector<Vec2>& other,
                                              double part, Draws& draws);

/// The longest contour of a mask (CV_8U).
std::vector<Vec2> outer_outline(const cv::Mat& mask);

/// What a closed polygon encloses, as a mask with clear pixels round it.
cv::Mat filled_mask(const std::vector<Vec2>& polygon);

}  // namespace tessera::bench
