#include "products/texture/texture_layout.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/rank_pool.h"
#include "products/texture/counted_part.h"
#include "products/texture/layout_canvas.h"
#include "products/texture/patch_cost.h"
#include "products/texture/photo_cells.h"

namespace tessera {
namespace {

/// Side of a patch, in elements of mean size, and the largest part of the photo that it may be.
constexpr double kPatch_elements = 3;
constexpr double kMostOfPhoto = 0.6;
/// The part of its side by which a patch overlaps its neighbours.
constexpr double kOverlap = 1. / 3;
/// The patch is drawn from those that fit nearly as well as the best.
constexpr double kTolerance = 1.1;
/// The number of times that the surroundings of all holes are laid anew.
constexpr int kSweeps = 30;

/// The number of best patches that are compared with the patches beside them, and how many cells beside.
constexpr std::size_t kRefined = 8;
constexpr int kBeside_cells = 2;

struct Search {
  std::size_t most_candidates;
  double use_cost;
};

constexpr Search kFirstSearch{1000, 1};
constexpr Search kMendingSearch{250, 0.1};

/// Lays a canvas patch by patch.
class LayoutQuilt {
 public:
  LayoutQuilt(const PhotoCells& photo, cv::Size size, std::uint64_t seed)
      : photo_(photo),
        canvas_(photo, size),
        most_side_(std::max(1, int(kMostOfPhoto * std::min(photo.cells.cols, photo.cells.rows)))),
        side_(std::clamp(int(kPatch_elements * photo.element_side), 1, most_side_)),
        random_(std::uint32_t(seed)) {}

  void lay_all() {
    for (const int y : starts(canvas_.size().height)) {
      for (const int x : starts(canvas_.size().width)) canvas_.lay(chosen({x, y}, side_, kFirstSearch));
    }
    canvas_.close();
  }

  /// Lays the surroundings of holes anew, and keeps what is better.
  void mend_holes() {
    const int least = std::max(1, side_ / 2), most = std::max(least, std::min(most_side_, side_ * 3 / 2));
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      for (const cv::Point hole : canvas_.wide_holes()) {
        const int side = least + int(random_() % unsigned(most - least + 1));
        const cv::Point corner = hole - cv::Point(side / 2, side / 2);
        canvas_.clear(corner, side);
        canvas_.lay(chosen(corner, side, kMendingSearch));
        if (canvas_.gain() < 0) canvas_.undo();
      }
    }
  }

  std::vector<LaidElement> laid(int step_px) const { return canvas_.laid(step_px); }

 private:
  /// Where patches begin on this side of the canvas.
  std::vector<int> starts(int length) const {
    const int count = std::max(1, int(std::lround(length / (side_ * (1 - kOverlap)))));
    std::vector<int> all;
    for (int i = 0; i < count; ++i) all.push_back(int((long long)(length)*i / count));
    return all;
  }

  std::vector<Patch> candidates(cv::Point corner, int side, std::size_t most) {
    const auto columns = std::size_t(photo_.cells.cols - side + 1), rows = std::size_t(photo_.cells.rows - side + 1);
    const std::size_t step = std::max<std::size_t>(1, columns * rows / most);
    std::vector<Patch> all;
    for (std::size_t i = random_() % step; i < columns * rows; i += step)
      all.push_back({{int(i % columns), int(i / columns)}, corner, side});
    return all;
  }

  Patch chosen(cv::Point corner, int side, const Search& search) {
    const CountedPart part(canvas_.part({corner, cv::Size(side, side)}));
    std::vector<Patch> all = candidates(corner, side, search.most_candidates);
    std::vector<double> costs = costs_of(all, part, search);
    const std::vector<Patch> beside = beside_best(all, costs);
    const std::vector<double> more = costs_of(beside, part, search);
    all.insert(all.end(), beside.begin(), beside.end());
    costs.insert(costs.end(), more.begin(), more.end());
    const double best = *std::min_element(costs.begin(), costs.end());
    std::vector<std::size_t> good;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (costs[i] <= best * kTolerance) good.push_back(i);
    }
    return all[good[random_() % good.size()]];
  }

  std::vector<double> costs_of(const std::vector<Patch>& patches, const CountedPart& part, const Search& search) const {
    std::vector<double> costs(patches.size());
    constexpr std::size_t kAtOnce = 100;
    parallel_for((patches.size() + kAtOnce - 1) / kAtOnce, [&](std::size_t chunk) {
      PatchCost cost(photo_, canvas_, search.use_cost);
      for (std::size_t i = chunk * kAtOnce; i < std::min(patches.size(), (chunk + 1) * kAtOnce); ++i)
        costs[i] = cost(patches[i], part);
    });
    return costs;
  }

  /// The patches some cells beside the best ones, as not all were compared.
  std::vector<Patch> beside_best(const std::vector<Patch>& patches, const std::vector<double>& costs) const {
    std::vector<std::size_t> order(patches.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    const std::size_t count = std::min(kRefined, order.size());
    std::partial_sort(order.begin(), order.begin() + std::ptrdiff_t(count), order.end(),
                      [&](std::size_t a, std::size_t b) { return std::tie(costs[a], a) < std::tie(costs[b], b); });
    const cv::Rect places(0, 0, photo_.cells.cols - patches.front().side + 1,
                          photo_.cells.rows - patches.front().side + 1);
    std::vector<Patch> beside;
    for (std::size_t i = 0; i < count; ++i) {
      for (int dy = -kBeside_cells; dy <= kBeside_cells; ++dy) {
        for (int dx = -kBeside_cells; dx <= kBeside_cells; ++dx) {
          Patch patch = patches[order[i]];
          patch.from += cv::Point(dx, dy);
          if ((dx != 0 || dy != 0) && places.contains(patch.from)) beside.push_back(patch);
        }
      }
    }
    return beside;
  }

  const PhotoCells& photo_;
  LayoutCanvas canvas_;
  const int most_side_;  // of a patch, cells
  const int side_;
  std::mt19937 random_;
};

}  // namespace

std::vector<LaidElement> texture_layout(const PhotoLayout& photo, cv::Size canvas_px, std::uint64_t seed) {
  if (photo.elements.empty()) return {};
  const PhotoCells cells = photo_cells(photo);
  const auto in_cells = [&](int px, double cell_px) { return std::max(1, int(std::lround(px / cell_px))); };
  const cv::Size size(in_cells(canvas_px.width, cells.cell_px.width), in_cells(canvas_px.height, cells.cell_px.height));
  LayoutQuilt quilt(cells, size, seed);
  quilt.lay_all();
  quilt.mend_holes();
  return quilt.laid(photo.step_px);
}

}  // namespace tessera
