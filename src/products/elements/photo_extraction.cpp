#include "products/elements/photo_extraction.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <stdexcept>
#include <vector>

#include "artwork/images/image_decoding.h"
#include "artwork/images/png_encoder.h"
#include "core/base/error.h"
#include "core/shape/outline.h"
#include "files/regular_file.h"
#include "products/elements/element_size.h"
#include "products/elements/elements_overview.h"
#include "products/elements/freed_memory.h"
#include "products/elements/ground_pixels.h"
#include "products/elements/ground_synthesis.h"
#include "products/elements/plain_ground.h"
#include "products/elements/segmentation/connected_labels.h"
#include "products/elements/segmentation/label_scaling.h"
#include "products/elements/touching_elements.h"

namespace tessera {
namespace {

/// Limit of a label map: 100 MB. Maps of wide elements need less than half of that.
constexpr std::size_t kMostRuns = 8'000'000;
/// The part of the found regions, by number, for which the photo is enlarged until a library accepts them.
constexpr double kLargeEnough = 0.875;

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

/// Label maps of copies of a photo.
struct FoundMaps {
  std::optional<cv::Mat> apart;  // from elements_on_plain_ground()
  cv::Mat searched;              // from elements_in_copies(); empty where that was not needed
  double element_px = 0;         // what was searched for; 0: nothing
  int enlarged = 1;              // how many times the photo is enlarged
};

bool any_of(const std::vector<bool>& marks) { return std::find(marks.begin(), marks.end(), true) != marks.end(); }

/// The sides (square roots of areas) of all regions that do not reach the map's edge, in px of the map, sorted.
std::vector<double> whole_sides_px(const cv::Mat& labels) {
  std::vector<double> sides;
  for (const RegionBox& region : region_boxes(labels)) {
    if (region.area_px2 > 0 && !reaches_edge(region.box, labels.size())) sides.push_back(std::sqrt(region.area_px2));
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// How many times the photo is enlarged. `element_px`: the side of a usual element; 0: the middle of the found regions.
int enlargement(const ExtractionSettings& settings, const cv::Mat& labels, double element_px, cv::Size photo) {
  std::vector<double> sides_px = whole_sides_px(labels);
  if (settings.enlarged_element_px == 0 || sides_px.empty()) return settings.enlarged;
  for (double& side_px : sides_px) side_px *= double(photo.width) / labels.cols;
  const double usual_px = element_px > 0 ? element_px : sides_px[sides_px.size() / 2];
  const double least_px = sides_px[std::size_t((1 - kLargeEnough) * double(sides_px.size()))];
  const double pixels = std::min(double(kMaxImagePixels), settings.most_enlarged_px2);
  const int possible = int(std::sqrt(pixels / (double(photo.width) * photo.height)));
  const int most = std::max(1, std::min({settings.most_enlarged, possible, kMostEnlarged}));
  const double wanted = std::max(settings.enlarged_element_px / usual_px, double(kLeastSize_px) / least_px);
  return std::clamp(int(std::ceil(wanted)), 1, most);
}

/// Makes the maps. The photo is not in memory during the search, which needs as much, nor afterwards.
FoundMaps found_maps(const PhotoFile& photo, const ExtractionSettings& settings, Drawers& drawers) {
  const bool has_size = settings.element_px > 0;
  FoundMaps maps;
  double& element_px = maps.element_px;
  ElementCopies copies;
  cv::Size photo_px;
  {
    const cv::Mat picture = decoded(photo, settings.enlarged, drawers);
    photo_px = picture.size() / settings.enlarged;
    maps.apart = elements_on_plain_ground(picture);
    element_px = has_size || maps.apart ? settings.element_px : found_element_px(picture) / settings.enlarged;
    if (maps.apart) maps.enlarged = enlargement(settings, *maps.apart, 0, photo_px);
    if (!maps.apart && element_px == 0) {
      throw InputError(
          photo.path +
          ": found no elements, neither apart on a plain ground nor side by side at any size; allowed: --element-px, "
          "the short side of a typical element in px, or --labels");
    }
    if (element_px == 0 || (maps.apart && !any_of(touching_regions(LabelRuns(*maps.apart))))) return maps;
    try {
      copies = element_copies(picture, element_px * settings.enlarged);
    } catch (const std::invalid_argument& error) {
      throw InputError(photo.path + ": --element-px: " + error.what());
    }
  }
  maps.searched = elements_in_copies(copies);
  if (!maps.apart) maps.enlarged = enlargement(settings, maps.searched, element_px, photo_px);
  give_back_freed_memory();
  return maps;
}

/// The photo's labels: elements that lie apart, and touching ones as the search separated them.
LabelRuns labels_from(const FoundMaps& maps, const cv::Mat& picture) {
  if (!maps.apart) return labels_of_photo(picture, maps.searched);
  const bool is_of_its_size = maps.apart->size() == picture.size();
  LabelRuns apart = is_of_its_size ? LabelRuns(*maps.apart) : scaled_labels(*maps.apart, picture.size());
  if (maps.searched.empty()) return apart;
  return with_touching_apart(apart, touching_regions(apart), labels_of_photo(picture, maps.searched));
}

std::size_t touching_count(const LabelRuns& labels, const std::vector<PhotoElement>& elements) {
  const std::vector<bool> touch = touching_regions(labels);
  return std::size_t(std::count_if(elements.begin(), elements.end(),
                                   [&](const PhotoElement& element) { return touch[std::size_t(element.label)]; }));
}

/// Reads labels from another program. Called before the photo is in memory.
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
    extraction.ground_problem = photo + ": --ground: found hardly any gaps between the elements, needed: some " +
                                std::to_string(kLeastPlaces) + " places of " + std::to_string(kLeastPatch_px) + " x " +
                                std::to_string(kLeastPatch_px) +
                                " px; without --ground a job's output.background has a colour";
    return;
  }
  extraction.ground_png = png_of(ground);
  extraction.ground_part = pixels.part;
}

}  // namespace

Extraction extract_elements(const std::string& photo, const ExtractionSettings& settings, Drawers& drawers) {
  const bool searches = settings.labels.empty();
  PhotoFile file{photo, read_regular_file(photo, kMaxPhotoBytes)};
  FoundMaps maps;
  maps.enlarged = settings.enlarged;
  if (searches) maps = found_maps(file, settings, drawers);
  const cv::Mat given = searches ? cv::Mat() : given_labels(settings.labels, drawers);
  if (!searches) maps.enlarged = enlargement(settings, given, 0, given.size());
  const int times = maps.enlarged;
  const cv::Mat picture = decoded(file, times, drawers);
  file.bytes = {};
  Extraction extraction;
  extraction.labels = std::make_shared<const LabelRuns>(
      searches ? labels_from(maps, picture) : labels_for(settings.labels, given, photo, picture, times));
  const LabelRuns& labels = *extraction.labels;
  extraction.element_px = maps.element_px;
  extraction.enlarged = times;
  extraction.least_px = std::max(settings.sizes.least_px, double(kLeastSize_px) / times);
  extraction.found = find_elements(labels, {extraction.least_px * times, settings.sizes.most_px * times});
  const std::vector<PhotoElement>& elements = extraction.found.elements;
  extraction.roles = label_roles(labels, elements, extraction.least_px * times);
  if (searches && extraction.element_px == 0) extraction.touching = touching_count(labels, elements);
  if (settings.ground_px > 0) add_ground(photo, picture, labels, settings, extraction);
  if (settings.with_overview) extraction.overview_png = png_of(elements_overview(picture, labels, elements));
  extraction.cut_outs = cut_outs(photo, picture, labels, extraction.roles, elements);
  return extraction;
}

}  // namespace tessera
