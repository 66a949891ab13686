#include "image_quilting.h"

#include <algorithm>
#include <cstddef>
#include <opencv2/imgproc.hpp>
#include <random>
#include <stdexcept>
#include <string>

namespace tessera::bench {
namespace {

/// A block overlaps each neighbour by this part of its side, and may be worse than the best one by this part of the error.
/// Both are the paper's.
constexpr int kSidesToOverlap = 6;
constexpr double kTolerance = 0.1;

void check(const cv::Mat& photo, int block_px) {
  const int most_px = std::min(photo.cols, photo.rows);
  if (photo.type() != CV_8UC3) throw std::invalid_argument("a photo to be quilted must be CV_8UC3");
  if (block_px < kLeastBlock_px || block_px > most_px)
    throw std::invalid_argument("a block for quilting has " + std::to_string(block_px) +
                                " px; allowed: " + std::to_string(kLeastBlock_px) + " to " + std::to_string(most_px));
}

/// The squared difference of two pictures of one size, summed over the channels: CV_32F.
cv::Mat pixel_errors(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat difference, errors;
  cv::absdiff(a, b, difference);
  difference.convertTo(difference, CV_32F);
  cv::transform(difference.mul(difference), errors, cv::Matx13f(1, 1, 1));
  return errors;
}

class Quilt {
 public:
  Quilt(const cv::Mat& photo, cv::Size size, const QuiltingSettings& settings)
      : photo_(photo),
        block_px_(settings.block_px),
        overlap_px_(block_px_ / kSidesToOverlap),
        random_(settings.seed),
        canvas_(whole_blocks_px(size.height), whole_blocks_px(size.width), CV_8UC3) {}

  /// Lays all blocks, row by row.
  cv::Mat laid() {
    const int step_px = block_px_ - overlap_px_;
    for (int y = 0; y + overlap_px_ < canvas_.rows; y += step_px) {
      for (int x = 0; x + overlap_px_ < canvas_.cols; x += step_px) lay({x, y});
    }
    return canvas_;
  }

 private:
  /// The length of the blocks that together are at least so long.
  int whole_blocks_px(int length_px) const {
    const int step_px = block_px_ - overlap_px_;
    return std::max(1, (length_px - overlap_px_ + step_px - 1) / step_px) * step_px + overlap_px_;
  }

  /// The part of a block that lies on the block above, and the part that lies on the left one without the corner. They are
  /// empty at the canvas's edges.
  cv::Rect above(cv::Point corner) const { return {0, 0, block_px_, corner.y > 0 ? overlap_px_ : 0}; }
  cv::Rect beside(cv::Point corner) const {
    const int top = above(corner).height;
    return {0, top, corner.x > 0 ? overlap_px_ : 0, block_px_ - top};
  }

  /// The sum of squared differences in one overlap, for each place of the block in the photo. Added to `errors`, CV_32F.
  void add_errors(cv::Point corner, const cv::Rect& overlap, cv::Mat& errors) const {
    if (overlap.empty()) return;
    cv::Mat of_overlap;
    cv::matchTemplate(photo_, canvas_(overlap + corner), of_overlap, cv::TM_SQDIFF);
    errors += of_overlap(cv::Rect(overlap.tl(), errors.size()));
  }

  /// A random place among those whose error is almost the least.
  cv::Point chosen(const cv::Mat& errors) {
    double least = 0;
    cv::minMaxLoc(errors, &least);
    std::vector<cv::Point> places;
    cv::findNonZero(errors <= (1 + kTolerance) * least, places);
    return places[random_() % places.size()];
  }

  /// The pixels at which the new block shows: CV_8U, 0 or 255.
  cv::Mat shown(cv::Point corner, const cv::Mat& block) const {
    cv::Mat mask(block.size(), CV_8U, cv::Scalar(255));
    const cv::Mat errors = pixel_errors(block, canvas_({corner, block.size()}));
    if (corner.x > 0) {
      const std::vector<int> path = least_error_path(errors.colRange(0, overlap_px_));
      for (int y = 0; y < block_px_; ++y) mask.row(y).colRange(0, path[std::size_t(y)]).setTo(0);
    }
    if (corner.y > 0) {
      const std::vector<int> path = least_error_path(errors.rowRange(0, overlap_px_).t());
      for (int x = 0; x < block_px_; ++x) mask.col(x).rowRange(0, path[std::size_t(x)]).setTo(0);
    }
    return mask;
  }

  void lay(cv::Point corner) {
    cv::Mat errors = cv::Mat::zeros(photo_.rows - block_px_ + 1, photo_.cols - block_px_ + 1, CV_32F);
    add_errors(corner, above(corner), errors);
    add_errors(corner, beside(corner), errors);
    const cv::Size size(block_px_, block_px_);
    const cv::Mat block = photo_({chosen(errors), size});
    block.copyTo(canvas_({corner, size}), shown(corner, block));
  }

  const cv::Mat photo_;
  const int block_px_, overlap_px_;
  std::mt19937_64 random_;
  cv::Mat canvas_;
};

}  // namespace

std::vector<int> least_error_path(const cv::Mat& errors) {
  cv::Mat sums = errors.clone();  // of the best path from the first row to each pixel
  const auto best_near = [&](int y, int x) {
    const float* row = sums.ptr<float>(y);
    return int(std::min_element(row + std::max(0, x - 1), row + std::min(sums.cols, x + 2)) - row);
  };
  for (int y = 1; y < sums.rows; ++y) {
    for (int x = 0; x < sums.cols; ++x) sums.at<float>(y, x) += sums.at<float>(y - 1, best_near(y - 1, x));
  }
  std::vector<int> path(std::size_t(sums.rows));
  const float* last = sums.ptr<float>(sums.rows - 1);
  path.back() = int(std::min_element(last, last + sums.cols) - last);
  for (int y = sums.rows - 2; y >= 0; --y) path[std::size_t(y)] = best_near(y, path[std::size_t(y) + 1]);
  return path;
}

cv::Mat quilted(const cv::Mat& photo, cv::Size size, const QuiltingSettings& settings) {
  check(photo, settings.block_px);
  return Quilt(photo, size, settings).laid()(cv::Rect({}, size)).clone();
}

}  // namespace tessera::bench
