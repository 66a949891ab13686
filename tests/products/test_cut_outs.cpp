// A library of the elements of photographs.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "artwork/images/png_encoder.h"
#include "drawn_elements.h"
#include "library/storage/library_file.h"
#include "products/elements/cut_outs.h"
#include "products/elements/photo_extraction.h"
#include "support/artwork_samples.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_cut_outs {

const BuildProgress kSilent = [](std::size_t, std::size_t) {};
const LibraryParts kEverything{.outline = true, .field = true, .levels = ~0u, .artwork = true, .original = true, .surroundings = true};

/// Twelve discs on grey, which grow to the right and downwards.
struct Pebbles {
  Pebbles() : photo(300, 400, CV_8UC4, cv::Scalar(128, 128, 128, 255)), labels(cv::Mat::zeros(300, 400, CV_32S)) {
    for (int i = 0; i < 12; ++i) {
      const cv::Point centre(50 + i % 4 * 100, 50 + i / 4 * 100);
      cv::circle(labels, centre, 20 + 2 * i, cv::Scalar(i + 1), cv::FILLED);
      cv::circle(photo, centre, 20 + 2 * i, cv::Scalar(20 * i, 60, 250 - 20 * i, 255), cv::FILLED);
    }
  }

  std::vector<CutOut> cut(const std::string& path) const {
    const LabelRuns runs(labels);
    const std::vector<PhotoElement> elements = find_elements(runs, {}).elements;
    return cut_outs(path, photo, runs, label_roles(runs, elements, 0), elements);
  }

  cv::Mat photo, labels;
};

class CutOuts : public testing::Test {
 protected:
  std::vector<Shape> library_of(const std::vector<CutOut>& cut_outs) {
    ArtworkFiles files;
    for (const CutOut& cut_out : cut_outs) files.paths.push_back(cut_out.path);
    Drawers drawers({});
    const std::string path = folder_.path("pebbles.h5");
    build_library(files, path, {}, cut_out_loader(drawers, cut_outs, {}), kSilent);
    const LibraryFile library(path);
    return library.read(0, library.size(), kEverything);
  }

  test::ScratchFolder folder_;
};

TEST_F(CutOuts, BecomeShapesWithTheirOwnPixels) {
  const std::vector<CutOut> cut_outs = Pebbles().cut("/photos/beach.jpg");
  ASSERT_EQ(cut_outs.size(), 12u);
  const std::vector<Shape> shapes = library_of(cut_outs);
  ASSERT_EQ(shapes.size(), 12u);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    EXPECT_EQ(shapes[i].artwork.original, cut_outs[i].png);
    EXPECT_EQ(shapes[i].artwork.surroundings_png, cut_outs[i].surroundings_png);
    EXPECT_EQ(shapes[i].artwork.surroundings_margin_px, cut_outs[i].surroundings_margin_px);
    EXPECT_GT(cut_outs[i].surroundings_margin_px, 0);
    EXPECT_EQ(shapes[i].artwork.path, "/photos/beach.jpg");
  }
  EXPECT_EQ(shapes[0].name, "beach_01");
  EXPECT_EQ(shapes[11].name, "beach_12");
  EXPECT_NEAR(shapes[0].drawn_scale_px, 26 * std::sqrt(3.1416), 1) << "the highest of the first row";
  EXPECT_GT(shapes[0].mean_lab[1], shapes[11].mean_lab[1]) << "the first is red, the last is not";
}

TEST_F(CutOuts, OfPhotosOfOneNameHaveNamesOfTheirOwn) {
  std::vector<CutOut> both = Pebbles().cut("/summer/beach.jpg");
  Pebbles other;
  other.photo.setTo(cv::Scalar(200, 200, 40, 255), other.labels > 0);
  for (CutOut& cut_out : other.cut("/winter/beach.jpg")) both.push_back(std::move(cut_out));
  const std::vector<Shape> shapes = library_of(both);
  ASSERT_EQ(shapes.size(), 24u);
  EXPECT_EQ(shapes[23].artwork.path, "/winter/beach.jpg");
  EXPECT_NE(shapes[23].name, shapes[11].name);
}

/// Squares of 40 px in a photo of 400 x 400 px. The last `small` ones have 16 px; they lie at the edge where they are cut.
int times_enlarged(const test::ScratchFolder& folder, int small, bool are_cut) {
  cv::Mat labels(400, 400, CV_16U, cv::Scalar(0)), photo(400, 400, CV_8UC3, cv::Scalar(90, 90, 90));
  for (int i = 0; i < 16; ++i) {
    const bool is_small = i >= 16 - small;
    const int side_px = is_small ? 16 : 40, x = is_small && are_cut ? 400 - side_px : 20 + i % 4 * 90;
    labels(cv::Rect(x, 20 + i / 4 * 90, side_px, side_px)) = i + 1;
  }
  const auto written = [&](const std::string& name, const cv::Mat& picture) {
    const std::vector<std::uint8_t> png = png_of(picture);
    return folder.write(name, std::string(png.begin(), png.end()));
  };
  Drawers drawers({});
  ExtractionSettings settings;
  settings.labels = written("labels.png", labels);
  settings.enlarged_element_px = 40;
  return extract_elements(written("photo.png", photo), settings, drawers).enlarged;
}

TEST_F(CutOuts, ThePhotoIsEnlargedUntilSevenOfEightAreLargeEnough) {
  EXPECT_EQ(times_enlarged(folder_, 0, false), 1);
  EXPECT_EQ(times_enlarged(folder_, 2, false), 1) << "14 of 16 are large enough";
  EXPECT_EQ(times_enlarged(folder_, 3, false), 2);
  EXPECT_EQ(times_enlarged(folder_, 1, true), 1) << "the photo's edge cuts the small one";
  EXPECT_EQ(times_enlarged(folder_, 3, true), 1) << "the photo's edge cuts all small ones";
}

/// The same, with a search.
TEST_F(CutOuts, ThePhotoIsEnlargedForWhatTheSearchFound) {
  const test::ElementPhoto discs = test::photographed(test::discs(), {110, 120, 130}, {45, 50, 55});
  cv::Mat small;  // every fifth disc is too small for a library: 22 px
  cv::resize(discs.bgr, small, {}, 0.62, 0.62, cv::INTER_AREA);
  const std::vector<std::uint8_t> png = png_of(small);
  Drawers drawers({});
  ExtractionSettings settings;
  settings.element_px = 40;
  settings.enlarged_element_px = 40;
  const Extraction found =
      extract_elements(folder_.write("discs.png", std::string(png.begin(), png.end())), settings, drawers);
  EXPECT_EQ(found.enlarged, 2);
  EXPECT_EQ(found.found.elements.size(), 20u);
  settings.most_enlarged = 1;
  EXPECT_EQ(extract_elements(folder_.path("discs.png"), settings, drawers).enlarged, 1);
}

}  // namespace test_cut_outs
}  // namespace tessera
