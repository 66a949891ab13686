#include "products/texture/photo_cells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <opencv2/imgproc.hpp>

#include "artwork/nearest_pixels.h"
#include "products/texture/element_pitch.h"

namespace tessera {
namespace {

/// Cells across an element of mean size.
constexpr double kCellsOfElement = 12;
constexpr int kMostJoint_cells = 3;
/// Side of the squares in which elements are counted, in elements of mean size.
constexpr double kSquare_elements = 3;

/// A part of the pitch, about as large as a cell; the cell where there is no pitch.
double divided(double pitch_px, double cell_px) {
  return pitch_px == 0 ? cell_px : pitch_px / std::max(1., std::round(pitch_px / cell_px));
}

/// The number that a cell gets where it shows this label: see PhotoCells.
std::vector<int> values_of_labels(const PhotoLayout& photo) {
  std::vector<int> values(photo.roles.size(), kGroundCell);
  for (std::size_t label = 1; label < values.size(); ++label) {
    if (photo.roles[label] != LabelRole::ground) values[label] = kCutCell;
  }
  for (std::size_t i = 0; i < photo.elements.size(); ++i) values[std::size_t(photo.elements[i].label)] = int(i) + 1;
  return values;
}

/// Cells across the joints between elements. Over a strip the distances to its edges are even from 0 to half its width.
int joint_cells(const cv::Mat& cells) {
  cv::Mat distances;
  cv::distanceTransform(cells == kGroundCell, distances, cv::DIST_L2, cv::DIST_MASK_5);
  std::vector<float> in_ground;
  for (int y = 0; y < cells.rows; ++y) {
    for (int x = 0; x < cells.cols; ++x) {
      if (cells.at<int>(y, x) == kGroundCell) in_ground.push_back(distances.at<float>(y, x));
    }
  }
  if (in_ground.empty()) return 0;
  const auto middle = in_ground.begin() + std::ptrdiff_t(in_ground.size() / 2);
  std::nth_element(in_ground.begin(), middle, in_ground.end());
  constexpr float kToEdge = 0.5F;  // the distance of the outermost cells of a joint to those of an element is 1
  return std::clamp(int(std::lround(4 * (*middle - kToEdge))), 0, kMostJoint_cells);
}

/// The part of a square of the photo that is ground where elements lie close: a quarter of all squares with elements have
/// less.
double ground_part_of(const cv::Mat& cells, double element_side) {
  const int side = std::clamp(int(kSquare_elements * element_side), 1, std::min(cells.cols, cells.rows));
  std::vector<double> parts;
  for (int y = 0; y + side <= cells.rows; y += std::max(1, side / 2)) {
    for (int x = 0; x + side <= cells.cols; x += std::max(1, side / 2)) {
      const cv::Mat square = cells(cv::Rect(x, y, side, side));
      const double elements = cv::countNonZero(square > 0), ground = cv::countNonZero(square == kGroundCell);
      if (elements > 0) parts.push_back(ground / (ground + elements));
    }
  }
  if (parts.empty()) return 1;
  const auto quarter = parts.begin() + std::ptrdiff_t(parts.size() / 4);
  std::nth_element(parts.begin(), quarter, parts.end());
  return *quarter;
}

/// The nearest element of each ground cell that lies in a joint.
cv::Mat rooms_of(const cv::Mat& cells, int joint) {
  cv::Mat rooms = cv::Mat::zeros(cells.size(), CV_32S);
  const NearestPixels elements(cells > kGroundCell);
  for (int y = 0; y < cells.rows; ++y) {
    for (int x = 0; x < cells.cols; ++x) {
      const bool is_joint = cells.at<int>(y, x) == kGroundCell && elements.distance_px({x, y}) <= float(joint);
      if (is_joint) rooms.at<int>(y, x) = cells.at<int>(*elements.nearest({x, y}));
    }
  }
  return rooms;
}

int slot_of(int cell, int room) {
  if (cell == kCutCell) return 2 * kCutThing;
  if (cell == kGroundCell) return room > 0 ? 2 * (kFirstElement + room - 1) + 1 : 2 * kGroundThing;
  return 2 * (kFirstElement + cell - 1);
}

cv::Mat runs_of(const cv::Mat& cells, const cv::Mat& rooms) {
  cv::Mat runs(cells.size(), CV_32SC2);
  for (int y = 0; y < cells.rows; ++y) {
    auto* row = runs.ptr<CellRun>(y);
    for (int x = cells.cols - 1; x >= 0; --x) {
      row[x] = {1, slot_of(cells.at<int>(y, x), rooms.at<int>(y, x))};
      if (x + 1 < cells.cols && row[x + 1].slot == row[x].slot) row[x].length += row[x + 1].length;
    }
  }
  return runs;
}

CellElement cell_element(const PhotoCells& photo, const cv::Rect& box_px, int value, int joint) {
  const auto cell_of = [&](cv::Point px) {
    return cv::Point(int(px.x / photo.cell_px.width), int(px.y / photo.cell_px.height));
  };
  const cv::Point more(joint, joint);
  const cv::Rect box = cv::Rect(cell_of(box_px.tl()) - more, cell_of(box_px.br()) + cv::Point(1, 1) + more) &
                       cv::Rect({}, photo.cells.size());
  CellElement element{0, box.tl(), cv::Mat::zeros(box.size(), CV_8U), cell_of((box_px.tl() + box_px.br()) / 2)};
  element.mask.setTo(kElementCell, photo.cells(box) == value);
  element.mask.setTo(kRoomCell, photo.rooms(box) == value);
  element.area = cv::countNonZero(element.mask == kElementCell);
  return element;
}

}  // namespace

PhotoCells photo_cells(const PhotoLayout& photo) {
  const std::vector<int> values = values_of_labels(photo);
  const double side_px = mean_side_px(photo.elements), cell_px = std::max(1., side_px / kCellsOfElement);
  const cv::Size2d pitch_px = element_pitch_px(photo.labels, side_px);
  PhotoCells result;
  result.cell_px = {divided(pitch_px.width, cell_px), divided(pitch_px.height, cell_px)};
  result.element_side = side_px / std::sqrt(result.cell_px.area());
  const cv::Mat labels = photo.labels.labels();
  result.cells.create(std::max(1, int(labels.rows / result.cell_px.height)),
                      std::max(1, int(labels.cols / result.cell_px.width)), CV_32S);
  for (int y = 0; y < result.cells.rows; ++y) {
    const int* row = labels.ptr<int>(std::min(int((y + 0.5) * result.cell_px.height), labels.rows - 1));
    for (int x = 0; x < result.cells.cols; ++x)
      result.cells.at<int>(y, x) =
          values[std::size_t(row[std::min(int((x + 0.5) * result.cell_px.width), labels.cols - 1)])];
  }
  result.ground_part = ground_part_of(result.cells, result.element_side);
  const int joint = joint_cells(result.cells);
  result.rooms = rooms_of(result.cells, joint);
  result.runs = runs_of(result.cells, result.rooms);
  for (std::size_t i = 0; i < photo.elements.size(); ++i)
    result.elements.push_back(cell_element(result, photo.elements[i].box, int(i) + 1, joint));
  return result;
}

}  // namespace tessera
