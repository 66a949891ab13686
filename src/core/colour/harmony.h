// Harmonic hues: the templates of Cohen-Or, Sorkine, Gal, Leyvand, Xu, "Color Harmonization" (SIGGRAPH 2006). A
// template is one or two sectors of the hue wheel, turned as a whole to any angle. Colours are harmonic if all their
// hues lie in the sectors. The caller chooses the angle that the wheel gives each colour.
#pragma once

#include <array>
#include <string>

namespace tessera {

inline constexpr int kHues = 360;  // whole degrees, 0 to 359

/// The amount of each hue.
using HueHistogram = std::array<double, kHues>;

/// The paper's names, which show the form; its N (greys) is missing. If two templates fit equally, the first counts,
/// which is the narrower one.
enum class HarmonicTemplate { i, I, V, L, Y, T, X };
inline constexpr std::array kHarmonicTemplates = {HarmonicTemplate::i, HarmonicTemplate::I, HarmonicTemplate::V,
                                                  HarmonicTemplate::L, HarmonicTemplate::Y, HarmonicTemplate::T,
                                                  HarmonicTemplate::X};

std::string letter_of(HarmonicTemplate form);
/// The template with this name. Throws InputError if there is none.
HarmonicTemplate template_of(const std::string& letter);

/// A template at an angle on the wheel.
struct Harmony {
  HarmonicTemplate form = HarmonicTemplate::i;
  int angle_deg = 0;  // of the middle of its first sector

  friend bool operator==(const Harmony&, const Harmony&) = default;
};

/// The paper's F without saturation, which is part of the weights: the sum of weight times degrees to the nearest
/// sector.
double disharmony(const HueHistogram& weights, const Harmony& harmony);

/// The harmony of this template with the angle of least disharmony; among equal ones the smallest angle.
Harmony best_harmony(const HueHistogram& weights, HarmonicTemplate form);
/// The best harmony of all templates.
Harmony best_harmony(const HueHistogram& weights);

/// The harmonised hue, 0 <= hue < 360: a hue outside all sectors moves into the nearest one; a hue in a sector stays.
double harmonised_hue(int hue_deg, const Harmony& harmony);

}  // namespace tessera
