#include "core/matching/colour_fit.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/base/portable_math.h"
#include "core/colour/ciede2000.h"
#include "core/tuning.h"

namespace tessera {
namespace {

using Lanes = std::array<float, kColourCells>;

/// In the order in which the kernels add the lanes of a vector.
float sum_of(Lanes v) {
  for (std::size_t half = kColourCells / 2; half > 0; half /= 2) {
    for (std::size_t i = 0; i < half; ++i) v[i] += v[i + half];
  }
  return v[0];
}

}  // namespace

float mean_colour_difference(const ColourModel& piece, const Similarity& canvas_from_shape,
                             const ColourTarget& target) {
  const int level = target.level_for(kColourFootprint * canvas_from_shape.scale());
  const Texel covered = target.at(level, canvas_from_shape.translation());
  if (covered.weight < kLeastColourWeight) return 0;
  return ciede2000(piece.mean, covered.colour());
}

float colour_difference(const ColourModel& piece, const Similarity& canvas_from_shape, const ColourTarget& target) {
  const int level = target.level_for(piece.cell * canvas_from_shape.scale());
  Lanes weight, lightness, a, b, difference;
  for (std::size_t i = 0; i < kColourCells; ++i) {
    const Texel covered = target.at(level, canvas_from_shape.apply(piece.at[i]));
    const bool wished = covered.weight >= kLeastColourWeight;
    const Lab colour = wished ? covered.colour() : Lab{};
    weight[i] = wished ? piece.part[i] * covered.weight : 0.f;
    lightness[i] = weight[i] * colour.lightness;
    a[i] = weight[i] * colour.a;
    b[i] = weight[i] * colour.b;
    difference[i] = weight[i] * ciede2000(piece.colour[i], colour);
  }
  const float all = sum_of(weight);
  if (all < kLeastColourWeight) return 0;
  const Lab mean = {sum_of(lightness) / all, sum_of(a) / all, sum_of(b) / all};
  const float of_cells = sum_of(difference) / all;
  return kColourOfMeans * ciede2000(piece.mean, mean) + (1 - kColourOfMeans) * of_cells;
}

float colour_worth(float difference, float weight) {
  return portable_exp2(-std::min(kMostFading, kColourFading * weight * difference));
}

}  // namespace tessera
