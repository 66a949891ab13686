// Hues that go together: the harmonic templates of Cohen-Or, Sorkine, Gal, Leyvand, Xu, "Color Harmonization" (SIGGRAPH
// 2006). A template is one or two sectors of the hue wheel, turned as a whole to any angle; colours whose hues all lie
// in them are harmonic. Which angle the wheel gives a colour is up to the caller.
#pragma once

#include <array>
#include <string>

namespace tessera {

inline constexpr int kHues = 360;  // whole degrees, 0 to 359

/// How much there is of each hue.
using HueHistogram = std::array<double, kHues>;

/// As the paper calls them by their form, but for N, greys. Two that fit alike: the first, which is the narrower one.
enum class HarmonicTemplate { i, I, V, L, Y, T, X };
inline constexpr std::array kHarmonicTemplates = {HarmonicTemplate::i, HarmonicTemplate::I, HarmonicTemplate::V,
                                                  HarmonicTemplate::L, HarmonicTemplate::Y, HarmonicTemplate::T,
                                                  HarmonicTemplate::X};

std::string letter_of(HarmonicTemplate form);
/// Throws InputError where no template is called so.
HarmonicTemplate template_of(const std::string& letter);

/// A template on the wheel.
struct Harmony {
  HarmonicTemplate form = HarmonicTemplate::i;
  int angle_deg = 0;  // of the middle of its first sector

  friend bool operator==(const Harmony&, const Harmony&) = default;
};

/// The paper's F without saturation, which is in the weights: the sum of weight times degrees to the nearest sector.
double disharmony(const HueHistogram& weights, const Harmony& harmony);

/// The angle of least disharmony; of several the smallest.
Harmony best_harmony(const HueHistogram& weights, HarmonicTemplate form);
/// The template, too.
Harmony best_harmony(const HueHistogram& weights);

/// Where a hue goes: one outside of all sectors into the nearest, 0 <= hue < 360. What lies in a sector stays.
double harmonised_hue(int hue_deg, const Harmony& harmony);

}  // namespace tessera
