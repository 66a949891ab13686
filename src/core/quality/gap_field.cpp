#include "core/quality/gap_field.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/distance_transform.h"
#include "core/geometry/periodic_grid.h"
#include "core/geometry/tile_index.h"

namespace tessera {
namespace {

constexpr std::size_t kMaxGapNodes = std::size_t(1) << 23;  // two float grids of 32 MiB
constexpr int kMaxGapSides = 32768;  // largest sum of width and height for the distance transform

/// The cells in which gaps are searched.
Window gap_cells(const CellCounts& counts, const Period& period) {
  const int beyond_x = period.x_px * counts.per_px / 2;
  const int beyond_y = period.y_px * counts.per_px / 2;
  return {-beyond_x, -beyond_y, counts.cells.width() + beyond_x, counts.cells.height() + beyond_y};
}

/// Gaps are searched on every `step`-th cell in both directions. That is fine enough for a distance, and there are 4 to
/// 16 times fewer cells to transform.
int gap_step(const Window& cells, int per_px) {
  int step = std::max(1, per_px / 2);
  while (cells.width() / step * std::size_t(cells.height() / step) > kMaxGapNodes ||
         (cells.width() + cells.height()) / step + 2 > kMaxGapSides) {
    ++step;
  }
  return step;
}

/// The radius at a node. The edge runs, on average, midway between the last free node and the first taken one.
double radius_px(const GapField& field, float squared) { return (std::sqrt(double(squared)) - 0.5) * field.node_px; }

bool is_local_maximum(const Grid<float>& squared, int x, int y) {
  for (int j = y - 1; j <= y + 1; ++j) {
    for (int i = x - 1; i <= x + 1; ++i) {
      if (squared(i, j) > squared(x, y)) return false;
    }
  }
  return true;
}

/// The largest discs of their surroundings, the largest first.
std::vector<GapDisc> peaks(const GapField& field, float least_radius_px) {
  const Grid<float>& squared = field.squared;
  std::vector<GapDisc> discs;
  for (int y = 1; y + 1 < squared.height(); ++y) {
    for (int x = 1; x + 1 < squared.width(); ++x) {
      const float radius = float(radius_px(field, squared(x, y)));
      if (squared(x, y) == 0 || radius < least_radius_px || !is_local_maximum(squared, x, y)) continue;
      const Vec2 centre = field.first_px + Vec2{float(x), float(y)} * field.node_px;
      if (field.period.wrapped(centre) == centre) discs.push_back({centre, radius});
    }
  }
  std::stable_sort(discs.begin(), discs.end(),
                   [](const GapDisc& a, const GapDisc& b) { return a.radius_px > b.radius_px; });
  return discs;
}

/// The discs that were taken so far, by the tiles of px that they lie in.
class TakenDiscs {
 public:
  explicit TakenDiscs(const Period& period) : period_(period) {}

  bool overlap(const GapDisc& disc) const {
    bool found = false;
    tiles_.each(window_of(disc, disc.centre_px), [&](std::uint32_t i) {
      const GapDisc& other = discs_[i];
      const Vec2 apart = period_.nearest(other.centre_px, disc.centre_px) - disc.centre_px;
      const float clear_px = other.radius_px + disc.radius_px;
      found |= dot(apart, apart) < clear_px * clear_px;
    });
    return found;
  }

  void add(const GapDisc& disc) {
    for (const Vec2 offset : period_.offsets()) {
      TileIndex::Region region;
      region.add(window_of(disc, disc.centre_px + offset));
      for (const TileIndex::Tile tile : std::move(region).tiles()) tiles_.insert(tile, std::uint32_t(discs_.size()));
    }
    discs_.push_back(disc);
  }

  const std::vector<GapDisc>& discs() const { return discs_; }

 private:
  static Window window_of(const GapDisc& disc, Vec2 centre_px) {
    const auto low = [&](float at) { return int(std::floor(at - disc.radius_px)); };
    const auto high = [&](float at) { return int(std::floor(at + disc.radius_px)) + 1; };
    return {low(centre_px.x), low(centre_px.y), high(centre_px.x), high(centre_px.y)};
  }

  const Period& period_;
  TileIndex tiles_;
  std::vector<GapDisc> discs_;
};

}  // namespace

GapField gap_field(const CellCounts& counts, const Period& period) {
  const Window cells = gap_cells(counts, period);
  const int step = gap_step(cells, counts.per_px);
  const PeriodicGrid images(counts.region.bounds(), counts.region.bounds(),
                            {period.x_px * counts.per_px, period.y_px * counts.per_px});
  // A rim of nodes that are never free: the rim of one cell may lie between the nodes.
  Grid<std::uint8_t> taken(cells.width() / step + 2, cells.height() / step + 2, 1);
  for (int y = 1; y + 1 < taken.height(); ++y) {
    const int row = images.row(cells.y0 + (y - 1) * step);
    for (int x = 1; x + 1 < taken.width(); ++x) {
      const int column = images.column(cells.x0 + (x - 1) * step);
      taken(x, y) = !counts.region(column, row) || counts.covered(column, row);
    }
  }
  const float cell_px = 1.f / float(counts.per_px);
  const auto first_px = [&](int cell) { return (float(cell - step) + 0.5f) * cell_px; };
  return {.squared = squared_distance_to(taken),
          .node_px = float(step) * cell_px,
          .first_px = {first_px(cells.x0 + counts.cells.x0), first_px(cells.y0 + counts.cells.y0)},
          .period = period};
}

double largest_gap_px(const GapField& field) {
  const float most = *std::max_element(field.squared.data().begin(), field.squared.data().end());
  return most > 0 ? radius_px(field, most) : 0;
}

std::vector<GapDisc> gap_discs(const GapField& field, float least_radius_px, std::size_t most) {
  TakenDiscs taken(field.period);
  for (const GapDisc& disc : peaks(field, least_radius_px)) {
    if (taken.discs().size() == most) break;
    if (!taken.overlap(disc)) taken.add(disc);
  }
  return taken.discs();
}

}  // namespace tessera
