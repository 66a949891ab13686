#include "element_truth.h"

#include <algorithm>
#include <ctime>
#include <map>
#include <opencv2/imgproc.hpp>
#include <set>
#include <tuple>
#include <utility>

#include "core/base/error.h"
#include "files/regular_file.h"
#include "products/elements/segmentation/region_labels.h"
#include "products/texture/texture_files.h"

namespace tessera::bench {
namespace {

bool is_whole(int label) { return label > 0 && label <= kMostWhole; }
bool is_truth_label(int label) {
  return label == 0 || is_whole(label) || (label >= kFirstIgnored && label <= kUnmarked);
}

/// The pixels of one found element in each label of the truth map, px².
using SharedPixels = std::map<int, double>;

SharedPixels shared_pixels(const cv::Mat& truth, const LabelRuns& labels, const PhotoElement& element) {
  SharedPixels shared_px2;
  for (const LabelRun& run : labels.runs_of(std::size_t(element.label))) {
    const int* row = truth.ptr<int>(run.y);
    for (int x = run.x; x < run.x + run.length; ++x) shared_px2[row[x]] += 1;
  }
  return shared_px2;
}

bool lies_in_ignored(const SharedPixels& shared_px2, double area_px2) {
  double ignored_px2 = 0;
  for (const auto& [label, px2] : shared_px2) ignored_px2 += label >= kFirstIgnored ? px2 : 0;
  return ignored_px2 > area_px2 / 2;
}

double overlap_of(const cv::Rect& a, const cv::Rect& b) {
  const double common_px2 = (a & b).area();
  return common_px2 / (double(a.area()) + double(b.area()) - common_px2);
}

/// Chooses matches one to one, the greatest overlaps first.
std::vector<TruthMatch> one_to_one(std::vector<TruthMatch> candidates) {
  std::sort(candidates.begin(), candidates.end(), [](const TruthMatch& a, const TruthMatch& b) {
    return std::tuple(-a.overlap, a.truth, a.element) < std::tuple(-b.overlap, b.truth, b.element);
  });
  std::set<int> matched;
  std::set<std::size_t> used;
  std::vector<TruthMatch> chosen;
  for (const TruthMatch& candidate : candidates) {
    if (matched.count(candidate.truth) || used.count(candidate.element)) continue;
    matched.insert(candidate.truth);
    used.insert(candidate.element);
    chosen.push_back(candidate);
  }
  return chosen;
}

/// Collects what the counted elements share with the whole ones.
class Comparing {
 public:
  explicit Comparing(const cv::Mat& truth) : regions_(region_boxes(truth)) {
    for (std::size_t label = 1; label < regions_.size(); ++label) {
      if (is_whole(int(label)) && regions_[label].area_px2 > 0) result_.whole.push_back(int(label));
    }
  }

  void add(const PhotoElement& element, const SharedPixels& shared_px2) {
    const std::size_t index = result_.is_counted.size();
    const bool is_counted = !lies_in_ignored(shared_px2, element.area_px2);
    result_.is_counted.push_back(is_counted);
    if (!is_counted) return;
    int swallowed = 0;  // whole elements that lie mostly in this one
    for (const int label : result_.whole) {
      const RegionBox& region = region_of(label);
      offer(by_boxes_, {label, index, overlap_of(region.box, element.box)});
      const auto shared = shared_px2.find(label);
      if (shared == shared_px2.end()) continue;
      const double common_px2 = shared->second;
      offer(by_masks_, {label, index, common_px2 / (region.area_px2 + element.area_px2 - common_px2)});
      if (common_px2 > element.area_px2 / 2) ++parts_of_[label];
      if (common_px2 > region.area_px2 / 2) ++swallowed;
    }
    if (swallowed > 1) result_.merged.push_back(index);
  }

  TruthComparison take() {
    result_.by_boxes = one_to_one(std::move(by_boxes_));
    result_.by_masks = one_to_one(std::move(by_masks_));
    for (const auto& [label, parts] : parts_of_) {
      if (parts > 1) result_.split.push_back(label);
    }
    return std::move(result_);
  }

 private:
  const RegionBox& region_of(int label) const { return regions_[std::size_t(label)]; }
  static void offer(std::vector<TruthMatch>& candidates, const TruthMatch& match) {
    if (match.overlap >= kLeastMatch) candidates.push_back(match);
  }

  const std::vector<RegionBox> regions_;
  std::vector<TruthMatch> by_boxes_, by_masks_;
  std::map<int, int> parts_of_;  // of whole elements: how many found ones lie mostly in each
  TruthComparison result_;
};

cv::Mat read_truth(const std::string& path, Drawers& drawers) {
  const cv::Mat truth = drawers.labels(read_regular_file(path, kMaxPhotoBytes), path);
  check_truth(truth, path);
  return truth;
}

/// The truth map in the size of the labels, which is `times` times the photo's.
cv::Mat enlarged_truth(const cv::Mat& truth, const std::string& path, cv::Size labels, int times) {
  const cv::Size photo = labels / times;
  const auto text = [](cv::Size size) { return std::to_string(size.width) + " x " + std::to_string(size.height); };
  if (truth.size() != photo) {
    throw InputError(path + ": found a map of " + text(truth.size()) + " px, allowed: the photo's size, " +
                     text(photo) + " px");
  }
  cv::Mat enlarged;
  cv::resize(truth, enlarged, labels, 0, 0, cv::INTER_NEAREST);
  return enlarged;
}

}  // namespace

std::size_t TruthComparison::counted() const {
  return std::size_t(std::count(is_counted.begin(), is_counted.end(), char(true)));
}

TruthComparison compared_with_truth(const cv::Mat& truth, const LabelRuns& labels,
                                    const std::vector<PhotoElement>& elements) {
  Comparing comparing(truth);
  for (const PhotoElement& element : elements) comparing.add(element, shared_pixels(truth, labels, element));
  return comparing.take();
}

void check_truth(const cv::Mat& truth, const std::string& path) {
  for (int y = 0; y < truth.rows; ++y) {
    const int* row = truth.ptr<int>(y);
    const int* other = std::find_if_not(row, row + truth.cols, is_truth_label);
    if (other == row + truth.cols) continue;
    throw InputError(path + ": found the label " + std::to_string(*other) + ", allowed: 0 to " +
                     std::to_string(kMostWhole) + " and " + std::to_string(kFirstIgnored) + " to " +
                     std::to_string(kUnmarked));
  }
}

PhotoComparison compared_photo(const std::string& photo, const std::string& truth, double element_px,
                               Drawers& drawers) {
  TextureRequest request;
  request.photo = photo;
  request.element_px = element_px;
  ExtractionSettings settings = texture_extraction(request);
  settings.ground_px = 0;
  const cv::Mat map = read_truth(truth, drawers);
  PhotoComparison result;
  const std::clock_t begin = std::clock();
  result.extraction = extract_elements(photo, settings, drawers);
  result.processor_s = double(std::clock() - begin) / CLOCKS_PER_SEC;
  const LabelRuns& labels = *result.extraction.labels;
  result.truth = enlarged_truth(map, truth, labels.size(), result.extraction.enlarged);
  result.comparison = compared_with_truth(result.truth, labels, result.extraction.found.elements);
  return result;
}

}  // namespace tessera::bench
