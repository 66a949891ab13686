#include "products/mosaic/haar_cascade.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core/operations.hpp>
#include <opencv2/imgproc.hpp>
#include <tuple>
#include <utility>

#include "core/base/error.h"

namespace tessera {
namespace {

/// Ratio of one window size to the next.
constexpr double kScaleStep = 1.1;
/// Sums of a stage are compared with a little less than its threshold, as in the training of cascades.
constexpr double kThresholdSlack = 1e-5;
/// Least standard deviation of the greys in a window that shows something.
constexpr double kLeastContrast = 10;
/// Windows that accept the same thing differ by at most this part of their side.
constexpr double kSamePlace = 0.2;
/// No picture has more faces, and joining those of one place takes time with the square of their number.
constexpr std::size_t kMostWindows = 10'000;
/// A larger window, px, comes from a damaged file.
constexpr int kMostWindow_px = 200;

void require(bool holds) {
  if (!holds) throw InputError("an index or a rectangle is out of range");
}

bool same_place(const cv::Rect& a, const cv::Rect& b) {
  const double most_px = kSamePlace / 2 * (std::min(a.width, b.width) + std::min(a.height, b.height));
  return std::abs(a.x - b.x) <= most_px && std::abs(a.y - b.y) <= most_px && std::abs(a.br().x - b.br().x) <= most_px &&
         std::abs(a.br().y - b.br().y) <= most_px;
}

cv::Rect mean_of(const cv::Rect& sum, int count) {
  const auto part = [count](int value) { return int(std::lround(double(value) / count)); };
  return {part(sum.x), part(sum.y), part(sum.width), part(sum.height)};
}

/// The mean window of each place with enough windows.
std::vector<HaarHit> places_of(const std::vector<cv::Rect>& windows, int fewest) {
  if (windows.empty()) return {};  // cv::partition reads the first element
  std::vector<int> place;
  std::vector<HaarHit> places(std::size_t(cv::partition(windows, place, same_place)));
  for (std::size_t i = 0; i < windows.size(); ++i) {
    HaarHit& hit = places[std::size_t(place[i])];
    hit.box_px = {hit.box_px.tl() + windows[i].tl(), hit.box_px.size() + windows[i].size()};
    ++hit.windows;
  }
  std::erase_if(places, [fewest](const HaarHit& hit) { return hit.windows < fewest; });
  for (HaarHit& hit : places) hit.box_px = mean_of(hit.box_px, hit.windows);
  const auto rank = [](const HaarHit& hit) {
    return std::tuple(-hit.windows, hit.box_px.y, hit.box_px.x, hit.box_px.width, hit.box_px.height);
  };
  std::ranges::sort(places, {}, rank);
  return places;
}

}  // namespace

/// The picture at one size, so that the window has the size of its training. All sums are of whole numbers.
class HaarCascade::Layer {
 public:
  Layer(const cv::Mat& grey, cv::Size window_px)
      : size_px_(grey.size()),
        inner_(1, 1, window_px.width - 2, window_px.height - 2) {
    cv::integral(grey, sums_, squares_, CV_32S, CV_64F);
  }

  cv::Size size_px() const { return size_px_; }
  double sum(cv::Rect box) const { return of(sums_.ptr<int>(), sums_.step1(), box); }
  /// The standard deviation of the greys in the window's inner part, times its area.
  double deviation(cv::Point at) const {
    const cv::Rect box = inner_ + at;
    const double sum_of = sum(box), squares = of(squares_.ptr<double>(), squares_.step1(), box);
    return std::sqrt(std::max(0., inner_.area() * squares - sum_of * sum_of));
  }
  double area() const { return inner_.area(); }

 private:
  template <class Number>
  static double of(const Number* table, std::size_t step, cv::Rect box) {
    const Number* top = table + std::size_t(box.y) * step;
    const Number* bottom = table + std::size_t(box.br().y) * step;
    return double(top[box.x] - top[box.br().x] - bottom[box.x] + bottom[box.br().x]);
  }

  cv::Size size_px_;
  cv::Rect inner_;
  cv::Mat sums_, squares_;
};

HaarCascade::HaarCascade(cv::Size window_px, std::vector<HaarFeature> features, std::vector<HaarStage> stages)
    : window_px_(window_px),
      features_(std::move(features)),
      stages_(std::move(stages)) {
  require(std::min(window_px_.width, window_px_.height) > 2 &&
          std::max(window_px_.width, window_px_.height) <= kMostWindow_px && !stages_.empty());
  for (const HaarFeature& feature : features_) {
    for (const HaarPart& part : feature) {
      const cv::Rect box = part.box_px;
      require(box.x >= 0 && box.width > 0 && box.width <= window_px_.width && box.x <= window_px_.width - box.width);
      require(box.y >= 0 && box.height > 0 && box.height <= window_px_.height &&
              box.y <= window_px_.height - box.height);
    }
  }
  for (const HaarStage& stage : stages_) {
    for (const HaarTree& tree : stage.trees) check_tree(tree);
  }
}

void HaarCascade::check_tree(const HaarTree& tree) const {
  const int nodes = int(tree.nodes.size()), leaves = int(tree.leaves.size());
  require(nodes > 0);
  const auto leads_on = [&](int to, int from) { return to > 0 ? to > from && to < nodes : to > -leaves; };
  for (int i = 0; i < nodes; ++i) {
    const HaarNode& node = tree.nodes[std::size_t(i)];
    require(leads_on(node.below, i) && leads_on(node.from, i));
    require(node.feature >= 0 && std::size_t(node.feature) < features_.size());
  }
}

bool HaarCascade::accepts(const Layer& layer, cv::Point at) const {
  const double deviation = layer.deviation(at);
  if (deviation <= kLeastContrast * layer.area()) return false;
  const auto value = [&](const HaarFeature& feature) {
    double sum = 0;
    for (const HaarPart& part : feature) sum += part.weight * layer.sum(part.box_px + at);
    return sum / deviation;
  };
  const auto leaf = [&](const HaarTree& tree) {
    int i = 0;
    do {
      const HaarNode& node = tree.nodes[std::size_t(i)];
      i = value(features_[std::size_t(node.feature)]) < node.threshold ? node.below : node.from;
    } while (i > 0);
    return tree.leaves[std::size_t(-i)];
  };
  return std::ranges::all_of(stages_, [&](const HaarStage& stage) {
    double sum = 0;
    for (const HaarTree& tree : stage.trees) sum += leaf(tree);
    return sum >= stage.threshold - kThresholdSlack;
  });
}

void HaarCascade::scan(const Layer& layer, double scale, std::vector<cv::Rect>& accepted) const {
  const cv::Size side(int(std::lround(window_px_.width * scale)), int(std::lround(window_px_.height * scale)));
  const int step = scale > 2 ? 1 : 2;  // px of the layer; about as fine as in OpenCV
  for (int y = 0; y + window_px_.height <= layer.size_px().height; y += step) {
    for (int x = 0; x + window_px_.width <= layer.size_px().width; x += step) {
      if (accepted.size() == kMostWindows) return;
      if (accepts(layer, {x, y}))
        accepted.emplace_back(cv::Point(int(std::lround(x * scale)), int(std::lround(y * scale))), side);
    }
  }
}

std::vector<HaarHit> HaarCascade::find(const cv::Mat& grey, int smallest_px, int largest_px, int fewest) const {
  std::vector<cv::Rect> accepted;
  for (double scale = 1; window_px_.width * scale <= largest_px; scale *= kScaleStep) {
    if (window_px_.width * scale < smallest_px) continue;
    const cv::Size size(int(std::lround(grey.cols / scale)), int(std::lround(grey.rows / scale)));
    if (size.width < window_px_.width || size.height < window_px_.height) break;
    cv::Mat picture;
    cv::resize(grey, picture, size, 0, 0, cv::INTER_LINEAR_EXACT);
    scan(Layer(picture, window_px_), scale, accepted);
  }
  return places_of(accepted, fewest);
}

}  // namespace tessera
