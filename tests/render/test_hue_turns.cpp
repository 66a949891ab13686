// colour.harmony: the hues of pieces, and pictures that show them.
#include "render/hue_turns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "artwork/images/colour_conversion.h"
#include "render/pieces/sprite.h"
#include "support/svg_samples.h"

namespace tessera {
namespace test_hue_turns {

using namespace test;

double hue_deg(const cv::Vec3d& bgr) {
  const Lab lab = lab_of(bgr);
  return std::atan2(lab.b, lab.a) * 180 / std::numbers::pi;
}

double apart_deg(double a, double b) { return std::abs(std::remainder(a - b, 360)); }

cv::Vec3b turned(const cv::Vec3b& bgr, int turn_deg) {
  cv::Mat pixel(1, 1, CV_8UC4, cv::Scalar(bgr[0], bgr[1], bgr[2], 255));
  turn_hues(pixel, turn_deg);
  const cv::Vec4b p = pixel.at<cv::Vec4b>(0, 0);
  return {p[0], p[1], p[2]};
}

/// The colour of a piece in the final picture, for a drawing of one colour.
cv::Vec3b shown(const CollageReport& report, std::size_t piece) {
  cv::Vec3b bgr = bgr_of(report.colours[piece]);
  if (report.tones.empty()) return bgr;
  cv::Mat pixel(1, 1, CV_8UC4, cv::Scalar(bgr[0], bgr[1], bgr[2], 255));
  lay_patch(report.tones[piece].patch, {0, 0}, 1, pixel);
  const cv::Vec4b p = pixel.at<cv::Vec4b>(0, 0);
  return turned({p[0], p[1], p[2]}, report.tones[piece].turn_deg);
}

TonePatch even_patch(const cv::Vec4b& bgra) {
  TonePatch patch;
  patch.bgra.fill(bgra);
  return patch;
}

/// Silhouettes in these colours: a row of discs of 20 px.
struct Discs : SampleCollage {
  explicit Discs(const std::vector<std::string>& colours) {
    report.placements.clear();
    for (std::size_t k = 0; k < colours.size(); ++k) place(ShapeId{7}, 20, {15 + 25 * float(k), 50}, 0);
    report.colours = colours;
  }
};

TEST(HueTurns, GreysStayAndNothingIsNothing) {
  for (const int turn : {-170, -90, 5, 60, 180}) {
    for (const std::uint8_t grey : {0, 1, 99, 200, 255}) {
      EXPECT_EQ(turned({grey, grey, grey}, turn), cv::Vec3b(grey, grey, grey)) << turn;
    }
  }
  EXPECT_EQ(turned({1, 2, 250}, 0), cv::Vec3b(1, 2, 250));
}

TEST(HueTurns, NoColourExceedsItsAlpha) {
  cv::Mat pixel(1, 1, CV_8UC4, cv::Scalar(0, 0, 100, 100));
  turn_hues(pixel, 120);
  const cv::Vec4b p = pixel.at<cv::Vec4b>(0, 0);
  for (int c = 0; c < 4; ++c) EXPECT_LE(p[c], 100);
  EXPECT_GT(p[1], 30) << "half transparent red is half transparent green";
  EXPECT_EQ(p[3], 100);
}

TEST(HueTurns, PiecesInsideATemplateAreLeft) {
  Discs discs({"#c04030", "#c05030", "#808080"});
  harmonise(discs.report, "V");
  EXPECT_TRUE(discs.report.tones.empty());
  ASSERT_TRUE(discs.report.harmony);
  EXPECT_EQ(discs.report.harmony->form, HarmonicTemplate::V);
  harmonise(discs.report, "auto");
  EXPECT_EQ(discs.report.harmony->form, HarmonicTemplate::i) << "the narrowest that will do";
}

TEST(HueTurns, NoneIsNothingAndGreyHasNoHarmony) {
  Discs discs({"#c04030", "#30c040", "#4030c0"});
  harmonise(discs.report, "none");
  EXPECT_TRUE(discs.report.tones.empty());
  EXPECT_FALSE(discs.report.harmony);
  Discs greys({"#808080", "#000000", "#ffffff", "#818080"});
  harmonise(greys.report, "auto");
  EXPECT_TRUE(greys.report.tones.empty());
  EXPECT_FALSE(greys.report.harmony);
}

TEST(HueTurns, EveryPieceEndsInASectorAndGreysStay) {
  for (const HarmonicTemplate form : kHarmonicTemplates) {
    Discs discs({"#b05040", "#50a040", "#4050b0", "#a0a030", "#905090", "#777777", "#40a0a0"});
    harmonise(discs.report, letter_of(form));
    ASSERT_TRUE(discs.report.harmony);
    const Harmony harmony = *discs.report.harmony;
    ASSERT_EQ(discs.report.tones.size(), 7u) << letter_of(form);
    for (std::size_t k = 0; k < 7; ++k) {
      const std::string piece = letter_of(form) + " " + discs.report.colours[k];
      if (k == 5) {
        EXPECT_EQ(discs.report.tones[k].turn_deg, 0) << piece;
        continue;
      }
      const cv::Vec3b before = bgr_of(discs.report.colours[k]), after = shown(discs.report, k);
      const double there = harmonised_hue(int(std::lround(hue_deg(before)) + 360) % 360, harmony);
      EXPECT_LT(apart_deg(hue_deg(after), there), 2) << piece;
      EXPECT_NEAR(lab_of(cv::Vec3d(after)).lightness, lab_of(cv::Vec3d(before)).lightness, 10) << piece;
    }
  }
}

TEST(HueTurns, LargePiecesAndVividOnesDecide) {
  // A large red disc and small green ones; then a vivid red one and pale green ones.
  const auto red_moved = [](Discs& discs) {
    harmonise(discs.report, "i");
    return discs.report.tones[0].turn_deg != 0;
  };
  Discs alike({"#c04030", "#30a040", "#30a040"});
  EXPECT_TRUE(red_moved(alike));
  Discs large({"#c04030", "#30a040", "#30a040"});
  large.report.placements[0].canvas_from_shape = {60, 0, 100, 50};
  EXPECT_FALSE(red_moved(large));
  Discs vivid({"#ff2010", "#80907f", "#80907f"});
  EXPECT_FALSE(red_moved(vivid));
}

TEST(HueTurns, ComeAfterTheShiftOfTones) {
  Discs discs({"#c04030", "#c04030", "#c04030"});
  discs.report.tones.resize(3);
  discs.report.tones[1].patch = even_patch({0x20, 0xff, 0, 200});  // makes the second one green
  harmonise(discs.report, "i");
  EXPECT_EQ(discs.report.tones[0].turn_deg, 0);
  EXPECT_FALSE(discs.report.tones[1].patch.empty());
  EXPECT_NE(discs.report.tones[1].turn_deg, 0);
  EXPECT_LT(apart_deg(hue_deg(shown(discs.report, 1)), discs.report.harmony->angle_deg), 11);
}

TEST(HueTurns, SvgAndPngAgree) {
  TwoFaces sample;
  const cv::Mat before = drawn_picture(sample.report);
  sample.report.tones.resize(sample.report.placements.size());
  int turn_deg = -150;
  for (Tone& tone : sample.report.tones) {
    tone.turn_deg = turn_deg;
    turn_deg += 70;
  }
  Tone& last = sample.report.tones.back();
  last.patch = even_patch({20, 220, 30, 90});
  last.patch.bgra[5] = {220, 20, 30, 60};
  const Similarity& pose = sample.report.placements.back().canvas_from_shape;
  last.patch.canvas_from_cells = {pose.a / 2, -pose.b / 2, pose.tx - pose.a + pose.b,
                                  pose.b / 2, pose.a / 2,  pose.ty - pose.a - pose.b};
  const std::string svg = drawn_svg(sample.report);
  EXPECT_EQ(count(svg, "type=\"hueRotate\""), sample.report.tones.size());
  EXPECT_EQ(count(svg, "<image id=\"tone_"), 1u);
  const cv::Mat png = drawn_picture(sample.report);
  EXPECT_GT(mean_difference(before, png), 5);
  EXPECT_LT(mean_difference(drawn(svg, 400), png), 1.2);
  EXPECT_EQ(drawn_svg(sample.report), svg);
  EXPECT_EQ(mean_difference(drawn_picture(sample.report), png), 0);
}

/// Patches in an SVG end at the outlines, even where drawings do not.
TEST(HueTurns, PatchesLeaveTheBackgroundAlone) {
  TwoFaces sample;
  sample.report.output.clip = kNoClip;
  const cv::Mat plain = drawn(drawn_svg(sample.report), 400);
  sample.report.tones.resize(sample.report.placements.size());
  for (std::size_t i = 0; i < sample.report.tones.size(); ++i) {
    const Similarity& pose = sample.report.placements[i].canvas_from_shape;
    sample.report.tones[i].patch = even_patch({20, 220, 30, 64});
    sample.report.tones[i].patch.canvas_from_cells = {pose.a / 2, -pose.b / 2, pose.tx - pose.a + pose.b,
                                                      pose.b / 2, pose.a / 2,  pose.ty - pose.a - pose.b};
  }
  const cv::Mat toned = drawn(drawn_svg(sample.report), 400);
  sample.report.tones.clear();
  sample.report.colours.assign(sample.report.placements.size(), "#000000");
  const cv::Mat silhouettes = drawn_picture(sample.report);
  cv::Mat changed, outside;
  cv::absdiff(plain, toned, changed);
  cv::transform(changed, changed, cv::Matx13f(1, 1, 1));
  cv::inRange(silhouettes, cv::Scalar(0xc0, 0xe0, 0xff), cv::Scalar(0xc0, 0xe0, 0xff), outside);
  const auto left = [](const cv::Mat& picture) { return picture.colRange(0, 160); };  // the first disc
  EXPECT_GT(cv::countNonZero(left(changed > 30)), 2000);
  EXPECT_LT(cv::countNonZero(left((changed > 10) & outside)), 20) << "of pixels at an outline";
}

}  // namespace test_hue_turns
}  // namespace tessera
