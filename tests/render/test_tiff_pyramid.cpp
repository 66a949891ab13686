// The TIFF as other programs read it: all of its sizes, exact to the pixel.
#include "render/tiff_pyramid.h"

#include <gtest/gtest.h>
#include <tiffio.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "artwork/images/alpha.h"
#include "core/base/error.h"
#include "support/file_size_limit.h"
#include "support/planted_files.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_tiff_pyramid {

struct CloseTiff {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using TiffPtr = std::unique_ptr<TIFF, CloseTiff>;

template <class Value>
Value field(TIFF* tiff, std::uint32_t tag) {
  Value value{};
  TIFFGetFieldDefaulted(tiff, tag, &value);
  return value;
}

/// The pixels of the current directory, as BGR or BGRA.
cv::Mat pixels(TIFF* tiff) {
  const int channels = field<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL);
  const int tile_px = int(field<std::uint32_t>(tiff, TIFFTAG_TILEWIDTH));
  const cv::Size size(int(field<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH)),
                      int(field<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH)));
  cv::Mat image(size, CV_8UC(channels));
  cv::Mat tile(tile_px, tile_px, CV_8UC(channels));
  for (int y = 0; y < size.height; y += tile_px) {
    for (int x = 0; x < size.width; x += tile_px) {
      EXPECT_GT(TIFFReadTile(tiff, tile.data, std::uint32_t(x), std::uint32_t(y), 0, 0), 0);
      const cv::Rect part = cv::Rect(x, y, tile_px, tile_px) & cv::Rect({0, 0}, size);
      tile(cv::Rect({0, 0}, part.size())).copyTo(image(part));
    }
  }
  cv::cvtColor(image, image, channels == 4 ? cv::COLOR_RGBA2BGRA : cv::COLOR_RGB2BGR);
  return image;
}

cv::Mat noise(const cv::Size& size, int type) {
  cv::Mat picture(size, type);
  cv::RNG(7).fill(picture, cv::RNG::UNIFORM, 0, 256);
  return picture;
}

/// Writes rows as a drawing delivers them, which are not whole rows of tiles.
void write(TiffPyramid& tiff, const cv::Mat& picture) {
  for (int y = 0; y < picture.rows; y += 100) tiff.write(picture.rowRange(y, std::min(y + 100, picture.rows)));
}

TEST(TiffPyramid, FollowsNothingThatOthersPutThere) {
  for (const test::Plant plant : test::kPlants) {
    const test::ScratchFolder folder;
    const test::PlantedFiles planted;
    for (const char* name : {"collage.tiff", "collage.tiff.tmp", "collage.tiff.tmp.level"})
      planted.put(plant, folder.path(name));
    const cv::Mat picture = noise({600, 300}, CV_8UC3);
    TiffPyramid file(folder.path("collage.tiff"), {.size = picture.size()});
    write(file, picture);
    file.finish();
    const TiffPtr tiff(TIFFOpen(folder.path("collage.tiff").c_str(), "r"));
    ASSERT_TRUE(tiff);
    EXPECT_EQ(cv::norm(pixels(tiff.get()), picture, cv::NORM_INF), 0);
    EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(folder.path("collage.tiff.tmp"))));
    EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(folder.path("collage.tiff.tmp.level"))));
    planted.expect_untouched();
  }
}

TEST(TiffPyramid, HoldsThePictureAndItsHalves) {
  const test::ScratchFolder folder;
  const cv::Mat picture = noise({1101, 823}, CV_8UC3);
  TiffPyramid file(folder.path("collage.tiff"), {.size = picture.size(), .size_mm = {93.218, 69.6807}});
  write(file, picture);
  EXPECT_FALSE(std::filesystem::exists(folder.path("collage.tiff")));
  file.finish();
  const TiffPtr tiff(TIFFOpen(folder.path("collage.tiff").c_str(), "r"));
  ASSERT_TRUE(tiff);
  EXPECT_FALSE(TIFFIsBigTIFF(tiff.get()));
  // 1101 px on 93.218 mm and 823 px on 69.6807 mm, with an error far below 0.001 mm.
  EXPECT_NEAR(1101 * 25.4 / double(field<float>(tiff.get(), TIFFTAG_XRESOLUTION)), 93.218, 1e-4);
  EXPECT_NEAR(823 * 25.4 / double(field<float>(tiff.get(), TIFFTAG_YRESOLUTION)), 69.6807, 1e-4);
  EXPECT_EQ(field<std::uint32_t>(tiff.get(), TIFFTAG_SUBFILETYPE), 0u);
  cv::Mat expected = picture;
  for (const cv::Size size : {cv::Size(1101, 823), cv::Size(551, 412), cv::Size(276, 206), cv::Size(138, 103)}) {
    const cv::Mat found = pixels(tiff.get());
    ASSERT_EQ(found.size(), size);
    EXPECT_EQ(cv::norm(found, expected, cv::NORM_INF), 0) << size;
    const bool is_last = TIFFReadDirectory(tiff.get()) == 0;
    EXPECT_EQ(is_last, size.width == 138);
    if (is_last) break;
    EXPECT_EQ(field<std::uint32_t>(tiff.get(), TIFFTAG_SUBFILETYPE), std::uint32_t(FILETYPE_REDUCEDIMAGE));
    cv::copyMakeBorder(expected, expected, 0, expected.rows % 2, 0, expected.cols % 2, cv::BORDER_REPLICATE);
    cv::resize(expected, expected, expected.size() / 2, 0, 0, cv::INTER_AREA);
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path("")), {}), 1);
}

TEST(TiffPyramid, TransparentPixelsLendNoColourToTheirNeighbours) {
  const test::ScratchFolder folder;
  cv::Mat picture(300, 300, CV_8UC4, cv::Scalar(0, 0, 0, 0));
  for (int y = 0; y < picture.rows; y += 2) picture.row(y).setTo(cv::Scalar(10, 200, 90, 255));
  TiffPyramid file(folder.path("collage.tiff"), {.size = picture.size(), .alpha = true});
  write(file, picture);
  file.finish();
  const TiffPtr tiff(TIFFOpen(folder.path("collage.tiff").c_str(), "r"));
  ASSERT_TRUE(tiff);
  EXPECT_EQ(cv::norm(pixels(tiff.get()), picture, cv::NORM_INF), 0);
  ASSERT_EQ(TIFFReadDirectory(tiff.get()), 1);
  const cv::Vec4b half = pixels(tiff.get()).at<cv::Vec4b>(70, 70);
  EXPECT_NEAR(half[0], 10, 1);
  EXPECT_NEAR(half[1], 200, 1);
  EXPECT_NEAR(half[2], 90, 1);
  EXPECT_NEAR(half[3], 128, 1);
}

TEST(TiffPyramid, IsABigTiffWhereItMayNeedMoreThanFourGigabytes) {
  const test::ScratchFolder folder;
  TiffPyramid file(folder.path("collage.tiff"), {.size = {60000, 40000}});
  file.write(cv::Mat(256, 60000, CV_8UC3, cv::Scalar::all(255)));
  std::ifstream written(folder.path("collage.tiff.tmp"), std::ios::binary);
  char mark[3] = {};
  written.read(mark, 3);
  EXPECT_EQ(mark[2], 43);
}

TEST(TiffPyramid, LeavesNothingWhereItWasNotFinished) {
  const test::ScratchFolder folder;
  {
    TiffPyramid file(folder.path("collage.tiff"), {.size = {500, 500}});
    file.write(cv::Mat(300, 500, CV_8UC3, cv::Scalar::all(255)));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path("")));
  EXPECT_THROW(TiffPyramid(folder.path("none/collage.tiff"), {.size = {500, 500}}), EnvironmentError);
}

TEST(TiffPyramid, AFullDiskIsAnErrorAndLeavesNothing) {
  const test::ScratchFolder folder;
  const cv::Mat picture = noise({1101, 823}, CV_8UC3);
  const auto make = [&] {
    TiffPyramid file(folder.path("collage.tiff"), {.size = picture.size()});
    write(file, picture);
    file.finish();
  };
  make();
  const auto needed = rlim_t(std::filesystem::file_size(folder.path("collage.tiff")));
  std::filesystem::remove(folder.path("collage.tiff"));
  // Too little room for the first tile, the whole picture, the reduced ones, or the last directory.
  for (const rlim_t bytes : {rlim_t(1000), needed / 4, needed * 9 / 10, needed - 1}) {
    const test::FileSizeLimit limit(bytes);
    EXPECT_THROW(make(), EnvironmentError) << bytes;
    EXPECT_TRUE(std::filesystem::is_empty(folder.path(""))) << bytes;
  }
}

}  // namespace test_tiff_pyramid
}  // namespace tessera
