// Windows of replacement trials over a few synthetic shapes. Each window follows from its number.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "core/replacing/draws.h"
#include "core/replacing/replacement.h"
#include "core/shape/shape_source.h"
#include "support/synthetic_shapes.h"

namespace tessera::test {

/// A library of any size: every id gives one of a few shapes.
class EndlessShapes : public ShapeSource {
 public:
  const Shape& shape(ShapeId id) override {
    static const std::vector<Shape> few{
        make_test_shape("disc", disc_outline()), make_test_shape("bean", bean_outline()),
        make_test_shape("star", star_outline(5)), make_test_shape("blob", blob_outline(3))};
    ++read_;
    return few[index_of(id) % few.size()];
  }
  const ShapeModel& model(ShapeId) override { throw std::logic_error("nobody needs models here"); }

  /// The number of shapes that were read.
  std::size_t read() const { return read_; }

 private:
  std::size_t read_ = 0;
};

/// The edge distances of a canvas that is as large as the window's box.
inline EdgeField edge_of(const Box& box) {
  constexpr float kNode_px = 4;
  const int width = int(box.width() / kNode_px) + 1;
  const int height = int(box.height() / kNode_px) + 1;
  EdgeField edge{{Grid<float>(width, height), box.low * (1 / kNode_px)}, kNode_px};
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      const Vec2 at = box.low + Vec2{float(i), float(j)} * kNode_px;
      edge.distance.value(i, j) = std::min({at.x - box.low.x, box.high.x - at.x, at.y - box.low.y, box.high.y - at.y});
    }
  }
  return edge;
}

/// A window with pieces of 20 to 40 px, one in each of 5 x 5 cells. The first piece does not move.
/// The pieces and the shapes that may replace them are shapes `first` to `first` + 3.
inline ReplacementWindow any_window(std::uint64_t number, std::uint32_t first = 0) {
  constexpr int kCells = 5;
  constexpr float kCell_px = 34;
  constexpr PoseRange kPoses{20, 40, {}};
  Draws draws(number);
  const Vec2 low{float(draws.below(1000)), float(draws.below(1000))};
  ReplacementWindow window;
  window.box = {low, low + Vec2{kCells * kCell_px, kCells * kCell_px}};
  window.edge = edge_of(window.box);
  window.distances = {0.5f, -1.4f};
  window.least_scale_px = kPoses.min_scale_px;
  window.most_scale_px = kPoses.max_scale_px;
  window.repetition = {0.1, 2000, 0.2, 2};
  const auto any_shape = [&] { return ShapeId{first + std::uint32_t(draws.below(4))}; };
  for (int cell = 0; cell < kCells * kCells; ++cell) {
    const ShapeId shape = any_shape();
    const float scale_px = 20 + 12 * draws.unit();
    const float turn_rad = kTwoPi * draws.unit();
    const Vec2 centre = low + Vec2{float(cell % kCells) + 0.5f, float(cell / kCells) + 0.5f} * kCell_px;
    const Similarity pose{scale_px * std::cos(turn_rad), scale_px * std::sin(turn_rad), centre.x, centre.y};
    (cell == 0 ? window.still : window.moving).push_back({shape, shape, pose, kPoses});
  }
  for (std::uint32_t k = 0; k < 4; ++k) {
    const ShapeId shape{first + k};
    window.incoming.push_back({shape, shape, kPoses, 1 - 0.2f * float(k)});
    window.drawn.push_back({shape, double(20'000 + 1000 * draws.below(8))});
  }
  window.elsewhere = {{any_shape(), low - Vec2{30, 30}, 40}};
  window.random = number;
  window.trials = std::uint32_t(4 + draws.below(9));
  window.first_temperature_px2 = 20;
  window.last_temperature_px2 = 1;
  return window;
}

inline std::vector<ReplacementWindow> any_windows(std::size_t count, std::uint64_t number) {
  std::vector<ReplacementWindow> windows;
  for (std::size_t i = 0; i < count; ++i) windows.push_back(any_window(mix_bits(number + i)));
  return windows;
}

/// More trials than a test can wait for.
inline std::vector<ReplacementWindow> endless_windows(std::size_t count) {
  std::vector<ReplacementWindow> windows = any_windows(count, 3);
  for (ReplacementWindow& window : windows) window.trials = 1'000'000'000;
  return windows;
}

}  // namespace tessera::test
