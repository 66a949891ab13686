#include "core/colour/harmony.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "core/base/error.h"

namespace tessera {
namespace {

struct Sector {
  double centre_deg;  // of the template at angle 0
  double width_deg;
};

struct Form {
  const char* letter;
  std::array<Sector, 2> sectors;
  std::size_t count;
};

/// The templates in the order of HarmonicTemplate.
constexpr std::array<Form, kHarmonicTemplates.size()> kForms = {{
    {"i", {{{0, 18}, {}}}, 1},
    {"I", {{{0, 18}, {180, 18}}}, 2},
    {"V", {{{0, 93.6}, {}}}, 1},
    {"L", {{{0, 18}, {90, 79.2}}}, 2},
    {"Y", {{{0, 93.6}, {180, 18}}}, 2},
    {"T", {{{0, 180}, {}}}, 1},
    {"X", {{{0, 93.6}, {180, 93.6}}}, 2},
}};

const Form& form_of(HarmonicTemplate form) { return kForms[std::size_t(form)]; }

std::span<const Sector> sectors_of(HarmonicTemplate form) {
  return std::span(form_of(form).sectors).first(form_of(form).count);
}

/// The turn from one hue to the other, -180 to 180, counterclockwise.
double way_deg(double from_deg, double to_deg) { return std::remainder(to_deg - from_deg, 360); }

/// The distance from the sector's nearer border; negative inside.
double beyond_border(double hue_deg, const Sector& sector) {
  return std::abs(way_deg(sector.centre_deg, hue_deg)) - sector.width_deg / 2;
}

/// The sector of a template at angle 0 that is nearest to the hue.
const Sector& nearest_sector(double hue_deg, HarmonicTemplate form) {
  const std::span<const Sector> sectors = sectors_of(form);
  const Sector* nearest = &sectors.front();
  for (const Sector& sector : sectors) {
    if (beyond_border(hue_deg, sector) < beyond_border(hue_deg, *nearest)) nearest = &sector;
  }
  return *nearest;
}

using DistanceTable = std::array<double, kHues>;

/// The distance, degrees, of each hue from the nearest sector of a template at angle 0.
DistanceTable distances_of(HarmonicTemplate form) {
  DistanceTable distances;
  for (int hue = 0; hue < kHues; ++hue) {
    distances[std::size_t(hue)] = std::max(0., beyond_border(hue, nearest_sector(hue, form)));
  }
  return distances;
}

double disharmony(const HueHistogram& weights, const DistanceTable& distances, int angle_deg) {
  double sum = 0;
  for (int hue = 0; hue < kHues; ++hue) {
    sum += weights[std::size_t(hue)] * distances[std::size_t((hue - angle_deg + kHues) % kHues)];
  }
  return sum;
}

}  // namespace

std::string letter_of(HarmonicTemplate form) { return form_of(form).letter; }

HarmonicTemplate template_of(const std::string& letter) {
  for (const HarmonicTemplate form : kHarmonicTemplates) {
    if (letter_of(form) == letter) return form;
  }
  throw InputError("found the harmonic template \"" + letter.substr(0, 20) + "\", allowed: i, I, V, L, Y, T, X");
}

double disharmony(const HueHistogram& weights, const Harmony& harmony) {
  return disharmony(weights, distances_of(harmony.form), harmony.angle_deg);
}

Harmony best_harmony(const HueHistogram& weights, HarmonicTemplate form) {
  const DistanceTable distances = distances_of(form);
  int best_deg = 0;
  double least = disharmony(weights, distances, 0);
  for (int angle_deg = 1; angle_deg < kHues; ++angle_deg) {
    const double sum = disharmony(weights, distances, angle_deg);
    if (sum < least) {
      least = sum;
      best_deg = angle_deg;
    }
  }
  return {form, best_deg};
}

Harmony best_harmony(const HueHistogram& weights) {
  Harmony best = best_harmony(weights, kHarmonicTemplates.front());
  double least = disharmony(weights, best);
  for (const HarmonicTemplate form : kHarmonicTemplates) {
    const Harmony harmony = best_harmony(weights, form);
    const double sum = disharmony(weights, harmony);
    if (sum < least) {
      least = sum;
      best = harmony;
    }
  }
  return best;
}

// The paper smooths the assignment of pixels to sectors by a graph cut, so that neighbours move the same way. Here a
// piece moves as a whole, so there is nothing to smooth. H' = C + w / 2 (1 - G(|H - C|)) with sigma = w / 2: the
// farther outside, the nearer to the border. The paper also moves hues inside a sector towards its centre. Here these
// stay: they are harmonic, and so drawings keep their own colours.
double harmonised_hue(int hue_deg, const Harmony& harmony) {
  const double seen_deg = hue_deg - harmony.angle_deg;
  const Sector& sector = nearest_sector(seen_deg, harmony.form);
  if (beyond_border(seen_deg, sector) <= 0) return hue_deg;
  const double half_deg = sector.width_deg / 2;
  const double from_centre_deg = way_deg(sector.centre_deg, seen_deg);
  const double in_sigmas = from_centre_deg / half_deg;
  const double to_deg = std::copysign(half_deg * (1 - std::exp(-in_sigmas * in_sigmas / 2)), from_centre_deg);
  const double there_deg = std::fmod(harmony.angle_deg + sector.centre_deg + to_deg + 360, 360);
  return there_deg < 360 ? there_deg : 0;
}

}  // namespace tessera
