// Tells apart what the labels of a photograph are: elements that were taken, parts of others, and small things between.
#pragma once

#include <cstdint>
#include <vector>

#include "products/elements/photo_elements.h"
#include "products/elements/segmentation/label_runs.h"

namespace tessera {

enum class LabelRole : std::uint8_t {
  ground,   // no label, or a region that is too small for an element: part of what lies between the elements
  element,  // an element that was taken
  cut       // an element that was not taken: the photo's edge cuts it, or it is too large
};

/// The role of each label. `elements`: those that were taken. `least_px`: regions smaller than this are ground; the square
/// root of the area.
std::vector<LabelRole> label_roles(const LabelRuns& labels, const std::vector<PhotoElement>& elements, double least_px);

}  // namespace tessera
