#include "products/elements/segmentation/merge_tree.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <queue>
#include <tuple>
#include <vector>

#include "products/elements/segmentation/region_labels.h"

namespace tessera {
namespace {

/// Larger regions are no elements.
constexpr double kMost_px2 = 40 * kElement_px2;
constexpr double kLeastSolidity = 0.75;
constexpr double kLeastQuality = 0.15;
/// Small regions are merged first: the strength of their borders is multiplied by this power of their area.
constexpr double kSizePower = 0.2;

/// The common border of two neighbours.
struct Border {
  double sum = 0;  // of the boundary map
  double length_px = 0;
  double mean() const { return sum / length_px; }
};

struct Node {
  double area_px2 = 0;
  std::vector<cv::Point> hull;
  std::map<int, Border> neighbours;
  int first = -1, second = -1;  // the two nodes it was merged from
  double border_outside = 0;    // mean
  double border_inside = 0;     // the strongest border that merging removed
  bool is_merged = false;       // into another node
};

struct Merge {
  double cost;
  int a, b;
  // the cheapest on top
  bool operator<(const Merge& o) const { return std::tie(o.cost, o.a, o.b) < std::tie(cost, a, b); }
};

double mean_border(const Node& node) {
  Border all;
  for (const auto& [_, border] : node.neighbours) {
    all.sum += border.sum;
    all.length_px += border.length_px;
  }
  return all.length_px > 0 ? all.mean() : 0;
}

class MergeTree {
 public:
  MergeTree(const cv::Mat& boundary, const cv::Mat& leaves) {
    read_regions(leaves);
    read_borders(boundary, leaves);
    for (Node& node : nodes_) node.border_outside = mean_border(node);
    merge_all();
  }

  std::vector<Node> take() { return std::move(nodes_); }

 private:
  void read_regions(const cv::Mat& leaves) {
    double greatest = 0;
    cv::minMaxLoc(leaves, nullptr, &greatest);
    nodes_.resize(std::size_t(greatest));
    for (int y = 0; y < leaves.rows; ++y) {
      for (int x = 0; x < leaves.cols; ++x) {
        Node& node = nodes_[std::size_t(leaves.at<int>(y, x) - 1)];
        node.area_px2 += 1;
        const bool is_run_start = x == 0 || leaves.at<int>(y, x - 1) != leaves.at<int>(y, x);
        const bool is_run_end = x + 1 == leaves.cols || leaves.at<int>(y, x + 1) != leaves.at<int>(y, x);
        if (is_run_start) node.hull.insert(node.hull.end(), {{x, y}, {x, y + 1}});
        if (is_run_end) node.hull.insert(node.hull.end(), {{x + 1, y}, {x + 1, y + 1}});
      }
    }
    for (Node& node : nodes_) {
      std::vector<cv::Point> hull;
      cv::convexHull(node.hull, hull);
      node.hull = std::move(hull);
    }
  }

  void read_borders(const cv::Mat& boundary, const cv::Mat& leaves) {
    const auto meet = [&](cv::Point p, cv::Point q) {
      const int a = leaves.at<int>(p) - 1;
      const int b = leaves.at<int>(q) - 1;
      if (a == b) return;
      const double strength = std::max(boundary.at<float>(p), boundary.at<float>(q));
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
        Border& border = nodes_[std::size_t(from)].neighbours[to];
        border.sum += strength;
        border.length_px += 1;
      }
    };
    for (int y = 0; y < leaves.rows; ++y) {
      for (int x = 0; x < leaves.cols; ++x) {
        if (x + 1 < leaves.cols) meet({x, y}, {x + 1, y});
        if (y + 1 < leaves.rows) meet({x, y}, {x, y + 1});
      }
    }
  }

  void propose(int a, int b, const Border& border) {
    const double area_px2 = std::min(node(a).area_px2, node(b).area_px2);
    if (node(a).area_px2 + node(b).area_px2 > kMost_px2) return;
    merges_.push({border.mean() * std::pow(area_px2 / kElement_px2, kSizePower), a, b});
  }

  void merge_all() {
    for (int a = 0; a < int(nodes_.size()); ++a) {
      for (const auto& [b, border] : node(a).neighbours) {
        if (a < b) propose(a, b, border);
      }
    }
    while (!merges_.empty()) {
      const Merge merge = merges_.top();
      merges_.pop();
      if (!node(merge.a).is_merged && !node(merge.b).is_merged) this->merge(merge.a, merge.b);
    }
  }

  void merge(int a, int b) {
    const int merged_id = int(nodes_.size());
    Node merged;
    merged.first = a;
    merged.second = b;
    merged.area_px2 = node(a).area_px2 + node(b).area_px2;
    merged.border_inside = std::max({node(a).border_inside, node(b).border_inside, node(a).neighbours.at(b).mean()});
    std::vector<cv::Point> corners = node(a).hull;
    corners.insert(corners.end(), node(b).hull.begin(), node(b).hull.end());
    cv::convexHull(corners, merged.hull);
    for (const int part : {a, b}) {
      for (const auto& [other, border] : node(part).neighbours) {
        if (other == a || other == b) continue;
        Border& joined = merged.neighbours[other];
        joined.sum += border.sum;
        joined.length_px += border.length_px;
        node(other).neighbours.erase(part);
      }
      node(part).neighbours.clear();
      node(part).is_merged = true;
    }
    merged.border_outside = mean_border(merged);
    nodes_.push_back(std::move(merged));
    for (const auto& [other, border] : node(merged_id).neighbours) {
      node(other).neighbours[merged_id] = border;
      propose(other, merged_id, border);
    }
  }

  Node& node(int id) { return nodes_[std::size_t(id)]; }

  std::vector<Node> nodes_;
  std::priority_queue<Merge> merges_;
};

/// How much a region looks like an element, 0..1: solid, of the usual size, with a border stronger than all borders inside.
double quality_of(const Node& node, double solidity_power) {
  const double solidity = std::min(1., node.area_px2 / cv::contourArea(node.hull));
  if (solidity < kLeastSolidity) return 0;
  const double margin = node.first < 0 ? 1 : (node.border_outside - node.border_inside) / (node.border_outside + 1e-6);
  const double contrast = std::clamp(3 * margin, 0., 1.);
  return std::pow(solidity, solidity_power) * size_preference(node.area_px2 / kElement_px2, 1.4, 0.4) *
         (0.1 + 0.9 * contrast) * std::min(1., node.border_outside / 0.5);
}

}  // namespace

cv::Mat best_of_merge_tree(const cv::Mat& boundary, const cv::Mat& leaves, double solidity_power) {
  const std::vector<Node> nodes = MergeTree(boundary, leaves).take();
  // Parts come before the nodes merged from them. Each node gets the better of its own quality and the sum of its parts'
  // bests.
  std::vector<double> best(nodes.size(), 0), quality(nodes.size(), 0);
  std::vector<char> is_taken(nodes.size(), 0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    quality[i] = quality_of(nodes[i], solidity_power);
    const double own = nodes[i].area_px2 * quality[i];
    const double parts =
        nodes[i].first < 0 ? 0 : best[std::size_t(nodes[i].first)] + best[std::size_t(nodes[i].second)];
    is_taken[i] = own >= parts;
    best[i] = std::max(own, parts);
  }
  // From the roots down: a part belongs to the topmost node that is taken.
  std::vector<int> label(nodes.size(), -1);
  int next = 0;
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (label[i] < 0 && is_taken[i]) label[i] = quality[i] > kLeastQuality ? ++next : 0;
    if (label[i] < 0 || nodes[i].first < 0) continue;
    label[std::size_t(nodes[i].first)] = label[std::size_t(nodes[i].second)] = label[i];
  }
  cv::Mat labels(leaves.size(), CV_32S);
  for (int y = 0; y < leaves.rows; ++y) {
    for (int x = 0; x < leaves.cols; ++x) {
      labels.at<int>(y, x) = std::max(0, label[std::size_t(leaves.at<int>(y, x) - 1)]);
    }
  }
  return labels;
}

}  // namespace tessera
