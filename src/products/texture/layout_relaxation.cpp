#include "products/texture/layout_relaxation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "products/texture/element_joints.h"
#include "products/texture/spring_network.h"

namespace tessera {
namespace {

/// The copy on which joints are measured: the side of a mean element, and the most pixels of it.
constexpr double kElementInCopy_px = 40;
constexpr double kMostCopy_px2 = 4e6;
/// Wider gaps are no joints, but room for another element. In sides of a mean element.
constexpr double kMostJoint_elements = 0.8;
/// The range of the photo's joints that is usual.
constexpr double kNarrow = 0.25, kWide = 0.75;
constexpr int kRounds = 6;
/// The longest way of an element in a round, in sides of a mean element.
constexpr double kMostWay_elements = 0.15;
/// A joint is no wider than at its narrowest place and this, in sides of a mean element. Else gaps would pull the elements round
/// them together.
constexpr double kOpening_elements = 0.25;
/// Elements that face each other by less are no neighbours, as those at opposite corners of a crossing, which would pull rows
/// of tiles out of line. In sides of a mean element.
constexpr double kLeastFacing_elements = 0.25;
/// How much elements of one patch hold each other along a joint, relative to across it.
constexpr double kAlong = 0.1;

class Relaxation {
 public:
  Relaxation(const PhotoLayout& photo, const std::vector<LaidElement>& laid, cv::Size canvas_px)
      : photo_(photo),
        laid_(laid),
        side_px_(mean_side_px(photo.elements)),
        scale_(std::min(kElementInCopy_px / side_px_, std::sqrt(kMostCopy_px2 / canvas_px.area()))),
        copy_(int(std::lround(canvas_px.width * scale_)), int(std::lround(canvas_px.height * scale_))),
        ways_(laid.size()) {
    for (const PhotoElement& element : photo.elements)
      masks_.push_back(scaled(photo.labels.mask_of(std::size_t(element.label))));
    measure_photo();
  }

  void round() {
    const std::vector<cv::Vec2d> more = ways_at_rest(springs(), ways_);
    const double most = kMostWay_elements * side_px_ * scale_;
    for (std::size_t i = 0; i < ways_.size(); ++i) {
      const double length = cv::norm(more[i]);
      ways_[i] += more[i] * std::min(1., most / std::max(length, 1e-9));
    }
  }

  /// The ways, multiples of the step.
  cv::Point way_px(std::size_t i) const {
    const auto whole = [&](double way) { return photo_.step_px * int(std::lround(way / scale_ / photo_.step_px)); };
    return {whole(ways_[i][0]), whole(ways_[i][1])};
  }

 private:
  cv::Mat scaled(const cv::Mat& mask) const {
    cv::Mat copy;
    const cv::Size size(std::max(1, int(std::lround(mask.cols * scale_))),
                        std::max(1, int(std::lround(mask.rows * scale_))));
    cv::resize(mask, copy, size, 0, 0, cv::INTER_AREA);
    return copy > 127;
  }

  /// Paints an element into a map whose edges meet; the first one that was painted stays.
  void paint(std::size_t element, double x_px, double y_px, int number, cv::Mat& map) const {
    const cv::Mat& mask = masks_[element];
    const int left = int(std::lround(x_px)), top = int(std::lround(y_px));
    for (int y = 0; y < mask.rows; ++y) {
      int* row = map.ptr<int>(((top + y) % map.rows + map.rows) % map.rows);
      for (int x = 0; x < mask.cols; ++x) {
        if (!mask.at<std::uint8_t>(y, x)) continue;
        int& cell = row[((left + x) % map.cols + map.cols) % map.cols];
        if (cell == 0) cell = number;
      }
    }
  }

  float most_joint() const { return float(kMostJoint_elements * side_px_ * scale_); }

  /// Measures the photo's own joints, between whole elements.
  void measure_photo() {
    cv::Mat map = cv::Mat::zeros(int(photo_.labels.size().height * scale_) + 1,
                                 int(photo_.labels.size().width * scale_) + 1, CV_32S);
    for (std::size_t i = 0; i < masks_.size(); ++i) {
      const cv::Point corner = photo_.elements[i].box.tl();
      paint(i, corner.x * scale_, corner.y * scale_, int(i) + 1, map);
    }
    std::vector<float> widths;
    for (const JointPlace& place : joint_places(map, most_joint())) widths.push_back(place.width_px);
    if (widths.empty()) return;
    const auto at = [&](double part) {
      const auto middle = widths.begin() + std::ptrdiff_t(part * double(widths.size() - 1));
      std::nth_element(widths.begin(), middle, widths.end());
      return *middle;
    };
    narrow_ = at(kNarrow);
    wide_ = at(kWide);
  }

  std::vector<JointPlace> places() const {
    cv::Mat map = cv::Mat::zeros(copy_, CV_32S), wrapped;
    for (std::size_t i = 0; i < laid_.size(); ++i) {
      const cv::Point corner = photo_.elements[laid_[i].element].box.tl() + laid_[i].shift_px;
      paint(laid_[i].element, corner.x * scale_ + ways_[i][0], corner.y * scale_ + ways_[i][1], int(i) + 1, map);
    }
    // Joints that reach over an edge are found in the border.
    const int border = std::min({copy_.width, copy_.height, int(2 * most_joint()) + 1});
    cv::copyMakeBorder(map, wrapped, 0, border, 0, border, cv::BORDER_WRAP);
    return joint_places(wrapped, most_joint());
  }

  std::vector<Spring> springs() const {
    const std::vector<JointPlace> all = places();
    std::vector<Spring> springs;
    for (auto begin = all.begin(), end = begin; begin != all.end(); begin = end) {
      end = std::find_if(begin, all.end(), [&](const JointPlace& place) {
        return place.first != begin->first || place.second != begin->second;
      });
      const std::vector<JointPlace> facing = facing_places(begin, end);
      if (double(facing.size()) >= kLeastFacing_elements * side_px_ * scale_) springs.push_back(spring_across(facing));
    }
    return springs;
  }

  /// The places of a joint without those where it opens into a gap.
  template <class Places>
  std::vector<JointPlace> facing_places(Places begin, Places end) const {
    const auto narrower = [](const JointPlace& a, const JointPlace& b) { return a.width_px < b.width_px; };
    const double most_px = std::min_element(begin, end, narrower)->width_px + kOpening_elements * side_px_ * scale_;
    std::vector<JointPlace> facing;
    std::copy_if(begin, end, std::back_inserter(facing),
                 [&](const JointPlace& place) { return place.width_px <= most_px; });
    return facing;
  }

  /// The spring of a joint.
  Spring spring_across(const std::vector<JointPlace>& joint) const {
    Spring spring{std::size_t(joint.front().first) - 1, std::size_t(joint.front().second) - 1, {}, {}};
    const bool of_one_patch = laid_[spring.first].shift_px == laid_[spring.second].shift_px;
    const cv::Vec2d opened = ways_[spring.second] - ways_[spring.first];
    for (const JointPlace& place : joint) {
      const cv::Vec2d across(place.across[0], place.across[1]);
      const cv::Matx22d normal = across * across.t();
      spring.stiffness += normal;
      if (of_one_patch) {
        const cv::Matx22d along = kAlong * cv::Matx22d::eye();
        spring.stiffness += along;
        spring.pull += (normal + along) * opened;
      } else {
        const float usual_px = std::clamp(place.width_px, narrow_, wide_);
        spring.pull += double(place.width_px - usual_px) * across;
      }
    }
    return spring;
  }

  const PhotoLayout& photo_;
  const std::vector<LaidElement>& laid_;
  const double side_px_;         // of a mean element
  const double scale_;           // of the copy
  const cv::Size copy_;          // the canvas
  std::vector<cv::Mat> masks_;   // of the photo's elements, in the copy
  float narrow_ = 0, wide_ = 0;  // the usual joints, px of the copy
  std::vector<cv::Vec2d> ways_;  // of the laid elements, px of the copy
};

}  // namespace

std::vector<LaidElement> relaxed_layout(const PhotoLayout& photo, std::vector<LaidElement> laid, cv::Size canvas_px) {
  if (laid.empty()) return laid;
  Relaxation relaxation(photo, laid, canvas_px);
  for (int i = 0; i < kRounds; ++i) relaxation.round();
  std::vector<LaidElement> moved = laid;
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i].shift_px += relaxation.way_px(i);
  return moved;
}

}  // namespace tessera
