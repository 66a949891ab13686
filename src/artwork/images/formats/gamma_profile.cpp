#include "artwork/images/formats/gamma_profile.h"

#include <lcms2.h>

#include <cmath>
#include <memory>

namespace tessera {
namespace {

cmsCIExyY place(const std::array<double, 2>& xy) { return {xy[0], xy[1], 1}; }

cmsHPROFILE made_profile(cmsToneCurve* curve, const Chromaticities& colours, bool grey) {
  const cmsCIExyY white = place(colours.white);
  if (grey) return cmsCreateGrayProfile(cmsD50_xyY(), curve);  // grey has no colour under any light
  const cmsCIExyYTRIPLE primaries{place(colours.red), place(colours.green), place(colours.blue)};
  cmsToneCurve* const curves[] = {curve, curve, curve};
  return cmsCreateRGBProfile(&white, &primaries, curves);
}

}  // namespace

bool is_about_srgb(double gamma, const Chromaticities& colours) {
  constexpr double kGamma = 0.45455, kSame = 0.005;
  const auto same = [](const std::array<double, 2>& a, const std::array<double, 2>& b) {
    return std::abs(a[0] - b[0]) < kSame && std::abs(a[1] - b[1]) < kSame;
  };
  const Chromaticities& srgb = kSrgbChromaticities;
  return std::abs(gamma - kGamma) < kSame && same(colours.white, srgb.white) && same(colours.red, srgb.red) &&
         same(colours.green, srgb.green) && same(colours.blue, srgb.blue);
}

std::vector<std::uint8_t> gamma_profile(double gamma, const Chromaticities& colours, bool grey) {
  constexpr double kLeastGamma = 0.05, kMostGamma = 20;
  if (!(gamma > kLeastGamma && gamma < kMostGamma)) return {};
  const std::unique_ptr<cmsToneCurve, decltype(&cmsFreeToneCurve)> curve(cmsBuildGamma(nullptr, 1 / gamma),
                                                                         cmsFreeToneCurve);
  const std::unique_ptr<void, decltype(&cmsCloseProfile)> profile(made_profile(curve.get(), colours, grey),
                                                                  cmsCloseProfile);
  cmsUInt32Number size = 0;
  if (!profile || !cmsSaveProfileToMem(profile.get(), nullptr, &size)) return {};
  std::vector<std::uint8_t> bytes(size);
  return cmsSaveProfileToMem(profile.get(), bytes.data(), &size) ? bytes : std::vector<std::uint8_t>();
}

}  // namespace tessera
