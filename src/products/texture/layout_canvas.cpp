#include "products/texture/layout_canvas.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace tessera {
namespace {

/// The part of its area by which an element may overlap others. Its joints count half.
constexpr double kMostOverlapped = 0.1;
/// Holes narrower than this are slits, which the ground fills.
constexpr int kSlit_cells = 3;

int whole_steps(double px, int step_px) { return step_px * int(std::lround(px / step_px)); }

int positive_rest(int value, int period) { return ((value % period) + period) % period; }

}  // namespace

bool has_middle_in(const Patch& patch, const CellElement& element) { return patch.in_photo().contains(element.middle); }

LayoutCanvas::LayoutCanvas(const PhotoCells& photo, cv::Size size)
    : photo_(&photo),
      above_(size, CV_32S, cv::Scalar(0)),
      below_(size, CV_8U, cv::Scalar(kOpen)),
      middles_(photo.elements.size()) {
  for (const CellElement& element : photo.elements) reach_ = std::max({reach_, element.mask.cols, element.mask.rows});
}

cv::Point LayoutCanvas::wrapped(cv::Point at) const {
  return {positive_rest(at.x, above_.cols), positive_rest(at.y, above_.rows)};
}

template <class Visit>
void LayoutCanvas::for_each_box(const cv::Rect& region, const Visit& visit) const {
  for (int y = 0, height = 0; y < region.height; y += height) {
    for (int x = 0, width = 0; x < region.width; x += width) {
      const cv::Point at = wrapped(region.tl() + cv::Point(x, y));
      width = std::min(region.width - x, above_.cols - at.x);
      height = std::min(region.height - y, above_.rows - at.y);
      visit({at, cv::Size(width, height)}, {{x, y}, cv::Size(width, height)});
    }
  }
}

CanvasPart LayoutCanvas::part(const cv::Rect& region) const {
  CanvasPart part{cv::Mat(region.size(), CV_32S), cv::Mat(region.size(), CV_8U)};
  for_each_box(region, [&](const cv::Rect& on_canvas, const cv::Rect& in_part) {
    above_(on_canvas).copyTo(part.above(in_part));
    below_(on_canvas).copyTo(part.below(in_part));
  });
  return part;
}

bool LayoutCanvas::may_overlap(std::size_t element, int overlapped) const {
  return overlapped <= kMostOverlapped * kElementCell * photo_->elements[element].area;
}

bool LayoutCanvas::has_copy_near(std::size_t element, cv::Point middle, double distance) const {
  return std::any_of(middles_[element].begin(), middles_[element].end(), [&](cv::Point other) {
    const cv::Point d = wrapped(other - middle);
    const double dx = std::min(d.x, above_.cols - d.x), dy = std::min(d.y, above_.rows - d.y);
    return dx * dx + dy * dy < distance * distance;
  });
}

template <class Visit>
void LayoutCanvas::for_each_cell(std::size_t element, cv::Point shift, const Visit& visit) const {
  const CellElement& shape = photo_->elements[element];
  for (int y = 0; y < shape.mask.rows; ++y) {
    for (int x = 0; x < shape.mask.cols; ++x) {
      if (const std::uint8_t kind = shape.mask.at<std::uint8_t>(y, x))
        visit(wrapped(shape.corner + shift + cv::Point(x, y)), kind);
    }
  }
}

int LayoutCanvas::overlap(std::size_t element, cv::Point shift) const {
  int sum = 0;
  for_each_cell(element, shift, [&](cv::Point at, std::uint8_t kind) { sum += above_.at<int>(at) > 0 ? kind : 0; });
  return sum;
}

void LayoutCanvas::lay(std::size_t element, cv::Point shift, int overlapped) {
  laid_.push_back({element, shift, overlapped});
  middles_[element].push_back(wrapped(photo_->elements[element].middle + shift));
  for_each_cell(element, shift, [&](cv::Point at, std::uint8_t kind) {
    if (int& cell = above_.at<int>(at); cell == 0 && kind == kElementCell) cell = int(laid_.size());
  });
}

void LayoutCanvas::lay(const Patch& patch) {
  std::vector<std::pair<double, std::size_t>> elements;
  for (std::size_t i = 0; i < photo_->elements.size(); ++i) {
    const CellElement& element = photo_->elements[i];
    const bool fits = element.mask.cols <= above_.cols && element.mask.rows <= above_.rows;
    if (fits && element.area > 0 && has_middle_in(patch, element))
      elements.emplace_back(double(overlap(i, patch.shift())) / element.area, i);
  }
  std::sort(elements.begin(), elements.end());
  for (const auto& [part, i] : elements) {
    const int overlapped = overlap(i, patch.shift());
    if (may_overlap(i, overlapped)) lay(i, patch.shift(), overlapped);
  }
  lay_below(patch);
}

void LayoutCanvas::lay_below(const Patch& patch) {
  for (int y = 0; y < patch.side; ++y) {
    for (int x = 0; x < patch.side; ++x) {
      const int shown = photo_->cells.at<int>(patch.from + cv::Point(x, y));
      std::uint8_t& below = below_.at<std::uint8_t>(wrapped(patch.to + cv::Point(x, y)));
      if (shown == kGroundCell) {
        below = kLaidGround;
      } else if (below == kOpen &&
                 (shown == kCutCell || has_middle_in(patch, photo_->elements[std::size_t(shown) - 1]))) {
        below = kHole;
      }
    }
  }
}

void LayoutCanvas::close() { below_.setTo(kHole, below_ == kOpen); }

void LayoutCanvas::clear(cv::Point corner, int side) {
  const cv::Size region(std::min(side + 2 * reach_, above_.cols), std::min(side + 2 * reach_, above_.rows));
  before_ = {cv::Rect(corner - cv::Point(reach_, reach_), region), {}, {}, {}, laid_.size(), 0};
  CanvasPart part = this->part(before_.region);
  before_.above = part.above;
  before_.below = part.below;
  before_.badness = kElementCell * holes_in(before_.region);
  for (std::size_t i = 0; i < laid_.size(); ++i) {
    Instance& instance = laid_[i];
    const cv::Point middle = wrapped(photo_->elements[instance.element].middle + instance.shift);
    const cv::Point in_square = wrapped(middle - corner);
    if (!instance.stands || in_square.x >= side || in_square.y >= side) continue;
    instance.stands = false;
    before_.cleared.push_back(i);
    before_.badness += instance.overlapped;
    std::vector<cv::Point>& middles = middles_[instance.element];
    middles.erase(std::find(middles.begin(), middles.end(), middle));
    for_each_cell(instance.element, instance.shift, [&](cv::Point at, std::uint8_t) {
      if (above_.at<int>(at) != int(i) + 1) return;
      above_.at<int>(at) = 0;
      below_.at<std::uint8_t>(at) = kHole;
    });
  }
}

int LayoutCanvas::gain() const {
  int badness = kElementCell * holes_in(before_.region);
  for (std::size_t i = before_.laid; i < laid_.size(); ++i) badness += laid_[i].overlapped;
  return before_.badness - badness;
}

void LayoutCanvas::undo() {
  for (std::size_t i = before_.laid; i < laid_.size(); ++i) middles_[laid_[i].element].pop_back();
  laid_.resize(before_.laid);
  for (const std::size_t i : before_.cleared) {
    laid_[i].stands = true;
    middles_[laid_[i].element].push_back(wrapped(photo_->elements[laid_[i].element].middle + laid_[i].shift));
  }
  for_each_box(before_.region, [&](const cv::Rect& on_canvas, const cv::Rect& in_region) {
    before_.above(in_region).copyTo(above_(on_canvas));
    before_.below(in_region).copyTo(below_(on_canvas));
  });
}

int LayoutCanvas::holes_in(const cv::Rect& region) const {
  int count = 0;
  for_each_box(region, [&](const cv::Rect& on_canvas, const cv::Rect&) {
    count += cv::countNonZero((above_(on_canvas) == 0) & (below_(on_canvas) != kLaidGround));
  });
  return count;
}

std::vector<cv::Point> LayoutCanvas::wide_holes() const {
  cv::Mat wide, labels, boxes, middles;
  cv::erode((above_ == 0) & (below_ != kLaidGround), wide, cv::Mat::ones(kSlit_cells, kSlit_cells, CV_8U));
  const int count = cv::connectedComponentsWithStats(wide, labels, boxes, middles, 8, CV_32S);
  std::vector<cv::Point> holes;
  for (int hole = 1; hole < count; ++hole)
    holes.emplace_back(cvRound(middles.at<double>(hole, 0)), cvRound(middles.at<double>(hole, 1)));
  return holes;
}

std::vector<LaidElement> LayoutCanvas::laid(int step_px) const {
  std::vector<LaidElement> all;
  for (const Instance& instance : laid_) {
    if (!instance.stands) continue;
    all.push_back({instance.element,
                   {whole_steps(instance.shift.x * photo_->cell_px.width, step_px),
                    whole_steps(instance.shift.y * photo_->cell_px.height, step_px)}});
  }
  return all;
}

}  // namespace tessera
