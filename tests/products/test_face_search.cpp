// Faces in photographs, found with the cascade of Debian's package opencv-data (scripts/packages.txt), and the saliency of their parts.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <string>

#include "core/base/error.h"
#include "products/mosaic/face_search.h"
#include "products/mosaic/haar_cascade_file.h"
#include "products/mosaic/saliency.h"
#include "support/images.h"

namespace tessera {
namespace test_face_search {

const HaarCascade& cascade() {
  static const HaarCascade read = read_haar_cascade(face_cascade_file());
  return read;
}

cv::Mat photo(const std::string& name) {
  return test::bgr_of_image(test::read_image(std::string(TESSERA_SOURCE_DIR) + "/jobs/photos/" + name));
}

/// The numbers are fractions of the picture.
void expect_box(const Face& face, double x, double y, double width) {
  EXPECT_NEAR(face.box.x, x, 0.02);
  EXPECT_NEAR(face.box.y, y, 0.02);
  EXPECT_NEAR(face.box.width, width, 0.02);
}

// OpenCV's own detector gives 117, 66, 96 x 96 px of 340 x 400, from 30 windows.
TEST(FindFaces, FindsTheOneOfAPortrait) {
  const std::vector<Face> faces = find_faces(photo("astronaut.jpg"), cascade(), 0);
  ASSERT_EQ(faces.size(), 1u);
  expect_box(faces[0], 117 / 340., 66 / 400., 96 / 340.);
  EXPECT_EQ(faces[0].certainty, 1);
}

TEST(FindFaces, FindsItInALargePictureAndMirrored) {
  cv::Mat large, mirrored;
  cv::resize(photo("astronaut.jpg"), large, {}, 5, 5, cv::INTER_LINEAR);
  const std::vector<Face> faces = find_faces(large, cascade(), 0);
  ASSERT_EQ(faces.size(), 1u);
  expect_box(faces[0], 117 / 340., 66 / 400., 96 / 340.);
  cv::flip(photo("astronaut.jpg"), mirrored, 1);
  const std::vector<Face> other = find_faces(mirrored, cascade(), 0);
  ASSERT_EQ(other.size(), 1u);
  expect_box(other[0], 1 - (117 + 96) / 340., 66 / 400., 96 / 340.);
}

TEST(FindFaces, LeavesWhatIsNarrower) {
  EXPECT_EQ(find_faces(photo("astronaut.jpg"), cascade(), 0.25).size(), 1u);
  EXPECT_TRUE(find_faces(photo("astronaut.jpg"), cascade(), 0.4).empty());
}

TEST(FindFaces, FindsNoneInStonesTilesAndFur) {
  for (const char* name : {"flagstones.jpg", "tiles.jpg", "gravel.png", "chelsea.png"})
    EXPECT_TRUE(find_faces(photo(name), cascade(), 0).empty()) << name;
  EXPECT_TRUE(find_faces(cv::Mat(1, 1, CV_8UC3, cv::Scalar(1, 2, 3)), cascade(), 0).empty());
  EXPECT_TRUE(find_faces(cv::Mat(1, 5000, CV_8UC3, cv::Scalar(1, 2, 3)), cascade(), 0).empty());
}

constexpr double kEyes = 0.37, kMouth = 0.79;

/// The saliency in a face whose box is the middle half of 400 x 400 px. `x` and `y` are fractions of the box.
float saliency_at(const cv::Mat& saliency, double x, double y) {
  return saliency.at<float>(int(100 + 200 * y), int(100 + 200 * x));
}

TEST(SaliencyOfFaces, IsMostOnEyesAndMouth) {
  const cv::Mat map = saliency_of_faces({{.box = {0.25, 0.25, 0.5, 0.5}, .certainty = 1}}, {400, 400}, 20);
  const float eye = saliency_at(map, 0.3, kEyes), cheek = saliency_at(map, 0.3, 0.6);
  EXPECT_EQ(saliency_at(map, 0.7, kEyes), eye);
  EXPECT_EQ(saliency_at(map, 0.5, kMouth), eye);
  EXPECT_GT(eye, 1.5 * cheek);
  EXPECT_GT(cheek, 0.2);
  EXPECT_EQ(map.at<float>(5, 5), 0);
}

TEST(SaliencyOfFaces, IsLessWhereAFaceIsLessCertain) {
  const auto eye = [](const std::vector<Face>& faces) {
    return saliency_at(saliency_of_faces(faces, {400, 400}, 20), 0.3, kEyes);
  };
  const cv::Rect2d box(0.25, 0.25, 0.5, 0.5);
  EXPECT_FLOAT_EQ(eye({{box, 0.5}}), eye({{box, 1}}) / 2);
  EXPECT_FLOAT_EQ(eye({{box, 1}, {box, 0.5}}), eye({{box, 1}}));
  EXPECT_EQ(eye({}), 0);
}

// The face has 200 px.
TEST(SaliencyOfFaces, IsLessWhereAFaceIsManyPiecesWide) {
  const auto eye = [](double smallest_px) {
    return saliency_at(saliency_of_faces({{{0.25, 0.25, 0.5, 0.5}, 1}}, {400, 400}, smallest_px), 0.3, kEyes);
  };
  EXPECT_EQ(eye(40), eye(13));
  EXPECT_NEAR(eye(4), eye(8) / 2, 1e-6);
  EXPECT_LT(eye(8), eye(13));
}

TEST(SaliencyOfPicture, GoesByLightnessAndAlpha) {
  cv::Mat picture(40, 60, CV_8UC4, cv::Scalar(0, 0, 0, 255));
  picture.colRange(20, 40) = cv::Scalar(255, 255, 255, 255);
  picture.colRange(40, 60) = cv::Scalar(255, 255, 255, 0);
  const cv::Mat map = saliency_of_picture(picture, {6, 4});
  EXPECT_EQ(map.size(), cv::Size(6, 4));
  for (const auto& [x, part] : {std::pair(0, 0.f), std::pair(3, 1.f), std::pair(5, 0.f)})
    EXPECT_FLOAT_EQ(map.at<float>(2, x), part) << x;
  EXPECT_EQ(saliency_of_picture(picture, {600, 400}).size(), cv::Size(600, 400));
}

TEST(SaliencyOfPicture, RefusesColoursButNotWhatJpegMakesOfGrey) {
  cv::Mat picture(4, 6, CV_8UC4, cv::Scalar(130, 120, 125, 255));
  EXPECT_NO_THROW(saliency_of_picture(picture, {6, 4}));
  picture.at<cv::Vec4b>(2, 3) = {0, 0, 200, 0};  // a fully transparent pixel has no colour
  EXPECT_NO_THROW(saliency_of_picture(picture, {6, 4}));
  picture.at<cv::Vec4b>(2, 3) = {0, 0, 200, 255};
  try {
    saliency_of_picture(picture, {6, 4});
    FAIL() << "a colour is taken";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find("found the colour #c80000 at (3, 2) px, allowed: a grey picture"), 0u);
  }
}

}  // namespace test_face_search
}  // namespace tessera
