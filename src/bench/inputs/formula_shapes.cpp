#include "bench/inputs/formula_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/portable_math.h"
#include "core/base/rank_pool.h"
#include "core/shape/shape_builder.h"

namespace tessera::bench {
namespace {

constexpr int kControlPoints = 256;
constexpr int kFirstWave = 2;
constexpr int kLastWave = 9;

float random_number(std::uint32_t number, int wave, int draw) {
  return unit_float(std::uint32_t(mix_bits((std::uint64_t(number) << 16) | std::uint64_t(2 * wave + draw)) >> 32));
}

}  // namespace

TracedOutline blob_outline(std::uint32_t number) {
  Eigen::Matrix2Xd control(2, kControlPoints);
  for (int i = 0; i < kControlPoints; ++i) {
    const double angle = 2 * std::numbers::pi * i / kControlPoints;
    double radius = 1;
    for (int wave = kFirstWave; wave <= kLastWave; ++wave) {
      const double amplitude = (0.2 + 0.4 * random_number(number, wave, 0)) / wave;
      radius += amplitude * std::cos(wave * angle + 2 * std::numbers::pi * random_number(number, wave, 1));
    }
    control.col(i) << std::max(0.2, radius) * std::cos(angle), std::max(0.2, radius) * std::sin(angle);
  }
  TracedOutline outline;
  outline.curves.emplace_back(std::move(control));
  return outline;
}

std::vector<Shape> blob_shapes(std::size_t count) {
  std::vector<Shape> shapes(count);
  parallel_for(count, [&](std::size_t i) { shapes[i] = make_shape(blob_outline(std::uint32_t(i)), {}); });
  return shapes;
}

std::vector<ShapeModel> models_of(const std::vector<Shape>& shapes, const MatchingContext& context) {
  std::vector<ShapeModel> models;
  for (const Shape& shape : shapes) models.push_back(make_shape_model(shape, {}, context.pad, context.levels));
  return models;
}

}  // namespace tessera::bench
