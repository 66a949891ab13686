#include "core/field/opened_field.h"

#include <algorithm>
#include <cmath>

#include "core/base/rank_pool.h"
#include "core/geometry/bit_grid.h"
#include "core/settings/tuning.h"

namespace tessera {
namespace {

/// The contour value of a rejected node: a little below zero, so that the traced line stays close to the last good
/// node.
constexpr float kClosed = -0.3f;
/// Discs are centred on nodes whose distance exceeds the radius by 0 up to this.
constexpr float kDiscBand_px = 1.5f;
/// Rows of a task. A task also reads the rows around its own.
constexpr int kStripRows = 64;

/// Distances of the nodes within `reach`, in both directions, to the node in the middle.
Grid<float> distances_to_middle(int reach) {
  Grid<float> distances(2 * reach + 1, 2 * reach + 1);
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) distances(x + reach, y + reach) = std::sqrt(float(x * x + y * y));
  }
  return distances;
}

}  // namespace

OpenedField::OpenedField(const FreeField& free, const PieceSettings& pieces)
    : grid_(free.grid()),
      opening_px_(opening_radius_px(pieces)),
      reachable_px_(reachable_radius_px(pieces)),
      contour_(free.field().value.width(), free.field().value.height(), kClosed),
      reachable_(contour_.width(), contour_.height(), 0),
      to_middle_(distances_to_middle(int(opening_px_ + kDiscBand_px) + 2)) {
  update(free, {contour_.bounds()});
}

std::vector<Window> OpenedField::update(const FreeField& free, const std::vector<Window>& changed) {
  const int reach = int(2 * std::max(opening_px_, reachable_px_)) + 5;
  std::vector<Window> windows;
  for (const Window& nodes : changed) {
    const Window window = grid_.clipped(nodes.grown(reach));
    for (const Window& part : grid_.images(window, grid_.one_period())) update_part(free.field().value, part);
    grid_.spread(contour_, window, grid_.with_next_nodes());
    windows.push_back(window);
  }
  return windows;
}

/// Each task has some rows, as windows may overlap.
void OpenedField::update_part(const Grid<float>& distance, const Window& part) {
  const auto strips = std::size_t((part.height() + kStripRows - 1) / kStripRows);
  parallel_for(strips, [&](std::size_t i) {
    const int y0 = part.y0 + int(i) * kStripRows;
    const Window strip{part.x0, y0, part.x1, std::min(part.y1, y0 + kStripRows)};
    open(distance, strip);
    mark_reachable(distance, strip);
  });
}

void OpenedField::open(const Grid<float>& distance, const Window& window) {
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      const float d = distance(x, y);
      contour_(x, y) = d > opening_px_ + kDiscBand_px ? d : std::min(d, kClosed);
    }
  }
  // The union of the discs around all nodes at least opening_px deep equals the core and the discs around the
  // shallowest of them.
  const Window centres = window.grown(to_middle_.width() / 2).intersected(distance.bounds());
  for (int y = centres.y0; y < centres.y1; ++y) {
    for (int x = centres.x0; x < centres.x1; ++x) {
      const float d = distance(x, y);
      if (d < opening_px_ || d > opening_px_ + kDiscBand_px) continue;
      const int r = int(d) + 2;
      const Window disc = Window{x - r, y - r, x + r + 1, y + r + 1}.intersected(window);
      for (int b = disc.y0; b < disc.y1; ++b) {
        const float* to_middle = to_middle_.row(b - y + to_middle_.height() / 2);
        const int middle = to_middle_.width() / 2;
        float* row = contour_.row(b);
        for (int a = disc.x0; a < disc.x1; ++a) row[a] = std::max(row[a], d - to_middle[a - x + middle]);
      }
    }
  }
}

void OpenedField::mark_reachable(const Grid<float>& distance, const Window& window) {
  const int reach = int(reachable_px_) + 3;
  const Window around = window.grown(reach).intersected(distance.bounds());
  const float limit = (reachable_px_ + 1) * (reachable_px_ + 1);
  const BitGrid near = dilated_by_disc(nodes_above(distance, around, reachable_px_), limit);
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      reachable_(x, y) = near.test(x - around.x0, y - around.y0) && distance(x, y) > -1;
    }
  }
}

}  // namespace tessera
