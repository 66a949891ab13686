#include "products/elements/ground_synthesis.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

namespace tessera {
namespace {

/// Sides of patches. Large patches keep more of the ground's look; narrow joints hold only small ones.
constexpr std::array kPatchSides_px = {64, 48, 32, 24, 16, 12, 8, kLeastPatch_px};
/// The number of places without overlap at which a ground shows no visible repetition.
constexpr int kEnoughPlaces = 48;
/// The part of its side by which a patch overlaps its neighbours.
constexpr double kOverlap = 1. / 3;
/// The most patches that are compared for each place.
constexpr std::size_t kMostCandidates = 2000;
/// The patch is drawn from those that fit nearly as well as the best: within this factor, plus so many steps of each
/// channel.
constexpr double kTolerance = 1.1;
constexpr int kNoise = 1;
/// Light is estimated over a window of so many sides of a patch.
constexpr double kLight_patches = 1.5;
/// Cells for each side of that window.
constexpr double kCellsOfWindow = 8;

/// The places where a patch of this side lies wholly in the ground: CV_8U, at its upper left corner.
cv::Mat patch_places(const cv::Mat& ground, int side_px) {
  cv::Mat places;
  cv::erode(ground, places, cv::Mat::ones(side_px, side_px, CV_8U), {0, 0}, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  return places;
}

/// The number of these places without overlap, taken from top to bottom.
int places_apart(cv::Mat places, int side_px) {
  int count = 0;
  for (int y = 0; y < places.rows; ++y) {
    for (int x = 0; x < places.cols; ++x) {
      if (!places.at<std::uint8_t>(y, x)) continue;
      const int left = std::max(0, x - side_px + 1), right = std::min(places.cols, x + side_px);
      places(cv::Rect(left, y, right - left, std::min(side_px, places.rows - y))).setTo(0);
      ++count;
    }
  }
  return count;
}

/// The mean colour of the ground over a window around each cell of `cell_px` pixels: CV_32FC3.
cv::Mat light_of(const cv::Mat& photo, const cv::Mat& ground, int cell_px, double window_px) {
  const cv::Size cells((photo.cols + cell_px - 1) / cell_px, (photo.rows + cell_px - 1) / cell_px);
  cv::Mat sum = cv::Mat::zeros(cells, CV_32FC3), weight = cv::Mat::zeros(cells, CV_32F);
  const int channels = photo.channels();
  for (int y = 0; y < photo.rows; ++y) {
    const std::uint8_t *pixel = photo.ptr<std::uint8_t>(y), *is_ground = ground.ptr<std::uint8_t>(y);
    for (int x = 0; x < photo.cols; ++x, pixel += channels) {
      if (!is_ground[x]) continue;
      const cv::Point cell(x / cell_px, y / cell_px);
      sum.at<cv::Vec3f>(cell) += cv::Vec3f(pixel[0], pixel[1], pixel[2]);
      weight.at<float>(cell) += 1;
    }
  }
  cv::GaussianBlur(sum, sum, {}, window_px / cell_px);
  cv::GaussianBlur(weight, weight, {}, window_px / cell_px);
  cv::Mat weights, light;
  cv::cvtColor(cv::max(weight, 1e-6), weights, cv::COLOR_GRAY2BGR);
  cv::divide(sum, weights, light);
  return light;
}

/// The two cells beside a pixel, and the share of the second one.
struct BetweenCells {
  int first = 0, second = 0;
  float share = 0;
};

BetweenCells cells_beside(int pixel, int cell_px, int cells) {
  const float at = std::clamp((float(pixel) + 0.5F) / float(cell_px) - 0.5F, 0.F, float(cells - 1));
  const int first = int(at);
  return {first, std::min(first + 1, cells - 1), at - float(first)};
}

/// The photo with the same light everywhere, CV_8UC3: the mean over a large window is replaced by the ground's mean. The
/// light changes slowly and is kept for cells of many pixels, so that a large photo takes little memory.
cv::Mat evened_out(const cv::Mat& photo, const cv::Mat& ground, double window_px) {
  const int cell_px = std::max(1, int(window_px / kCellsOfWindow));
  const cv::Mat light = light_of(photo, ground, cell_px, window_px);
  const cv::Scalar mean = cv::mean(photo, ground);
  const cv::Vec3f mean_bgr{float(mean[0]), float(mean[1]), float(mean[2])};
  std::vector<BetweenCells> columns;
  for (int x = 0; x < photo.cols; ++x) columns.push_back(cells_beside(x, cell_px, light.cols));
  cv::Mat even(photo.size(), CV_8UC3);
  for (int y = 0; y < photo.rows; ++y) {
    const BetweenCells row = cells_beside(y, cell_px, light.rows);
    const cv::Vec3f *above = light.ptr<cv::Vec3f>(row.first), *below = light.ptr<cv::Vec3f>(row.second);
    const std::uint8_t* pixel = photo.ptr<std::uint8_t>(y);
    for (int x = 0; x < photo.cols; ++x, pixel += photo.channels()) {
      const BetweenCells& at = columns[std::size_t(x)];
      const cv::Vec3f upper = above[at.first] + (above[at.second] - above[at.first]) * at.share;
      const cv::Vec3f lower = below[at.first] + (below[at.second] - below[at.first]) * at.share;
      const cv::Vec3f here = upper + (lower - upper) * row.share;
      even.at<cv::Vec3b>(y, x) = cv::Vec3b(cv::Vec3f(pixel[0], pixel[1], pixel[2]) - here + mean_bgr);
    }
  }
  return even;
}

/// The torus that is filled patch by patch, from left to right and from top to bottom.
class Quilt {
 public:
  Quilt(const cv::Mat& source, const cv::Mat& places, int patch_px, int side_px)
      : source_(source),
        patch_px_(patch_px),
        side_px_(side_px),
        quilt_(side_px, side_px, CV_8UC3),
        filled_(side_px, side_px, CV_8U, cv::Scalar(0)),
        uses_(source.rows / patch_px + 1, source.cols / patch_px + 1, CV_32S, cv::Scalar(0)) {
    const std::size_t step = (std::size_t(cv::countNonZero(places)) + kMostCandidates - 1) / kMostCandidates;
    std::size_t place = 0;
    for (int y = 0; y < places.rows; ++y) {
      for (int x = 0; x < places.cols; ++x) {
        if (places.at<std::uint8_t>(y, x) && place++ % step == 0) candidates_.emplace_back(x, y);
      }
    }
    const int advance_px = std::max(1, int(patch_px * (1 - kOverlap)));
    const int count = (side_px + advance_px - 1) / advance_px;
    for (int i = 0; i <= count; ++i) starts_.push_back(int((long long)(side_px)*i / count));
  }

  cv::Mat filled() {
    for (std::size_t row = 0; row + 1 < starts_.size(); ++row) {
      for (std::size_t column = 0; column + 1 < starts_.size(); ++column) lay_patch(row, column);
    }
    return quilt_;
  }

 private:
  /// Pixels in a row of the patch that are there already, one beside the other.
  struct SharedRun {
    std::ptrdiff_t source_offset;      // from the patch's first pixel, bytes
    std::vector<std::uint8_t> values;  // three for each pixel
  };

  int wrapped(int at) const { return at % side_px_; }

  std::vector<SharedRun> shared_with(cv::Point corner) const {
    std::vector<SharedRun> runs;
    for (int y = 0; y < patch_px_; ++y) {
      bool goes_on = false;
      for (int x = 0; x < patch_px_; ++x) {
        const cv::Point at(wrapped(corner.x + x), wrapped(corner.y + y));
        const bool is_there = filled_.at<std::uint8_t>(at) != 0;
        if (is_there && !goes_on) runs.push_back({std::ptrdiff_t(source_.step) * y + 3 * x, {}});
        const cv::Vec3b& bgr = quilt_.at<cv::Vec3b>(at);
        if (is_there) runs.back().values.insert(runs.back().values.end(), bgr.val, bgr.val + 3);
        goes_on = is_there;
      }
    }
    return runs;
  }

  /// The squared difference; it stops where it exceeds `most`.
  double difference(const std::vector<SharedRun>& shared, cv::Point candidate, double most) const {
    const std::uint8_t* first = source_.ptr(candidate.y) + 3 * candidate.x;
    double sum = 0;
    for (const SharedRun& run : shared) {
      const std::uint8_t* source = first + run.source_offset;
      const std::uint8_t* there = run.values.data();
      const int length = int(run.values.size());
      int of_run = 0;  // a row of a patch has at most 192 values
      for (int i = 0; i < length; ++i) of_run += (source[i] - there[i]) * (source[i] - there[i]);
      sum += of_run;
      if (sum > most) break;
    }
    return sum;
  }

  /// The number of patches that were taken near this place.
  int& uses_near(cv::Point candidate) { return uses_.at<int>(candidate / patch_px_); }

  /// Chooses a patch that fits well. A patch costs more the more patches were taken near its place before. Otherwise smooth
  /// patches, which fit everywhere, would spread.
  cv::Point chosen_for(cv::Point corner) {
    const std::vector<SharedRun> shared = shared_with(corner);
    double noise = 1;
    for (const SharedRun& run : shared) noise += double(run.values.size()) * kNoise * kNoise;
    double best = 1e18;
    std::vector<double> costs;
    for (const cv::Point& candidate : candidates_) {
      const double dear = 1 + uses_near(candidate);
      costs.push_back((noise + difference(shared, candidate, best * kTolerance / dear)) * dear);
      best = std::min(best, costs.back());
    }
    std::vector<cv::Point> good;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      if (costs[i] <= best * kTolerance) good.push_back(candidates_[i]);
    }
    const cv::Point chosen = good[random_() % good.size()];
    ++uses_near(chosen);
    return chosen;
  }

  /// The path from top to bottom of a strip of differences along which they are least: a column for each row.
  static std::vector<int> cheapest_path(const cv::Mat& differences) {
    cv::Mat sums = differences.clone();
    for (int y = 1; y < sums.rows; ++y) {
      for (int x = 0; x < sums.cols; ++x) {
        const int* above = sums.ptr<int>(y - 1);
        const int first = std::max(0, x - 1), last = std::min(sums.cols - 1, x + 1);
        sums.at<int>(y, x) += *std::min_element(above + first, above + last + 1);
      }
    }
    std::vector<int> path(std::size_t(sums.rows));
    int first = 0, last = sums.cols - 1;
    for (int y = sums.rows - 1; y >= 0; --y) {
      const int* row = sums.ptr<int>(y);
      const int x = int(std::min_element(row + first, row + last + 1) - row);
      path[std::size_t(y)] = x;
      first = std::max(0, x - 1);
      last = std::min(sums.cols - 1, x + 1);
    }
    return path;
  }

  /// Clears `kept` (CV_8U) on the left of the path through the left strip of `differences`, `width` px wide.
  static void cut_left(const cv::Mat& differences, int width, cv::Mat kept) {
    const std::vector<int> path = cheapest_path(differences.colRange(0, width));
    for (int y = 0; y < kept.rows; ++y) kept.row(y).colRange(0, path[std::size_t(y)]).setTo(0);
  }

  /// Cuts from another side: turns the pictures, cuts, and turns them back.
  template <class Turn>
  static void cut_from(const Turn& turn, const cv::Mat& differences, int width, cv::Mat kept) {
    cv::Mat turned, turned_kept;
    turn(differences, turned);
    turn(kept, turned_kept);
    cut_left(turned, width, turned_kept);
    turn(turned_kept, kept);
  }

  /// The part of the patch that is laid over what is there: beyond the seams along which the two differ least.
  cv::Mat kept_part(std::size_t row, std::size_t column, const cv::Mat& differences) const {
    cv::Mat kept(patch_px_, patch_px_, CV_8U, cv::Scalar(255));
    const std::size_t last = starts_.size() - 2;
    const auto overlap = [&](std::size_t i) { return patch_px_ - (starts_[i + 1] - starts_[i]); };
    const auto mirror = [](const cv::Mat& from, cv::Mat& to) { cv::flip(from, to, 1); };
    const auto transpose = [](const cv::Mat& from, cv::Mat& to) { cv::transpose(from, to); };
    const auto turn_over = [](const cv::Mat& from, cv::Mat& to) {  // is its own inverse
      cv::transpose(from, to);
      cv::flip(to, to, -1);
    };
    if (column > 0) cut_left(differences, overlap(column - 1), kept);
    if (column == last && last > 0) cut_from(mirror, differences, overlap(column), kept);
    if (row > 0) cut_from(transpose, differences, overlap(row - 1), kept);
    if (row == last && last > 0) cut_from(turn_over, differences, overlap(row), kept);
    return kept;
  }

  void lay_patch(std::size_t row, std::size_t column) {
    const cv::Point corner(starts_[column], starts_[row]);
    const cv::Mat patch = source_(cv::Rect(chosen_for(corner), cv::Size(patch_px_, patch_px_)));
    cv::Mat differences(patch_px_, patch_px_, CV_32S, cv::Scalar(0));
    const auto place = [&](int x, int y) { return cv::Point(wrapped(corner.x + x), wrapped(corner.y + y)); };
    for (int y = 0; y < patch_px_; ++y) {
      for (int x = 0; x < patch_px_; ++x) {
        const cv::Vec3i d = cv::Vec3i(patch.at<cv::Vec3b>(y, x)) - cv::Vec3i(quilt_.at<cv::Vec3b>(place(x, y)));
        if (filled_.at<std::uint8_t>(place(x, y))) differences.at<int>(y, x) = d.dot(d);
      }
    }
    const cv::Mat kept = kept_part(row, column, differences);
    for (int y = 0; y < patch_px_; ++y) {
      for (int x = 0; x < patch_px_; ++x) {
        std::uint8_t& filled = filled_.at<std::uint8_t>(place(x, y));
        if (filled && !kept.at<std::uint8_t>(y, x)) continue;
        quilt_.at<cv::Vec3b>(place(x, y)) = patch.at<cv::Vec3b>(y, x);
        filled = 1;
      }
    }
  }

  const cv::Mat source_;
  const int patch_px_;
  const int side_px_;
  cv::Mat quilt_;
  cv::Mat filled_;
  cv::Mat uses_;                       // for each square of patch_px_ in the source
  std::vector<cv::Point> candidates_;  // upper left corners in the source
  std::vector<int> starts_;            // of the patches in both directions, and the end
  std::mt19937 random_;
};

}  // namespace

int patch_side_px(const cv::Mat& ground) {
  int enough_for_some = 0;
  for (const int side_px : kPatchSides_px) {
    const int count = places_apart(patch_places(ground, side_px), side_px);
    if (count >= kEnoughPlaces) return side_px;
    if (count >= kLeastPlaces && enough_for_some == 0) enough_for_some = side_px;
  }
  return enough_for_some;
}

cv::Mat synthesised_ground(const cv::Mat& photo, const cv::Mat& ground, int side_px) {
  const int patch_px = patch_side_px(ground);
  if (patch_px == 0) return {};
  const cv::Mat source = evened_out(photo, ground, kLight_patches * patch_px);
  return Quilt(source, patch_places(ground, patch_px), patch_px, side_px).filled();
}

}  // namespace tessera
