#include "products/elements/photo_margin.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "products/elements/segmentation/region_labels.h"

namespace tessera {
namespace {

/// Parts of the square root of an element's area: the width of a margin, and the distance of its inside from its edge.
constexpr double kMostMargin = 0.08;
constexpr double kInside = 0.12;
/// The largest window that is examined pixel by pixel; of a larger one a reduced copy is used.
constexpr double kMostWindow_px2 = 2e6;

/// Marks pixels of the window that are near to edges of the photo that the element reaches.
cv::Mat near_edges(const cv::Rect& window, const cv::Rect& box, const cv::Size& photo, int margin_px) {
  cv::Mat near = cv::Mat::zeros(window.size(), CV_8U);
  const auto mark = [&](const cv::Rect& strip) { near((strip & window) - window.tl()).setTo(255); };
  if (box.x == 0) mark({0, 0, margin_px, photo.height});
  if (box.y == 0) mark({0, 0, photo.width, margin_px});
  if (box.br().x == photo.width) mark({photo.width - margin_px, 0, margin_px, photo.height});
  if (box.br().y == photo.height) mark({0, photo.height - margin_px, photo.width, margin_px});
  return near;
}

cv::Mat distances_from(const cv::Mat& bgr, const cv::Scalar& colour) {
  cv::Mat difference;
  cv::absdiff(bgr, colour, difference);
  cv::transform(difference, difference, cv::Matx13f(1, 1, 1));
  return difference;
}

cv::Mat at_size(const cv::Mat& picture, cv::Size size, int filter) {
  cv::Mat result = picture;
  if (picture.size() != size) cv::resize(picture, result, size, 0, 0, filter);
  return result;
}

/// The margin in the element: a mask of the window, or empty where it cannot be told. `near`: of the window, from
/// near_edges().
cv::Mat margin_of(const cv::Mat& photo, const cv::Mat& element, const cv::Mat& gap, const cv::Mat& near,
                  double size_px) {
  cv::Mat depth_px;
  cv::distanceTransform(element, depth_px, cv::DIST_L2, 3);
  const cv::Mat inside = depth_px > kInside * size_px, bgr = bgr_of(photo);
  if (cv::countNonZero(inside) == 0 || cv::countNonZero(gap) == 0) return {};
  const cv::Mat is_gap_like = distances_from(bgr, cv::mean(bgr, gap)) < distances_from(bgr, cv::mean(bgr, inside));
  return near & element & is_gap_like;
}

}  // namespace

LabelRuns without_margins(const cv::Mat& photo, const LabelRuns& labels) {
  const cv::Mat elements = labels.mask();
  std::vector<std::vector<LabelRun>> result(labels.regions().size());
  for (std::size_t label = 1; label < result.size(); ++label) {
    const auto& [box, area_px2] = labels.regions()[label];
    const auto all = labels.runs_of(label);
    result[label].assign(all.begin(), all.end());
    if (area_px2 == 0 || !reaches_edge(box, labels.size())) continue;
    const cv::Rect window = grown_within(box, std::max(box.width, box.height) / 4 + 2, labels.size());
    const double zoom = std::min(1., std::sqrt(kMostWindow_px2 / window.area())), size_px = std::sqrt(area_px2);
    const cv::Size size(std::max(1, int(window.width * zoom)), std::max(1, int(window.height * zoom)));
    const int margin_px = std::max(1, int(kMostMargin * size_px));
    cv::Mat element = labels.mask_of(label, window);
    const cv::Mat margin =
        margin_of(at_size(photo(window), size, cv::INTER_AREA), at_size(element, size, cv::INTER_NEAREST),
                  at_size(elements(window), size, cv::INTER_NEAREST) == 0,
                  at_size(near_edges(window, box, labels.size(), margin_px), size, cv::INTER_NEAREST), zoom * size_px);
    if (margin.empty()) continue;
    element.setTo(0, at_size(margin, window.size(), cv::INTER_NEAREST));
    result[label].clear();
    append_runs(solid_part(element), window.tl(), result[label]);
  }
  return {labels.size(), result};
}

}  // namespace tessera
