#include "products/elements/elements_overview.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

namespace tessera {
namespace {

const cv::Scalar kWhite(255, 255, 255), kBlack(0, 0, 0), kLine(40, 60, 230);
constexpr double kMostPixels = 16e6;

/// An element and the scale at which it is shown.
struct Shown {
  double zoom;  // of the overview, relative to the photo
  const PhotoElement& element;

  double size_px() const { return zoom * std::sqrt(element.area_px2); }
};

cv::Point scaled(cv::Point point, double zoom) { return {int(point.x * zoom), int(point.y * zoom)}; }

/// Writes a number that fits into the element and is readable on light and dark colours.
void write_number(cv::Mat& picture, const Shown& shown, std::size_t number) {
  constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
  const std::string text = std::to_string(number);
  const cv::Size unit = cv::getTextSize(text, kFont, 1, 1, nullptr);
  const double size = std::clamp(0.5 * shown.size_px() / std::max(unit.width, 2 * unit.height), 0.3, 3.0);
  const cv::Rect& box = shown.element.box;
  const cv::Point middle = scaled((box.tl() + box.br()) / 2, shown.zoom);
  const cv::Point origin(middle.x - int(size * unit.width / 2), middle.y + int(size * unit.height / 2));
  const int stroke = std::max(1, int(1.5 * size));
  cv::putText(picture, text, origin, kFont, size, kBlack, 3 * stroke, cv::LINE_AA);
  cv::putText(picture, text, origin, kFont, size, kWhite, stroke, cv::LINE_AA);
}

void draw_outline(cv::Mat& picture, const LabelRuns& labels, const Shown& shown) {
  const PhotoElement& element = shown.element;
  std::vector<std::vector<cv::Point>> curves;
  cv::findContours(labels.mask_of(std::size_t(element.label)), curves, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE,
                   element.box.tl());
  for (std::vector<cv::Point>& curve : curves) {
    for (cv::Point& point : curve) point = scaled(point, shown.zoom);
  }
  const int width_px = std::clamp(int(shown.size_px() / 40), 1, 5);
  cv::drawContours(picture, curves, -1, kLine, width_px, cv::LINE_AA);
}

}  // namespace

cv::Mat elements_overview(const cv::Mat& photo, const LabelRuns& labels, const std::vector<PhotoElement>& elements) {
  const double zoom = std::min(1., std::sqrt(kMostPixels / std::max(1., double(photo.total()))));
  cv::Mat picture = photo;
  if (zoom < 1) cv::resize(photo, picture, scaled({photo.cols, photo.rows}, zoom), 0, 0, cv::INTER_AREA);
  cv::cvtColor(picture, picture, cv::COLOR_BGRA2BGR);
  picture.convertTo(picture, -1, 0.7, 0.3 * 255);  // towards white
  for (const PhotoElement& element : elements) draw_outline(picture, labels, {zoom, element});
  for (std::size_t i = 0; i < elements.size(); ++i) write_number(picture, {zoom, elements[i]}, i + 1);
  return picture;
}

}  // namespace tessera
