#include "bench/inputs/varied_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/error.h"
#include "core/base/portable_math.h"
#include "core/base/rank_pool.h"
#include "core/base/stopwatch.h"

namespace tessera::bench {
namespace {

constexpr float kMostStretch = 1.5f;

constexpr LibraryParts kOutlines{.outline = true, .field = false, .levels = 0, .artwork = false, .original = false};

float fraction(double x) { return float(x - std::floor(x)); }

}  // namespace

void check_varied_sizes(const std::vector<std::uint32_t>& sizes) {
  for (const std::uint32_t size : sizes) {
    if (size >= 1 && size <= kMostVariedShapes) continue;
    throw InputError("--sizes: found " + std::to_string(size) + "; allowed: 1 to " + std::to_string(kMostVariedShapes));
  }
}

void change_pads(ShapeModel& model, std::uint32_t number) {
  if (number < VariedShapes::kDifferent) return;
  constexpr float kMostChange = 0.02f;
  std::uint64_t bits = number;
  for (ModelLevel& level : model.levels) {
    for (ModelSample& sample : level.samples) {
      for (std::uint16_t& element : sample.pad.element) {
        bits = mix_bits(bits);
        const float factor = 1 + kMostChange * (2 * unit_float(std::uint32_t(bits >> 32)) - 1);
        element = std::uint16_t(std::min(float(element) * factor, float(kPadSteps)));
      }
      sample.pad = library_pad(sample.pad);
    }
  }
}

ShapeVariation variation_number(std::uint32_t number) {
  const std::uint32_t stretch = number / 2;
  ShapeVariation variation;
  variation.mirrored = number % 2 == 1;
  if (stretch == 0) return variation;
  // Multiples of the plastic number's powers fill the plane evenly (R2 sequence), so all stretches differ.
  variation.angle_rad = std::numbers::pi_v<float> * fraction(stretch * 0.7548776662466927);
  variation.factor = std::pow(kMostStretch, 0.2f + 0.8f * fraction(stretch * 0.5698402909980532));
  return variation;
}

VariedShapes::VariedShapes(const LibraryFile& library)
    : outlines_(library.read(0, library.size(), kOutlines)),
      pad_(library.pad_parameters()),
      digest_(library.content_digest()) {}

Shape VariedShapes::make(ShapeId id) const {
  const std::uint32_t index = index_of(id) % kDifferent;
  const std::uint32_t originals = std::uint32_t(outlines_.size());
  return varied_shape(outlines_[index % originals], variation_number(index / originals), pad_);
}

Shape VariedShapes::load(ShapeId id) {
  const Stopwatch watch;
  Shape shape = make(id);
  making_s_ += watch.seconds();
  return shape;
}

std::vector<Shape> VariedShapes::shapes(const ShapeRange& range) const {
  std::vector<Shape> shapes(range.size());
  parallel_for(shapes.size(), [&](std::size_t i) { shapes[i] = make(range.at(std::uint32_t(i))); });
  return shapes;
}

std::vector<ShapeModel> VariedShapes::models(const ShapeRange& range, const MatchingContext& context) const {
  std::vector<ShapeModel> models(range.size());
  parallel_for(models.size(), [&](std::size_t i) {
    models[i] = make_shape_model(make(range.at(std::uint32_t(i))), pad_, context.pad, context.levels);
    change_pads(models[i], index_of(range.at(std::uint32_t(i))));
  });
  return models;
}

}  // namespace tessera::bench
