#include "artwork/images/colour_profile.h"

#include <lcms2.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <vector>

namespace tessera {
namespace {

struct CloseProfile {
  void operator()(void* profile) const { cmsCloseProfile(profile); }
};
using Profile = std::unique_ptr<void, CloseProfile>;

struct DeleteTransform {
  void operator()(void* transform) const { cmsDeleteTransform(transform); }
};
using Transform = std::unique_ptr<void, DeleteTransform>;

Profile grey_of_srgb() {
  constexpr cmsInt32Number kSrgbCurve = 4;  // (a x + b) to the power of g from d on, c x below
  constexpr cmsFloat64Number kGabcd[] = {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045};
  cmsToneCurve* curve = cmsBuildParametricToneCurve(nullptr, kSrgbCurve, kGabcd);
  Profile profile(cmsCreateGrayProfile(cmsD50_xyY(), curve));
  cmsFreeToneCurve(curve);
  return profile;
}

cmsUInt32Number format_of(int channels, bool deep) {
  if (channels == 1) return deep ? TYPE_GRAY_16 : TYPE_GRAY_8;
  if (channels == 3) return deep ? TYPE_BGR_16 : TYPE_BGR_8;
  return deep ? TYPE_BGRA_16 : TYPE_BGRA_8;
}

/// The transform; null where the profile cannot be used for this number of channels.
Transform transform_to_srgb(std::span<const std::uint8_t> bytes, int channels, bool deep) {
  const Profile profile(cmsOpenProfileFromMem(bytes.data(), cmsUInt32Number(bytes.size())));
  const bool grey = channels == 1;
  if (!profile || cmsGetColorSpace(profile.get()) != (grey ? cmsSigGrayData : cmsSigRgbData)) return nullptr;
  const Profile srgb = grey ? grey_of_srgb() : Profile(cmsCreate_sRGBProfile());
  const cmsUInt32Number format = format_of(channels, deep);
  return Transform(cmsCreateTransform(profile.get(), format, srgb.get(), format, INTENT_PERCEPTUAL,
                                      channels == 4 ? cmsFLAGS_COPY_ALPHA : 0));
}

/// Whether no colour in a grid of 8-bit colours changes by more than one step. Then the profile is sRGB, as most are.
bool changes_nothing(std::span<const std::uint8_t> profile, int channels) {
  constexpr int kSteps = 9;
  const int colours = channels == 1 ? 256 : kSteps * kSteps * kSteps;
  const int colour_channels = std::min(channels, 3);
  std::vector<std::uint8_t> before;
  for (int i = 0; i < colours; ++i) {
    if (channels == 1) {
      before.push_back(std::uint8_t(i));
      continue;
    }
    for (const int step : {i % kSteps, i / kSteps % kSteps, i / kSteps / kSteps}) {
      before.push_back(std::uint8_t(step * 255 / (kSteps - 1)));
    }
  }
  std::vector<std::uint8_t> after(before.size());
  const Transform transform = transform_to_srgb(profile, colour_channels, false);
  cmsDoTransform(transform.get(), before.data(), after.data(), cmsUInt32Number(colours));
  return std::equal(before.begin(), before.end(), after.begin(), [](int a, int b) { return std::abs(a - b) <= 1; });
}

}  // namespace

void make_srgb(cv::Mat& pixels, std::span<const std::uint8_t> profile) {
  if (profile.empty()) return;
  const Transform transform = transform_to_srgb(profile, pixels.channels(), pixels.depth() == CV_16U);
  if (!transform || changes_nothing(profile, pixels.channels())) return;
  for (int y = 0; y < pixels.rows; ++y) {
    cmsDoTransform(transform.get(), pixels.ptr(y), pixels.ptr(y), cmsUInt32Number(pixels.cols));
  }
}

}  // namespace tessera
