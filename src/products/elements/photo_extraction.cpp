#include "products/elements/photo_extraction.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "artwork/images/image_decoding.h"
#include "artwork/images/png_encoder.h"
#include "core/base/error.h"
#include "core/shape/outline.h"
#include "files/regular_file.h"
#include "products/elements/elements_overview.h"
#include "products/elements/freed_memory.h"
#include "products/elements/ground_pixels.h"
#include "products/elements/ground_synthesis.h"
#include "products/elements/segmentation/connected_labels.h"
#include "products/elements/segmentation/label_scaling.h"

namespace tessera {
namespace {

/// Of a map of labels: 100 MB. Elements that are wide enough have half of them at most.
constexpr std::size_t kMostRuns = 8'000'000;

std::string size_text(const cv::Size& size) { return std::to_string(size.width) + " x " + std::to_string(size.height); }

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

/// A photo's file, read once, so that it is the same each time it is decoded.
struct PhotoFile {
  std::string path;
  std::vector<std::uint8_t> bytes;
};

cv::Mat decoded(const PhotoFile& photo, int times, Drawers& drawers) {
  return enlarged_photo(photo.path, drawers.photo(photo.bytes, photo.path), times);
}

/// A label map of a working copy. The photo is not held meanwhile, as the search takes as much room.
cv::Mat searched(const PhotoFile& photo, const ExtractionSettings& settings, Drawers& drawers) {
  try {
    const ElementCopies copies =
        element_copies(decoded(photo, settings.enlarged, drawers), settings.element_px * settings.enlarged);
    const cv::Mat labels = elements_in_copies(copies);
    give_back_freed_memory();
    return labels;
  } catch (const std::invalid_argument& error) {
    throw InputError(photo.path + ": --element-px: " + error.what());
  }
}

/// Before the photo is there.
cv::Mat given_labels(const std::string& path, Drawers& drawers) {
  const cv::Mat labels = connected_labels(drawers.labels(read_regular_file(path, kMaxPhotoBytes), path));
  if (run_count(labels) > kMostRuns)
    throw InputError(path + ": found labels as thin as a pixel all over the map, allowed: those of elements, " +
                     std::to_string(kLeastSize_px) + " px wide and more");
  return labels;
}

LabelRuns labels_for(const std::string& labels_path, const cv::Mat& labels, const std::string& photo,
                     const cv::Mat& picture, int times) {
  const cv::Size as_it_is(picture.cols / times, picture.rows / times);
  if (labels.size() != as_it_is) {
    throw InputError(labels_path + ": found a map of " + size_text(labels.size()) + " px, allowed: the size of " +
                     photo + ", " + size_text(as_it_is) + " px");
  }
  return times > 1 ? scaled_labels(labels, picture.size()) : LabelRuns(labels);
}

void add_ground(const std::string& photo, const cv::Mat& picture, const LabelRuns& labels,
                const ExtractionSettings& settings, Extraction& extraction) {
  const GroundPixels pixels = ground_pixels(picture, labels);
  give_back_freed_memory();
  const cv::Mat ground = synthesised_ground(picture, pixels.certain, settings.ground_px);
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
  const bool searches = settings.labels.empty();
  PhotoFile file{photo, read_regular_file(photo, kMaxPhotoBytes)};
  const cv::Mat map = searches ? searched(file, settings, drawers) : given_labels(settings.labels, drawers);
  const cv::Mat picture = decoded(file, times, drawers);
  file.bytes = {};
  const LabelRuns labels =
      searches ? labels_of_photo(picture, map) : labels_for(settings.labels, map, photo, picture, times);
  Extraction extraction;
  extraction.least_px = std::max(settings.sizes.least_px, double(kLeastSize_px) / times);
  extraction.found = find_elements(labels, {extraction.least_px * times, settings.sizes.most_px * times});
  const std::vector<PhotoElement>& elements = extraction.found.elements;
  if (settings.ground_px > 0) add_ground(photo, picture, labels, settings, extraction);
  if (settings.with_overview) extraction.overview_png = png_of(elements_overview(picture, labels, elements));
  extraction.cut_outs = cut_outs(photo, picture, labels, elements);
  return extraction;
}

}  // namespace tessera
