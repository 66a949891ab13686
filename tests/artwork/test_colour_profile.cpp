// Pictures with colour profiles become sRGB, in every format and at every place that reads pictures.
#include "artwork/images/colour_profile.h"

#include <gtest/gtest.h>
#include <lcms2.h>

#include <cstdlib>

#include "artwork/images/photo.h"
#include "artwork/images/raster_page.h"
#include "artwork/images/whole_picture.h"
#include "support/images.h"

namespace tessera {
namespace test_colour_profile {

using test::Bytes;

Bytes bytes_of(cmsHPROFILE profile) {
  cmsUInt32Number size = 0;
  cmsSaveProfileToMem(profile, nullptr, &size);
  Bytes bytes(size);
  cmsSaveProfileToMem(profile, bytes.data(), &size);
  cmsCloseProfile(profile);
  return bytes;
}

cmsToneCurve* gamma_curve(double gamma) { return cmsBuildGamma(nullptr, gamma); }

/// A profile with the primaries of sRGB and gamma 1: the byte 128 is half the light, which sRGB encodes as 188.
Bytes linear_profile() {
  const cmsCIExyY d65{0.3127, 0.3290, 1};
  const cmsCIExyYTRIPLE primaries{{0.64, 0.33, 1}, {0.30, 0.60, 1}, {0.15, 0.06, 1}};
  cmsToneCurve* curve = gamma_curve(1);
  cmsToneCurve* curves[] = {curve, curve, curve};
  const Bytes bytes = bytes_of(cmsCreateRGBProfile(&d65, &primaries, curves));
  cmsFreeToneCurve(curve);
  return bytes;
}

Bytes linear_grey_profile() {
  cmsToneCurve* curve = gamma_curve(1);
  const Bytes bytes = bytes_of(cmsCreateGrayProfile(cmsD50_xyY(), curve));
  cmsFreeToneCurve(curve);
  return bytes;
}

constexpr int kHalf = 128, kHalfInSrgb = 188;
constexpr const char* kFormats[] = {".jpg", ".png", ".webp", ".tiff"};

TEST(ColourProfile, IsAppliedInEveryFormat) {
  const cv::Mat half(30, 40, CV_8UC3, cv::Scalar::all(kHalf));
  for (const char* extension : kFormats) {
    const Bytes bytes = test::encoded_with_profile(half, extension, linear_profile());
    for (const cv::Mat& read : {photo_picture(bytes, "half"), whole_picture(bytes, "half", 100),
                                open_raster_page(bytes, "half", Background::kept)->draw(40, {0, 0, 40, 30})}) {
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(read.at<cv::Vec4b>(15, 20)[c], kHalfInSrgb, 2) << extension;
    }
  }
}

TEST(ColourProfile, OfAGreyPictureIsOne) {
  const cv::Mat half(30, 40, CV_8UC1, cv::Scalar(kHalf));
  for (const char* extension : {".jpg", ".png", ".tiff"}) {
    const Bytes bytes = test::encoded_with_profile(half, extension, linear_grey_profile());
    EXPECT_NEAR(photo_picture(bytes, "half").at<cv::Vec4b>(15, 20)[0], kHalfInSrgb, 2) << extension;
  }
}

TEST(ColourProfile, LeavesAlphaAndSixteenBits) {
  cv::Mat half(2, 2, CV_16UC4, cv::Scalar(0x8080, 0x8080, 0x8080, 0x1234));
  make_srgb(half, linear_profile());
  EXPECT_NEAR(half.at<cv::Vec4w>(1, 1)[0], kHalfInSrgb * 257, 257);
  EXPECT_EQ(half.at<cv::Vec4w>(1, 1)[3], 0x1234);
}

/// A blue of a large gamut lies outside sRGB: its red and green become 0, and the channels keep their order.
TEST(ColourProfile, KeepsTheOrderOfChannels) {
  cv::Mat blue(1, 1, CV_8UC3, cv::Scalar(kHalf, 0, 0));
  make_srgb(blue, linear_profile());
  EXPECT_NEAR(blue.at<cv::Vec3b>(0, 0)[0], kHalfInSrgb, 2);
  EXPECT_LE(blue.at<cv::Vec3b>(0, 0)[2], 3);
}

TEST(ColourProfile, ThatIsSrgbChangesNoByte) {
  cv::Mat picture(16, 16, CV_8UC3);
  cv::randu(picture, 0, 256);
  const cv::Mat before = picture.clone();
  make_srgb(picture, bytes_of(cmsCreate_sRGBProfile()));
  EXPECT_EQ(cv::norm(picture, before, cv::NORM_INF), 0);
}

TEST(ColourProfile, ThatIsOfNoUseIsPassedOver) {
  const cv::Mat before(4, 4, CV_8UC3, cv::Scalar::all(kHalf));
  Bytes cut = linear_profile();
  cut.resize(cut.size() / 2);
  for (const Bytes& profile : {Bytes{}, Bytes{1, 2, 3}, Bytes(200, 0), cut, linear_grey_profile()}) {
    cv::Mat picture = before.clone();
    make_srgb(picture, profile);
    EXPECT_EQ(cv::norm(picture, before, cv::NORM_INF), 0) << profile.size();
  }
  const Bytes whole = linear_profile();
  for (std::size_t i = 0; i < whole.size(); ++i) {
    Bytes forged = whole;
    forged[i] ^= 0xff;
    cv::Mat picture = before.clone();
    make_srgb(picture, forged);
  }
}

/// A gAMA value of 100,000 means gamma 1.
TEST(ColourProfile, AGammaOfAPngAloneCountsToo) {
  const cv::Mat half(30, 40, CV_8UC3, cv::Scalar::all(kHalf));
  const Bytes png = test::encoded(half, ".png");
  const Bytes linear = test::png_with_chunk(png, "gAMA", {0x00, 0x01, 0x86, 0xa0});
  EXPECT_NEAR(photo_picture(linear, "half").at<cv::Vec4b>(15, 20)[0], kHalfInSrgb, 2);
  const Bytes usual = test::png_with_chunk(png, "gAMA", {0x00, 0x00, 0xb1, 0x8f});
  EXPECT_EQ(photo_picture(usual, "half").at<cv::Vec4b>(15, 20)[0], kHalf);
  const Bytes is_srgb = test::png_with_chunk(linear, "sRGB", {0});
  EXPECT_EQ(photo_picture(is_srgb, "half").at<cv::Vec4b>(15, 20)[0], kHalf);
}

/// Labels are numbers, not colours.
TEST(ColourProfile, OfLabelsIsPassedOver) {
  const cv::Mat stored(2, 3, CV_8U, cv::Scalar(kHalf));
  const cv::Mat labels = label_picture(test::encoded_with_profile(stored, ".png", linear_grey_profile()), "labels");
  EXPECT_EQ(labels.at<std::int32_t>(0, 0), kHalf);
}

}  // namespace test_colour_profile
}  // namespace tessera
