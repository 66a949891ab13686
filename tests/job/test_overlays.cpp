// colour.image and pieces.size_map: from the file to the data that pieces are compared with.
#include "job/canvas/overlays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <set>

#include "core/base/error.h"
#include "library/library_view.h"
#include "library/storage/library_file.h"
#include "support/colours.h"
#include "support/images.h"
#include "support/random_shape.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_overlays {

class Overlaid : public testing::Test {
 protected:
  Overlaid() {
    job_.path = "a.toml";
    job_.settings.pieces.min_scale_px = 16;  // gives a texel for 2 px
  }

  std::string library(bool known, std::uint32_t colours = 0) const {
    LibraryWriter writer(folder_.path("library.h5"), {});
    for (std::uint64_t seed : {1, 2, 3}) {
      Shape shape = test::RandomShape(seed, 5).make();
      shape.name = "shape" + std::to_string(seed);
      shape.colour_grid = {};
      shape.mean_lab = {float(10 * seed), 1, 2};
      if (known) test::paint(shape.colour_grid, int(seed), test::numbered_colour(std::uint32_t(seed) + colours));
      writer.append(shape);
    }
    writer.finish();
    return folder_.path("library.h5");
  }

  std::string image(const std::string& name, const cv::Mat& bgr) const {
    const std::vector<std::uint8_t> bytes = test::encoded(bgr, std::filesystem::path(name).extension());
    return folder_.write(name, std::string(bytes.begin(), bytes.end()));
  }

  Overlays overlays() const { return read_overlays(canvas_, job_, job_.settings.pieces.min_scale_px); }

  Texel colour_of(const std::string& file, Vec2 p_px) {
    job_.colour.image = file;
    set_overlays(overlays(), LibraryFile(library(true)), job_);
    return job_.settings.colour.target->at(0, p_px);
  }

  std::string mistake(const std::string& file, bool known = true) {
    job_.colour.image = file;
    try {
      set_overlays(overlays(), LibraryFile(library(known)), job_);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no mistake found";
  }

  test::ScratchFolder folder_;
  Job job_;
  Canvas canvas_ = make_rectangle_canvas(200, 100);
};

void expect_red(const Texel& texel) {
  EXPECT_NEAR(texel.lightness, 53.2f, 0.6f);
  EXPECT_NEAR(texel.a, 80.1f, 1.f);
  EXPECT_NEAR(texel.b, 67.2f, 1.f);
  EXPECT_FLOAT_EQ(texel.weight, 1);
}

/// A picture that is red on the left and black on the right, and higher than the canvas.
cv::Mat two_halves(cv::Size size) {
  cv::Mat bgr(size, CV_8UC3, cv::Scalar(0, 0, 0));
  bgr(cv::Rect(0, 0, size.width / 2, size.height)) = cv::Scalar(0, 0, 255);
  return bgr;
}

TEST_F(Overlaid, WithoutOneNothingIsWished) {
  set_overlays(overlays(), LibraryFile(library(true)), job_);
  EXPECT_FALSE(job_.settings.colour);
  EXPECT_EQ(job_.overlay_digest, 0u);
}

TEST_F(Overlaid, CoversTheCanvas) {
  const std::string file = image("a.png", two_halves({400, 200}));
  expect_red(colour_of(file, {50, 50}));
  EXPECT_LT(colour_of(file, {150, 50}).lightness, 1);
  EXPECT_EQ(job_.settings.colour.target->levels()[0].width, 100u);
  EXPECT_EQ(job_.settings.colour.target->levels()[0].height, 50u);
  EXPECT_EQ((*job_.settings.colour.of_shapes)[1].mean, (Lab{20, 1, 2}));
}

/// The picture in this file as a result keeps it.
cv::Mat kept(const Canvas& canvas, Job job, const std::string& file) {
  job.colour.image = file;
  return test::decoded(*read_overlays(canvas, job, job.settings.pieces.min_scale_px).shown_png);
}

TEST_F(Overlaid, IsKeptInItsOwnPixels) {
  cv::Mat picture(100, 200, CV_8UC4);
  cv::RNG(7).fill(picture, cv::RNG::UNIFORM, 0, 256);
  EXPECT_EQ(cv::norm(kept(canvas_, job_, image("small.png", picture)), picture, cv::NORM_INF), 0);
  const cv::Mat large = kept(canvas_, job_, image("large.png", two_halves({3000, 1500})));
  ASSERT_EQ(large.size(), cv::Size(1360, 680));
  EXPECT_EQ(large.at<cv::Vec4b>(340, 670), cv::Vec4b(0, 0, 255, 255));
  EXPECT_EQ(large.at<cv::Vec4b>(340, 690), cv::Vec4b(0, 0, 0, 255));
  EXPECT_FALSE(overlays().shown_png) << "without a picture";
}

TEST_F(Overlaid, AnSvgIsKeptAsFineAsAPhoto) {
  const std::string file = folder_.write(
      "a.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='20' height='10'><rect width='10' height='10'/></svg>");
  const cv::Mat picture = kept(canvas_, job_, file);
  ASSERT_EQ(picture.size(), cv::Size(1360, 680));
  EXPECT_EQ(picture.at<cv::Vec4b>(340, 679)[3], 255);
  EXPECT_EQ(picture.at<cv::Vec4b>(340, 680)[3], 0) << "transparent";
}

TEST_F(Overlaid, OfAnotherAspectIsCutAtTheMiddle) {
  cv::Mat bgr(400, 400, CV_8UC3, cv::Scalar(0, 0, 0));
  bgr(cv::Rect(0, 100, 400, 200)) = cv::Scalar(0, 0, 255);
  const std::string file = image("a.jpg", bgr);
  for (const Vec2 p : {Vec2{20, 6}, Vec2{190, 94}}) expect_red(colour_of(file, p));
}

TEST_F(Overlaid, TransparencyWishesNothing) {
  cv::Mat bgra(100, 200, CV_8UC4, cv::Scalar(0, 0, 255, 255));
  bgra(cv::Rect(100, 0, 100, 100)) = cv::Scalar(0, 255, 0, 0);
  const std::string file = image("a.png", bgra);
  expect_red(colour_of(file, {50, 50}));
  EXPECT_EQ(colour_of(file, {150, 50}).weight, 0);
}

TEST_F(Overlaid, MayBeAnSvg) {
  const std::string file = folder_.write(
      "a.svg",
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 20 10'><path fill='red' d='M0 0H10V10H0Z'/></svg>");
  expect_red(colour_of(file, {50, 50}));
  EXPECT_EQ(colour_of(file, {150, 50}).weight, 0);
}

/// Other machines may round sums of pixels differently, but by less than a step.
TEST_F(Overlaid, ValuesComeInSteps) {
  cv::Mat noise(173, 311, CV_8UC3);
  cv::theRNG().state = 7;
  cv::randu(noise, 0, 256);
  job_.size_map = job_.colour.image = image("noise.png", noise);
  set_overlays(overlays(), LibraryFile(library(true)), job_);
  const ColourTarget& target = *job_.settings.colour.target;
  const ColourLevel& finest = target.levels().front();
  for (std::uint32_t i = 0; i < finest.width * finest.height; ++i) {
    const Texel& t = target.texels()[i];
    for (const float v : {t.lightness, t.a, t.b, t.weight}) ASSERT_EQ(v * 256, std::round(v * 256));
  }
  for (const float v : job_.settings.pieces.size_map->part.data()) ASSERT_EQ(v * 1024, std::round(v * 1024));
}

/// The digest decides whether a run may continue.
TEST_F(Overlaid, DigestKnowsPictureAndLibrary) {
  const auto digest = [&](const cv::Mat& bgr) {
    colour_of(image("a.png", bgr), {0, 0});
    return job_.overlay_digest;
  };
  cv::Mat other = two_halves({400, 200});
  const std::uint64_t first = digest(other);
  EXPECT_EQ(digest(other), first);
  other.at<cv::Vec3b>(3, 3) = {255, 255, 255};
  EXPECT_NE(digest(other), first);
  const Grid<Texel> finest(20, 10, Texel{50, 0, 0, 1});
  const Overlays overlays{std::make_shared<const ColourTarget>(finest, 20.f), nullptr};
  std::set<std::uint64_t> of_libraries;
  for (const std::uint32_t colours : {0, 9}) {
    set_overlays(overlays, LibraryFile(library(true, colours)), job_);
    of_libraries.insert(job_.overlay_digest);
  }
  EXPECT_EQ(of_libraries.size(), 2u) << "other colours of the drawings";
}

TEST_F(Overlaid, SizesGoByLightness) {
  cv::Mat grey(100, 200, CV_8U, cv::Scalar(0));
  grey(cv::Rect(100, 0, 100, 100)) = 255;
  grey(cv::Rect(0, 50, 100, 50)) = 102;
  job_.size_map = image("sizes.png", grey);
  set_overlays(overlays(), LibraryFile(library(false)), job_);  // the job does not need colours
  const SizeMap& sizes = *job_.settings.pieces.size_map;
  EXPECT_EQ(sizes.part.width(), 25) << "two for the smallest piece";
  EXPECT_FLOAT_EQ(sizes.at({50, 20}), 0);
  EXPECT_FLOAT_EQ(sizes.at({150, 20}), 1);
  EXPECT_NEAR(sizes.at({50, 80}), 0.4f, 1e-3f);
  EXPECT_NE(job_.overlay_digest, 0u);
}

TEST_F(Overlaid, MistakesNameKeyAndFile) {
  EXPECT_EQ(mistake(folder_.path("none.png")).rfind("a.toml: colour.image: ", 0), 0u);
  const std::string text = folder_.write("text.png", "no picture");
  EXPECT_EQ(mistake(text).rfind("a.toml: colour.image: " + text, 0), 0u) << mistake(text);
  const std::string clear = image("clear.png", cv::Mat(10, 20, CV_8UC4, cv::Scalar()));
  EXPECT_EQ(mistake(clear), "a.toml: colour.image: " + clear + " is transparent all over");
  const std::string good = image("a.png", two_halves({400, 200}));
  EXPECT_EQ(mistake(good, false),
            "a.toml: colour.image: " + folder_.path("library.h5") +
                " does not know the colours of shape1's parts, because an older version built it; "
                "build it again");
  canvas_ = make_seamless_canvas(200, 100, true, true);
  EXPECT_EQ(mistake(good), "a.toml: colour.image: found with canvas.seamless, allowed: a canvas that does not repeat");
}

}  // namespace test_overlays
}  // namespace tessera
