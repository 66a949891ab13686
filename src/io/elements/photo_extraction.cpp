#include "io/elements/photo_extraction.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "core/base/error.h"
#include "core/shape/outline.h"
#include "io/artwork/image_decoding.h"
#include "io/elements/connected_labels.h"
#include "io/elements/elements_overview.h"
#include "io/elements/ground_pixels.h"
#include "io/elements/ground_synthesis.h"
#include "io/elements/label_scaling.h"
#include "io/regular_file.h"

namespace tessera::io {
namespace {

std::string size_text(const cv::Size& size) { return std::to_string(size.width) + " x " + std::to_string(size.height); }

cv::Mat without_alpha(const cv::Mat& picture) {
  cv::Mat bgr;
  cv::cvtColor(picture, bgr, cv::COLOR_BGRA2BGR);
  return bgr;
}

cv::Mat enlarged_photo(const std::string& photo, const cv::Mat& picture, int times) {
  if (times == 1) return picture;
  const int most = int(std::sqrt(kMaxImagePixels / (double(picture.cols) * picture.rows)));
  if (times > most) {
    throw InputError(photo + ": --enlarge: found " + std::to_string(times) + ", allowed with its " +
                     size_text(picture.size()) + " px: " + std::to_string(std::max(most, 1)) + " or less");
  }
  cv::Mat enlarged;
  cv::resize(picture, enlarged, picture.size() * times, 0, 0, cv::INTER_CUBIC);
  return enlarged;
}

cv::Mat searched_labels(const std::string& photo, const cv::Mat& picture, double element_px) {
  try {
    return element_labels(without_alpha(picture), element_px);
  } catch (const std::invalid_argument& error) {
    throw InputError(photo + ": --element-px: " + error.what());
  }
}

cv::Mat given_labels(const std::string& path, const std::string& photo, const cv::Size& size, Drawers& drawers) {
  const cv::Mat labels = drawers.labels(read_regular_file(path, kMaxPhotoBytes), path);
  if (labels.size() != size) {
    throw InputError(path + ": found a map of " + size_text(labels.size()) + " px, allowed: the size of " + photo +
                     ", " + size_text(size) + " px");
  }
  return connected_labels(labels);
}

void add_ground(const std::string& photo, const cv::Mat& picture, const cv::Mat& labels,
                const ExtractionSettings& settings, Extraction& extraction) {
  const cv::Mat bgr = without_alpha(picture);
  const GroundPixels pixels = ground_pixels(bgr, labels);
  const cv::Mat ground = synthesised_ground(bgr, pixels.certain, settings.ground_px);
  if (ground.empty()) {
    throw InputError(photo + ": --ground: found hardly any gaps between the elements, needed: some " +
                     std::to_string(kLeastPlaces) + " places of " + std::to_string(kLeastPatch_px) + " x " +
                     std::to_string(kLeastPatch_px) + " px; without --ground a job's output.background has a colour");
  }
  extraction.ground_png = png_of(ground);
  extraction.ground_part = pixels.part;
}

}  // namespace

Extraction extract_elements(const std::string& photo, const ExtractionSettings& settings, Drawers& drawers) {
  const int times = settings.enlarged;
  const cv::Mat as_it_is = drawers.photo(read_regular_file(photo, kMaxPhotoBytes), photo);
  const cv::Mat picture = enlarged_photo(photo, as_it_is, times);
  cv::Mat labels;
  if (settings.labels.empty()) {
    labels = searched_labels(photo, picture, settings.element_px * times);
  } else {
    labels = given_labels(settings.labels, photo, as_it_is.size(), drawers);
    if (times > 1) labels = scaled_labels(labels, picture.size());
  }
  Extraction extraction;
  extraction.least_px = std::max(settings.sizes.least_px, double(kLeastSize_px) / times);
  extraction.found = find_elements(labels, {extraction.least_px * times, settings.sizes.most_px * times});
  const std::vector<PhotoElement>& elements = extraction.found.elements;
  if (settings.with_overview) extraction.overview_png = png_of(elements_overview(picture, labels, elements));
  if (settings.ground_px > 0) add_ground(photo, picture, labels, settings, extraction);
  extraction.cut_outs = cut_outs(photo, picture, labels, elements);
  return extraction;
}

}  // namespace tessera::io
