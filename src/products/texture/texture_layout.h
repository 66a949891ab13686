// Lays the elements of a photo on a canvas that repeats, as they lie in the photo: patches of several neighbours are put
// side by side (image quilting, Efros and Freeman, SIGGRAPH 2001, with whole elements instead of pixels). Rows, joints, the
// light and the mixture of sizes stay those of the photo.
#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "products/elements/label_roles.h"
#include "products/elements/photo_elements.h"
#include "products/elements/segmentation/label_runs.h"

namespace tessera {

struct LaidElement {
  std::size_t element = 0;  // of PhotoLayout::elements
  cv::Point shift_px;       // from the photo to the canvas
};

struct PhotoLayout {
  const LabelRuns& labels;
  const std::vector<PhotoElement>& elements;  // that may be laid
  std::vector<LabelRole> roles;               // of the labels
  int step_px = 1;                            // shifts are multiples of it
};

/// The elements on the canvas, whose opposite edges fit together, in the order in which they were laid. Elements may
/// overlap by a tenth of their area. Where patches do not fit together there are gaps. The same arguments give the same
/// layout. Empty without elements.
std::vector<LaidElement> texture_layout(const PhotoLayout& photo, cv::Size canvas_px, std::uint64_t seed);

}  // namespace tessera
