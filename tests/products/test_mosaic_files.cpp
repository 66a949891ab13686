// The files of a mosaic: its job and its map of sizes.
#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <set>
#include <sstream>

#include "artwork/images/colour_conversion.h"
#include "core/base/error.h"
#include "job/job_file.h"
#include "products/mosaic/face_search.h"
#include "products/mosaic/mosaic_files.h"
#include "products/mosaic/mosaic_job.h"
#include "support/artwork_samples.h"
#include "support/images.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_mosaic_files {

namespace fs = std::filesystem;

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(MosaicJob, SaysWhatWasPlanned) {
  const MosaicFiles files{.image = "a \"b\"\\c.png", .libraries = {"t.h5"}, .size_map = "ä_sizes.png", .regions = {}};
  const toml::table job = toml::parse(mosaic_job(files, mosaic_plan({300, 200}, 500), {8, 0.25}, 2.5));
  EXPECT_EQ(job["library"]["file"].value<std::string>(), "t.h5");
  EXPECT_EQ(job["canvas"]["size_px"][0].value<int>(), 642);
  EXPECT_EQ(job["canvas"]["size_px"][1].value<int>(), 428);
  EXPECT_EQ(job["colour"]["image"].value<std::string>(), files.image);
  EXPECT_EQ(job["colour"]["shift"].value<double>(), 2.5);
  EXPECT_EQ(job["pieces"]["scale_px"][0].value<int>(), 16);
  EXPECT_EQ(job["pieces"]["scale_px"][1].value<int>(), 80);
  EXPECT_EQ(job["pieces"]["size_map"].value<std::string>(), files.size_map);
  EXPECT_EQ(job["pieces"]["apart_px"].value<double>(), 8);
  EXPECT_EQ(job["objective"]["repetition_exponent"].value<double>(), 0.25);
  EXPECT_EQ(job["output"]["background"].value<std::string>(), "image");
  EXPECT_EQ(job["output"]["background_light"].value<double>(), 0.8);
  EXPECT_EQ(job["output"]["width_px"].value<int>(), 1284);
}

TEST(MosaicJob, NamesSeveralLibraries) {
  const toml::table job =
      toml::parse(mosaic_job({"i.png", {"a.h5", "b.h5"}, "s.png", ""}, mosaic_plan({1, 1}, 500), {}, 0));
  EXPECT_FALSE(job["library"]["file"]);
  EXPECT_EQ(job["library"]["files"][1].value<std::string>(), "b.h5");
}

TEST(MosaicJob, KeepsThePictureOfAHugeCanvasWithinWhatAScreenShows) {
  const toml::table job =
      toml::parse(mosaic_job({"i.png", {"a.h5"}, "s.png", ""}, mosaic_plan({8, 1}, kMostMosaicPieces), {}, 0));
  EXPECT_EQ(job["output"]["width_px"].value<int>(), 12'000);
}

class MosaicFilesTest : public testing::Test {
 protected:
  MosaicFilesTest() {
    cv::Mat image(40, 60, CV_8UC3, cv::Scalar(200, 40, 40));
    image.colRange(30, 60) = cv::Scalar(40, 200, 40);
    test::write_image(folder_.path("photo.png"), image);
    folder_.write("tiles.h5", "not read here");
    fs::create_directory(folder_.path("jobs"));
  }

  MosaicRequest request() const {
    return {.image = folder_.path("photo.png"),
            .libraries = {folder_.path("tiles.h5")},
            .job = folder_.path("m.toml"),
            .salient = {},
            .face_cascade = {},
            .pieces = 200};
  }
  Mosaic write(const MosaicRequest& request) {
    Drawers drawers({});
    Mosaic mosaic = make_mosaic(request, drawers);
    write_mosaic(mosaic);
    return mosaic;
  }
  /// Writes from inside the test's folder, with names relative to it.
  void write_from_the_folder(const std::string& job) {
    const fs::path before = fs::current_path();
    fs::current_path(folder_.path("."));
    MosaicRequest from_here = request();
    from_here.image = "photo.png";
    from_here.libraries = {"tiles.h5"};
    from_here.job = job;
    write(from_here);
    fs::current_path(before);
  }
  std::string refusal(const MosaicRequest& request) {
    try {
      write(request);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  test::ScratchFolder folder_;
};

TEST_F(MosaicFilesTest, LieBesideEachOther) {
  write(request());
  const toml::table job = toml::parse(bytes_of(folder_.path("m.toml")));
  EXPECT_EQ(job["pieces"]["size_map"].value<std::string>(), "m_sizes.png");
  EXPECT_EQ(job["colour"]["image"].value<std::string>(), folder_.path("photo.png"));  // this path is absolute
  const cv::Mat map = test::read_image(folder_.path("m_sizes.png"));
  EXPECT_EQ(map.type(), CV_8UC1);
  EXPECT_EQ(map.size(), cv::Size(102, 68));  // for a canvas of 406 x 271 px
}

TEST_F(MosaicFilesTest, NameTheRegionsByTheirColoursInThePicture) {
  MosaicRequest whole = request();
  whole.regions = 1;
  EXPECT_EQ(write(whole).regions, 0);
  EXPECT_FALSE(fs::exists(folder_.path("m_regions.png")));
  EXPECT_FALSE(toml::parse(bytes_of(whole.job)).contains("regions"));
  MosaicRequest parted = request();
  parted.job = folder_.path("p.toml");
  EXPECT_EQ(write(parted).regions, 2) << "six are asked for, two are there";
  const toml::table job = toml::parse(bytes_of(folder_.path("p.toml")));
  EXPECT_EQ(job["canvas"]["file"].value<std::string>(), "p_regions.png");
  EXPECT_EQ(job["colour"]["image"].value<std::string>(), folder_.path("photo.png"));
  const cv::Mat picture = test::read_image(folder_.path("p_regions.png"));
  ASSERT_EQ(picture.type(), CV_8UC4);
  ASSERT_EQ(job["regions"].as_array()->size(), 2u);
  const auto colour_at = [&](int x) {
    const cv::Vec4b p = picture.at<cv::Vec4b>(picture.rows / 2, x);
    return hex_of({p[0], p[1], p[2]});
  };
  std::set<std::string> named, shown = {colour_at(2), colour_at(picture.cols - 3)};
  for (const int i : {0, 1}) named.insert(*job["regions"][i]["colour"].value<std::string>());
  EXPECT_EQ(named, shown);
}

TEST_F(MosaicFilesTest, OfAFlatImageHaveNoRegions) {
  MosaicRequest flat = request();
  flat.image = folder_.path("flat.png");
  test::write_image(flat.image, cv::Mat(40, 60, CV_8UC3, cv::Scalar(10, 20, 30)));
  EXPECT_EQ(write(flat).regions, 0);
  EXPECT_FALSE(fs::exists(folder_.path("m_regions.png")));
}

TEST_F(MosaicFilesTest, RefuseOtherNumbersOfRegions) {
  MosaicRequest wrong = request();
  for (const int regions : {-1, 0, 9}) {
    wrong.regions = regions;
    EXPECT_NE(refusal(wrong).find("--regions: found " + std::to_string(regions) + ", allowed: from 1 to 8"),
              std::string::npos);
  }
  EXPECT_FALSE(fs::exists(wrong.job));
}

TEST_F(MosaicFilesTest, ARetouchedPictureOfRegionsIsNotReplacedUnasked) {
  MosaicRequest parted = request();
  parted.regions = 2;
  write(parted);
  folder_.write("m_regions.png", "painted");
  EXPECT_NE(refusal(parted).find("m_regions.png: is there already"), std::string::npos);
}

/// Jobs are read in the same way: names are joined as text, and links are not resolved.
TEST_F(MosaicFilesTest, NameWhatIsReadByNamesAlone) {
  fs::create_directories(folder_.path("far/away"));
  fs::create_directory_symlink(folder_.path("far/away"), folder_.path("jobs/link"));
  write_from_the_folder("jobs/link/m.toml");
  const toml::table job = toml::parse(bytes_of(folder_.path("jobs/link/m.toml")));
  EXPECT_EQ(job["colour"]["image"].value<std::string>(), "../../photo.png");
  EXPECT_EQ(load_job(folder_.path("jobs/link/m.toml"), {}).colour.image, folder_.path("photo.png"));
}

TEST_F(MosaicFilesTest, NameWhatIsReadAsSeenFromTheJob) {
  write_from_the_folder("jobs/m.toml");
  const toml::table job = toml::parse(bytes_of(folder_.path("jobs/m.toml")));
  EXPECT_EQ(job["colour"]["image"].value<std::string>(), "../photo.png");
  EXPECT_EQ(job["library"]["file"].value<std::string>(), "../tiles.h5");
}

TEST_F(MosaicFilesTest, StayWhereNothingWouldChange) {
  write(request());
  const auto written = fs::last_write_time(folder_.path("m.toml"));
  EXPECT_EQ(refusal(request()), "");
  EXPECT_EQ(fs::last_write_time(folder_.path("m.toml")), written);
}

TEST_F(MosaicFilesTest, AreNotReplacedUnasked) {
  write(request());
  const std::string edited = bytes_of(folder_.path("m.toml")) + "# mine\n";
  folder_.write("m.toml", edited);
  EXPECT_NE(refusal(request()).find("m.toml: is there already"), std::string::npos);
  EXPECT_EQ(bytes_of(folder_.path("m.toml")), edited);
  MosaicRequest again = request();
  again.replace = true;
  EXPECT_EQ(refusal(again), "");
  EXPECT_NE(bytes_of(folder_.path("m.toml")), edited);
}

TEST_F(MosaicFilesTest, ARetouchedMapIsNotReplacedUnasked) {
  write(request());
  folder_.write("m_sizes.png", "painted");
  EXPECT_NE(refusal(request()).find("m_sizes.png: is there already"), std::string::npos);
  MosaicRequest again = request();
  again.replace = true;
  EXPECT_EQ(refusal(again), "");
  EXPECT_NE(bytes_of(folder_.path("m_sizes.png")), "painted");
}

TEST_F(MosaicFilesTest, NeverReplaceWhatIsNoMosaics) {
  folder_.write("m.toml", "seed = 1\n");
  MosaicRequest again = request();
  again.replace = true;
  EXPECT_NE(refusal(again).find("m.toml: exists and was not made by tessera mosaic"), std::string::npos);
  EXPECT_EQ(bytes_of(folder_.path("m.toml")), "seed = 1\n");
  EXPECT_FALSE(fs::exists(folder_.path("m_sizes.png")));  // all files are checked before any is written
}

TEST_F(MosaicFilesTest, NeverReplaceAPictureThatNoJobIsBeside) {
  folder_.write("m_sizes.png", "somebody's");
  MosaicRequest again = request();
  again.replace = true;
  EXPECT_NE(refusal(again).find("m_sizes.png: is there and"), std::string::npos);
  EXPECT_EQ(bytes_of(folder_.path("m_sizes.png")), "somebody's");
}

TEST_F(MosaicFilesTest, NeverReplaceWhatIsRead) {
  MosaicRequest onto_library = request();
  onto_library.job = folder_.path("tiles.h5");
  onto_library.replace = true;
  EXPECT_NE(refusal(onto_library).find("tiles.h5, which is read"), std::string::npos);
  fs::rename(folder_.path("photo.png"), folder_.path("m_sizes.png"));
  MosaicRequest onto_image = request();
  onto_image.image = folder_.path("m_sizes.png");
  onto_image.replace = true;
  EXPECT_NE(refusal(onto_image).find("m_sizes.png, which is read"), std::string::npos);
}

TEST_F(MosaicFilesTest, TellWhetherFacesWereLookedFor) {
  EXPECT_FALSE(write(request()).faces.has_value()) << "without a cascade";
  MosaicRequest wall = request();
  wall.face_cascade = face_cascade_file();
  const std::string by_contrast = bytes_of(folder_.path("m_sizes.png"));
  EXPECT_EQ(write(wall).faces, 0);
  EXPECT_EQ(bytes_of(folder_.path("m_sizes.png")), by_contrast);
}

TEST_F(MosaicFilesTest, HaveSmallPiecesOnAFace) {
  MosaicRequest portrait = request();
  portrait.image = std::string(TESSERA_SOURCE_DIR) + "/jobs/photos/astronaut.jpg";
  portrait.face_cascade = folder_.path("none.xml");
  EXPECT_FALSE(write(portrait).faces.has_value());
  const cv::Mat before = test::read_image(folder_.path("m_sizes.png"));
  portrait.face_cascade = face_cascade_file();
  portrait.replace = true;
  EXPECT_EQ(write(portrait).faces, 1);
  const cv::Mat map = test::read_image(folder_.path("m_sizes.png"));
  const cv::Point eye(map.cols * 147 / 340, map.rows * 102 / 400);
  EXPECT_LT(map.at<std::uint8_t>(eye), before.at<std::uint8_t>(eye) - 40);
}

TEST_F(MosaicFilesTest, HaveSmallPiecesWhereAPictureSaysSo) {
  write(request());
  const std::string by_contrast = bytes_of(folder_.path("m_sizes.png"));
  MosaicRequest painted = request();
  painted.face_cascade = face_cascade_file();
  painted.salient = folder_.path("salient.png");
  test::write_image(painted.salient, cv::Mat::zeros(2, 3, CV_8U));
  EXPECT_FALSE(write(painted).faces.has_value()) << "the picture says all";
  EXPECT_EQ(bytes_of(folder_.path("m_sizes.png")), by_contrast);
  cv::Mat spot = cv::Mat::zeros(40, 60, CV_8U);
  spot(cv::Rect(5, 5, 10, 10)) = 255;
  test::write_image(painted.salient, spot);
  painted.replace = true;
  write(painted);
  const cv::Mat map = test::read_image(folder_.path("m_sizes.png"));
  EXPECT_LT(map.at<std::uint8_t>(map.rows / 4, map.cols / 6),
            map.at<std::uint8_t>(map.rows * 3 / 4, map.cols / 6) - 60);
}

TEST_F(MosaicFilesTest, TellWhatIsWrongWithThePictureOfWhatIsSalient) {
  MosaicRequest wrong = request();
  wrong.salient = folder_.path("none.png");
  EXPECT_NE(refusal(wrong).find("none.png: "), std::string::npos);
  wrong.salient = folder_.write("text.png", "text");
  EXPECT_NE(refusal(wrong).find("text.png: "), std::string::npos);
  wrong.salient = wrong.image;
  EXPECT_NE(refusal(wrong).find("photo.png: found the colour #2828c8 at (0, 0) px, allowed: a grey picture"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(wrong.job));
  wrong.salient = folder_.path("m_sizes.png");
  test::write_image(wrong.salient, cv::Mat::zeros(4, 6, CV_8U));
  wrong.replace = true;
  EXPECT_NE(refusal(wrong).find("m_sizes.png, which is read"), std::string::npos);
}

TEST_F(MosaicFilesTest, ADamagedCascadeIsTheMachinesFault) {
  MosaicRequest damaged = request();
  damaged.face_cascade = folder_.write("cut.xml", "<?xml version=\"1.0\"?><opencv_storage><casc");
  try {
    write(damaged);
    FAIL() << "taken";
  } catch (const EnvironmentError& error) {
    EXPECT_NE(std::string(error.what()).find("cut.xml: is no cascade"), std::string::npos) << error.what();
  }
}

TEST_F(MosaicFilesTest, TellWhatIsWrongWithTheImage) {
  MosaicRequest wrong = request();
  wrong.image = folder_.write("text.png", "text");
  EXPECT_NE(refusal(wrong).find("text.png: "), std::string::npos);
  wrong.image = folder_.path("long.png");
  test::write_image(wrong.image, cv::Mat(10, 90, CV_8UC3, cv::Scalar(1, 2, 3)));
  EXPECT_NE(refusal(wrong).find("long.png: found an image of 90 x 10 px, allowed: one side at most 8 times"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(wrong.job));
}

TEST_F(MosaicFilesTest, RefuseNamesThatAJobCannotHold) {
  MosaicRequest wrong = request();
  wrong.image = folder_.path("photo\xff.png");
  fs::copy_file(folder_.path("photo.png"), wrong.image);
  EXPECT_NE(refusal(wrong).find("not UTF-8"), std::string::npos);
}

}  // namespace test_mosaic_files
}  // namespace tessera
