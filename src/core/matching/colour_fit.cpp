#include "core/matching/colour_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/base/lanes.h"
#include "core/colour/ciede2000.h"
#include "core/colour/fading.h"
#include "core/settings/tuning.h"

namespace tessera {
namespace {

static_assert(kColourCells == kLanes);

/// Colours of the picture beneath each cell of a piece.
struct CoveredCells {
  Lanes weight;  // the cell's part of the piece, times the target's weight there
  std::array<Lab, kColourCells> colour;

  std::optional<Lab> mean() const {
    const float all = sum_of_lanes(weight);
    if (all < kLeastColourWeight) return std::nullopt;
    Lanes lightness, a, b;
    for (std::size_t i = 0; i < kColourCells; ++i) {
      lightness[i] = weight[i] * colour[i].lightness;
      a[i] = weight[i] * colour[i].a;
      b[i] = weight[i] * colour[i].b;
    }
    return Lab{sum_of_lanes(lightness) / all, sum_of_lanes(a) / all, sum_of_lanes(b) / all};
  }
};

CoveredCells cells_of(const ColourModel& piece, const Similarity& canvas_from_shape, const ColourTarget& target) {
  const int level = target.level_for(piece.cell * canvas_from_shape.scale());
  CoveredCells cells;
  for (std::size_t i = 0; i < kColourCells; ++i) {
    const Texel covered = target.at(level, canvas_from_shape.apply(piece.at[i]));
    const bool wished = covered.weight >= kLeastColourWeight;
    cells.weight[i] = wished ? piece.part[i] * covered.weight : 0.f;
    cells.colour[i] = wished ? covered.colour() : Lab{};
  }
  return cells;
}

}  // namespace

float mean_colour_difference(const ColourModel& piece, const Similarity& canvas_from_shape,
                             const ColourTarget& target) {
  const int level = target.level_for(kColourFootprint * canvas_from_shape.scale());
  const Texel covered = target.at(level, canvas_from_shape.translation());
  if (covered.weight < kLeastColourWeight) return 0;
  return ciede2000(piece.mean, covered.colour());
}

std::optional<Lab> covered_colour(const ColourModel& piece, const Similarity& canvas_from_shape,
                                  const ColourTarget& target) {
  return cells_of(piece, canvas_from_shape, target).mean();
}

float colour_difference(const ColourModel& piece, const Similarity& canvas_from_shape, const ColourTarget& target) {
  const CoveredCells covered = cells_of(piece, canvas_from_shape, target);
  const float all = sum_of_lanes(covered.weight);
  if (all < kLeastColourWeight) return 0;
  Lanes square;
  for (std::size_t i = 0; i < kColourCells; ++i) {
    const float difference = ciede2000(piece.colour[i], covered.colour[i]);
    square[i] = covered.weight[i] * (difference * difference);
  }
  return std::sqrt(sum_of_lanes(square) / all);
}

float colour_worth(float difference, float weight) { return faded(kColourFading * weight * difference); }

}  // namespace tessera
