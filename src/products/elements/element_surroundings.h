// Cuts out the photograph round an element in its photograph, so that pictures can show the element's own ground, joints and
// contact shadows (output.background = "photo").
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "products/elements/label_roles.h"
#include "products/elements/photo_elements.h"

namespace tessera {

/// The width of surroundings that suits these elements: px of the photo.
int surroundings_margin_px(const std::vector<PhotoElement>& elements);

/// The photo round an element: straight BGRA, CV_8UC4, the page of cut_element() and `margin_px` more on each side. The
/// element and its ground are opaque, other elements have kOtherElementAlpha, and what lies outside the photo is
/// transparent. `photo`: CV_8UC4; `labels`: CV_32S of its size.
cv::Mat element_surroundings(const cv::Mat& photo, const cv::Mat& labels, const std::vector<LabelRole>& roles,
                             const PhotoElement& element, int margin_px);

}  // namespace tessera
