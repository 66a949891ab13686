#include "products/mosaic/segmentation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "products/elements/segmentation/boundary_map.h"
#include "products/elements/segmentation/colour_clusters.h"
#include "products/mosaic/size_map.h"

namespace tessera {
namespace {

/// Colours nearer to each other than this (CIELAB) become one.
constexpr double kLeastDifference = 8;
/// The Gaussian for the majority of labels around each place, in sizes of the smallest piece. Parts narrower than about
/// twice that disappear.
constexpr double kMajoritySigma = 0.6;
constexpr int kMajorityRounds = 3;
/// The least area of a part of a region, in areas of the smallest piece: four pieces of the mean size.
constexpr double kLeastPart = 16;
/// Limits of a canvas.file: 50 million px, and 8192 in each direction.
constexpr double kMostPicture_px2 = 49e6;
constexpr double kMostPictureSide_px = 8192;

using Labels = cv::Mat_<std::uint8_t>;

int count_of(const Labels& labels) {
  double most = 0;
  cv::minMaxLoc(labels, nullptr, &most);
  return int(most) + 1;
}

/// The mean of the CV_32FC3 `lab` for each label, and 0, 0, 0 where it has no pixel.
std::vector<cv::Vec3f> means_of(const cv::Mat& lab, const Labels& labels) {
  std::vector<cv::Vec3d> sums(std::size_t(count_of(labels)), {0, 0, 0});
  std::vector<int> pixels(sums.size(), 0);
  for (int y = 0; y < lab.rows; ++y) {
    for (int x = 0; x < lab.cols; ++x) {
      sums[labels(y, x)] += cv::Vec3d(lab.at<cv::Vec3f>(y, x));
      ++pixels[labels(y, x)];
    }
  }
  std::vector<cv::Vec3f> means;
  for (std::size_t i = 0; i < sums.size(); ++i) means.emplace_back(sums[i] / std::max(1, pixels[i]));
  return means;
}

void relabel(Labels& labels, const std::vector<int>& names) {
  for (std::uint8_t& label : labels) label = std::uint8_t(names[label]);
}

/// New numbers 0, 1, ... for the labels that occur, in their order.
std::vector<int> compact_label_numbers(const Labels& labels) {
  std::vector<int> names(std::size_t(count_of(labels)), -1);
  for (const std::uint8_t label : labels) names[label] = 0;
  int count = 0;
  for (int& name : names) {
    if (name == 0) name = count++;
  }
  return names;
}

void join_like_colours(const cv::Mat& lab, Labels& labels) {
  const std::vector<cv::Vec3f> means = means_of(lab, labels);
  std::vector<int> names;
  for (int i = 0; i < int(means.size()); ++i) {
    int name = i;
    for (int other = 0; other < i && name == i; ++other) {
      if (cv::norm(means[std::size_t(i)] - means[std::size_t(other)]) < kLeastDifference)
        name = names[std::size_t(other)];
    }
    names.push_back(name);
  }
  relabel(labels, names);
}

double smallest_piece_cells(const MosaicPlan& plan) { return plan.min_scale_px / kSizeMapPixel_px; }

/// The share of the label around each place, CV_32F.
cv::Mat share_of(const Labels& labels, int label, double sigma_cells) {
  cv::Mat share;
  cv::Mat(labels == label).convertTo(share, CV_32F, 1. / 255);
  cv::GaussianBlur(share, share, {}, sigma_cells, sigma_cells, cv::BORDER_REPLICATE);
  return share;
}

void take_majority(Labels& labels, double sigma_cells) {
  const int count = count_of(labels);
  cv::Mat most = share_of(labels, 0, sigma_cells);
  Labels winners(labels.size(), std::uint8_t(0));
  for (int label = 1; label < count; ++label) {
    const cv::Mat share = share_of(labels, label, sigma_cells);
    winners.setTo(label, share > most);
    most = cv::max(most, share);
  }
  labels = winners;
}

/// Marks with 255 the connected parts of one label that have at least so many cells.
Labels large_parts(const Labels& labels, double least_cells) {
  const int count = count_of(labels);
  Labels large(labels.size(), std::uint8_t(0));
  for (int label = 0; label < count; ++label) {
    cv::Mat parts, statistics, centres;
    cv::connectedComponentsWithStats(labels == label, parts, statistics, centres, 4, CV_32S);
    for (int y = 0; y < parts.rows; ++y) {
      for (int x = 0; x < parts.cols; ++x) {
        const int part = parts.at<int>(y, x);
        if (part > 0 && statistics.at<int>(part, cv::CC_STAT_AREA) >= least_cells) large(y, x) = 255;
      }
    }
  }
  return large;
}

/// Gives parts with fewer cells to the parts around them. These grow cell by cell, so that each stays connected. If there
/// are no others, nothing changes.
void join_islands(Labels& labels, double least_cells) {
  Labels settled = large_parts(labels, least_cells);
  std::vector<cv::Point> settled_cells;
  cv::findNonZero(settled, settled_cells);
  const cv::Rect all({}, labels.size());
  for (std::size_t i = 0; i < settled_cells.size(); ++i) {
    const cv::Point from = settled_cells[i];
    for (const cv::Point& step : {cv::Point(1, 0), cv::Point(-1, 0), cv::Point(0, 1), cv::Point(0, -1)}) {
      const cv::Point to = from + step;
      if (!all.contains(to) || settled(to) != 0) continue;
      settled(to) = 255;
      labels(to) = labels(from);
      settled_cells.push_back(to);
    }
  }
}

cv::Vec3b bgr_of_lab(const cv::Vec3f& lab) {
  const cv::Mat from(1, 1, CV_32FC3, cv::Scalar(lab[0], lab[1], lab[2]));
  cv::Mat bgr, bytes;
  cv::cvtColor(from, bgr, cv::COLOR_Lab2BGR);
  bgr.convertTo(bytes, CV_8U, 255);
  return bytes.at<cv::Vec3b>(0, 0);
}

cv::Size picture_size(const MosaicPlan& plan) {
  const cv::Size2d whole(2. * plan.canvas_px.width, 2. * plan.canvas_px.height);
  const double scale = std::min(
      {1., kMostPictureSide_px / std::max(whole.width, whole.height), std::sqrt(kMostPicture_px2 / whole.area())});
  return {std::max(1, int(scale * whole.width)), std::max(1, int(scale * whole.height))};
}

/// The two rows or columns of cells beside a pixel, and the share of the second one.
struct Between {
  int first = 0, second = 0;
  float share = 0;
};

std::vector<Between> places_between(int pixels, int cells) {
  std::vector<Between> places;
  for (int i = 0; i < pixels; ++i) {
    const double at = std::clamp((i + 0.5) * cells / pixels - 0.5, 0., cells - 1.);
    const int first = int(at);
    places.push_back({first, std::min(first + 1, cells - 1), float(at - first)});
  }
  return places;
}

/// The label of a pixel. `shares`: one channel for each label.
int label_between(const cv::Mat& shares, const Between& row, const Between& column) {
  const int count = shares.channels();
  const auto cell = [&](int y, int x) { return shares.ptr<float>(y) + std::ptrdiff_t(x) * count; };
  const float *a = cell(row.first, column.first), *b = cell(row.first, column.second);
  const float *c = cell(row.second, column.first), *d = cell(row.second, column.second);
  int winner = 0;
  float most = -1;
  for (int label = 0; label < count; ++label) {
    const float above = a[label] + (b[label] - a[label]) * column.share;
    const float below = c[label] + (d[label] - c[label]) * column.share;
    const float share = above + (below - above) * row.share;
    if (share <= most) continue;
    most = share;
    winner = label;
  }
  return winner;
}

}  // namespace

Segmentation segmentation(const cv::Mat& image_bgr, const MosaicPlan& plan, int regions) {
  const cv::Size size = size_map_size(plan);
  cv::Mat picture;
  cv::resize(image_bgr, picture, size, 0, 0, image_bgr.cols > size.width ? cv::INTER_AREA : cv::INTER_LINEAR);
  const cv::Mat lab = smooth_lab(picture);

  Labels labels = colour_clusters(lab, regions);
  join_like_colours(lab, labels);
  const std::vector<cv::Vec3f> means = means_of(lab, labels);
  const double smallest_cells = smallest_piece_cells(plan);
  for (int round = 0; round < kMajorityRounds; ++round) take_majority(labels, kMajoritySigma * smallest_cells);
  join_islands(labels, kLeastPart * smallest_cells * smallest_cells);

  const std::vector<int> names = compact_label_numbers(labels);
  relabel(labels, names);
  Segmentation result{.labels = labels, .colours = {}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] < 0) continue;
    result.colours.push_back(bgr_of_lab(means[i]));
  }
  return result;
}

cv::Mat region_picture(const Segmentation& segmentation, const MosaicPlan& plan) {
  const Labels labels = segmentation.labels;
  std::vector<cv::Mat> parts;
  for (int label = 0; label < int(segmentation.colours.size()); ++label) parts.push_back(share_of(labels, label, 1));
  cv::Mat shares;
  cv::merge(parts, shares);
  const cv::Size size = picture_size(plan);
  const std::vector<Between> columns = places_between(size.width, labels.cols);
  const std::vector<Between> rows = places_between(size.height, labels.rows);
  cv::Mat picture(size, CV_8UC4);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const int label = label_between(shares, rows[std::size_t(y)], columns[std::size_t(x)]);
      const cv::Vec3b colour = segmentation.colours[std::size_t(label)];
      picture.at<cv::Vec4b>(y, x) = {colour[0], colour[1], colour[2], 255};
    }
  }
  // An opaque image would be cut out of its background, and refused if that is not plain; an image with transparency is
  // taken as it is. An alpha of 254 is invisible.
  picture.at<cv::Vec4b>(0, 0)[3] = 254;
  return picture;
}

}  // namespace tessera
