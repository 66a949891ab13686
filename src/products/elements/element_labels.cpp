#include "products/elements/element_labels.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "products/elements/candidate_maps.h"
#include "products/elements/freed_memory.h"
#include "products/elements/gap_filter.h"
#include "products/elements/photo_margin.h"
#include "products/elements/segmentation/boundary_map.h"
#include "products/elements/segmentation/label_scaling.h"
#include "products/elements/segmentation/region_labels.h"
#include "products/elements/segmentation/region_vote.h"

namespace tessera {
namespace {

/// Scale of the finer of two working copies. It shows small parts; the coarser one shows large elements with much texture.
constexpr double kFiner = 1.4;
/// Copies that are enlarged more than this show nothing more.
constexpr double kMostZoom = 4;
/// Pixels of the finer copy, at most.
constexpr double kMostWorking_px2 = 6e6;
/// Factor by which a size may be wrong, and by which the copy may be smaller than it should be.
constexpr double kSizeTolerance = 1.4;
/// Smaller copies hold no element.
constexpr int kLeastSide_px = kElement_px / 2;
/// The width of the border that is added along each edge of the coarser copy: half an element.
constexpr int kMirrored_px = kElement_px / 2;

void check(const cv::Mat& photo, double element_px) {
  if (!photo.empty() && photo.type() != CV_8UC3 && photo.type() != CV_8UC4)
    throw std::invalid_argument("a photo to be searched for elements must be CV_8UC3 or CV_8UC4");
  if (!std::isfinite(element_px) || element_px <= 0)
    throw std::invalid_argument("the side of an element is " + std::to_string(element_px) +
                                " px; it must be a number above 0");
}

/// Scale of the coarser copy, relative to the photo.
double zoom_for(cv::Size photo, double element_px) {
  const double wanted = std::min(kMostZoom, kElement_px / element_px);
  const double possible = std::sqrt(kMostWorking_px2 / (double(photo.width) * photo.height)) / kFiner;
  if (wanted > possible * kSizeTolerance) {
    const int least_px = int(std::ceil(kElement_px / (possible * kSizeTolerance)));
    throw std::invalid_argument("elements of " + std::to_string(element_px) + " px are too small for a photo of " +
                                std::to_string(photo.width) + " x " + std::to_string(photo.height) +
                                " px: crop it, or look for elements of " + std::to_string(least_px) + " px or more");
  }
  return std::min(wanted, possible);
}

cv::Mat zoomed(const cv::Mat& photo, double zoom) {
  const cv::Size size(int(std::lround(photo.cols * zoom)), int(std::lround(photo.rows * zoom)));
  cv::Mat copy;
  cv::resize(photo, copy, size, 0, 0, zoom < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
  return bgr_of(copy);
}

/// A copy that is continued beyond its edges by its mirror image. An element that the edge cuts becomes one that reaches
/// far beyond it. A joint along the edge becomes twice as wide, which parts the element beside it from the edge.
cv::Mat mirrored(const cv::Mat& copy, int margin_px) {
  cv::Mat result;
  cv::copyMakeBorder(copy, result, margin_px, margin_px, margin_px, margin_px, cv::BORDER_REFLECT_101);
  return result;
}

/// `lab`: smooth_lab() of the finer copy.
cv::Mat voted_elements(const ElementCopies& copies, const cv::Mat& lab) {
  std::vector<LabelRuns> maps = candidate_maps(copies.fine, lab, lab.size());
  for (LabelRuns& map : candidate_maps(copies.coarse, smooth_lab(copies.coarse), lab.size()))
    maps.push_back(std::move(map));
  return voted_regions(maps, boundary_map(lab, {}), kElement_px * kFiner).labels;
}

}  // namespace

ElementCopies element_copies(const cv::Mat& photo, double element_px) {
  check(photo, element_px);
  if (photo.empty()) return {};
  const double zoom = zoom_for(photo.size(), element_px);
  if (std::min(photo.cols, photo.rows) * zoom < kLeastSide_px) return {};
  return {zoomed(photo, zoom), zoomed(photo, zoom * kFiner)};
}

cv::Mat elements_in_copies(const ElementCopies& copies) {
  if (copies.fine.empty()) return cv::Mat::zeros(1, 1, CV_32S);
  const int margin_px = int(std::lround(kMirrored_px * kFiner));
  const ElementCopies continued{mirrored(copies.coarse, kMirrored_px), mirrored(copies.fine, margin_px)};
  const cv::Mat lab = smooth_lab(continued.fine);
  const cv::Mat voted = voted_elements(continued, lab);
  give_back_freed_memory();
  const cv::Rect photo({margin_px, margin_px}, copies.fine.size());
  return without_gap_regions(solid_regions(voted(photo), 0, 0), copies.fine, lab(photo));
}

LabelRuns labels_of_photo(const cv::Mat& photo, const cv::Mat& in_copy) {
  return without_margins(photo, scaled_labels(in_copy, photo.size()));
}

LabelRuns element_labels(const cv::Mat& photo, double element_px) {
  return labels_of_photo(photo, elements_in_copies(element_copies(photo, element_px)));
}

}  // namespace tessera
