// Moves the elements of a layout a little, so that joints are nowhere much narrower or wider than the photo's.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "products/texture/texture_layout.h"

namespace tessera {

/// `laid`: from texture_layout(). Where two patches meet, joints may be too wide or elements overlap. What is too much there
/// is spread over many joints, so that nobody sees it. Elements of one patch hold together; they give way across a joint
/// less than along it. Gaps that are wide enough for another element stay.
std::vector<LaidElement> relaxed_layout(const PhotoLayout& photo, std::vector<LaidElement> laid, cv::Size canvas_px);

}  // namespace tessera
