#include "core/field/nodes_near.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tessera {
namespace {

constexpr int kLargest = 16;  // nodes across the first blocks
constexpr int kSmallest = 4;  // nodes across the blocks whose nodes are tested one by one

class Search {
 public:
  Search(float limit_px, const PieceDistance& piece, Vec2 origin, const Window& window, const BitGrid* relevant_nodes)
      : limit_px_(limit_px),
        piece_(piece),
        origin_(origin),
        window_(window),
        relevant_nodes_(relevant_nodes),
        nearer_(window.width(), window.height()) {}

  BitGrid found() && {
    each_block({0, 0, window_.width(), window_.height()}, kLargest,
               [this](const Window& block) { search_block(block); });
    return std::move(nearer_);
  }

 private:
  template <class F>
  static void each_block(const Window& window, int across, F f) {
    for (int y = window.y0; y < window.y1; y += across) {
      for (int x = window.x0; x < window.x1; x += across) {
        f(Window{x, y, x + across, y + across}.intersected(window));
      }
    }
  }

  /// Tests the node in the middle. If it is so far from the limit that the corners must be on the same side, all nodes
  /// are.
  void search_block(const Window& block) {
    if (relevant_nodes_ && !relevant_nodes_->any(block)) return;
    const int x = (block.x0 + block.x1) / 2;
    const int y = (block.y0 + block.y1) / 2;
    const float beyond_px = distance(x, y) - limit_px_;
    const float corner_px = std::sqrt(float((x - block.x0) * (x - block.x0) + (y - block.y0) * (y - block.y0)));
    if (std::abs(beyond_px) > PieceDistance::most_change_px(corner_px)) {
      if (beyond_px < 0) nearer_.set(block);
    } else if (std::max(block.width(), block.height()) > kSmallest) {
      each_block(block, (std::max(block.width(), block.height()) + 1) / 2,
                 [&](const Window& part) { search_block(part); });
    } else {
      search_nodes(block);
    }
  }

  float distance(int x, int y) const {
    return piece_.at({origin_.x + float(window_.x0 + x), origin_.y + float(window_.y0 + y)});
  }

  void search_nodes(const Window& block) {
    for (int y = block.y0; y < block.y1; ++y) {
      for (int x = block.x0; x < block.x1; ++x) {
        if (relevant_nodes_ && !relevant_nodes_->test(x, y)) continue;
        if (distance(x, y) < limit_px_) nearer_.set_run(y, x, x + 1);
      }
    }
  }

  float limit_px_;
  const PieceDistance& piece_;
  Vec2 origin_;
  Window window_;
  const BitGrid* relevant_nodes_;  // empty: all nodes
  BitGrid nearer_;
};

}  // namespace

BitGrid nodes_nearer_than(float limit_px, const PieceDistance& piece, Vec2 origin, const Window& window) {
  return Search(limit_px, piece, origin, window, nullptr).found();
}

BitGrid nodes_nearer_than(float limit_px, const PieceDistance& piece, Vec2 origin, const Window& window,
                          const BitGrid& relevant_nodes) {
  return Search(limit_px, piece, origin, window, &relevant_nodes).found();
}

}  // namespace tessera
