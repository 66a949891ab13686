// Surroundings of an element: the part of its photo round it.
#include <gtest/gtest.h>

#include "core/shape/shape.h"
#include "products/elements/element_surroundings.h"

namespace tessera {
namespace test_element_surroundings {

/// A photo of 100 x 80 px: each pixel tells its place. An element, its neighbour, and a speck between them.
struct Scene {
  Scene() : photo(80, 100, CV_8UC4), labels(cv::Mat::zeros(80, 100, CV_32S)) {
    for (int y = 0; y < photo.rows; ++y) {
      for (int x = 0; x < photo.cols; ++x) photo.at<cv::Vec4b>(y, x) = {std::uint8_t(x), std::uint8_t(y), 7, 255};
    }
    labels(cv::Rect(20, 20, 20, 30)) = 1;
    labels(cv::Rect(60, 20, 20, 30)) = 2;
    labels(cv::Rect(45, 30, 4, 4)) = 3;
  }

  cv::Mat of_first(int margin_px) const {
    const LabelRuns runs(labels);
    const std::vector<PhotoElement> elements = find_elements(runs, {.least_px = 10}).elements;
    return element_surroundings(photo, labels, label_roles(runs, elements, 10), elements[0], margin_px);
  }

  cv::Mat photo, labels;
};

TEST(ElementSurroundings, TellOtherElementsFromGround) {
  constexpr int kMargin_px = 30;
  const Scene scene;
  const cv::Mat page = scene.of_first(kMargin_px);
  const int more_px = kMargin_px + kElementRim_px;
  EXPECT_EQ(page.size(), cv::Size(20 + 2 * more_px, 30 + 2 * more_px));
  const auto at = [&](int x, int y) { return page.at<cv::Vec4b>(y - 20 + more_px, x - 20 + more_px); };
  EXPECT_EQ(at(30, 30), cv::Vec4b(30, 30, 7, 255)) << "the element itself";
  EXPECT_EQ(at(50, 60), cv::Vec4b(50, 60, 7, 255)) << "ground";
  EXPECT_EQ(at(46, 31), cv::Vec4b(46, 31, 7, 255)) << "a speck belongs to the ground";
  EXPECT_EQ(at(65, 30), cv::Vec4b(65, 30, 7, kOtherElementAlpha)) << "the neighbour";
  EXPECT_EQ(at(59, 30), cv::Vec4b(59, 30, 7, kOtherElementAlpha)) << "its soft edge";
  EXPECT_EQ(at(57, 30), cv::Vec4b(57, 30, 7, 255));
  EXPECT_EQ(at(-5, 30), cv::Vec4b()) << "beyond the photo";
}

TEST(ElementSurroundings, ShowTheElementUpToItsEdgeWhereAnotherTouchesIt) {
  Scene scene;
  scene.labels(cv::Rect(40, 20, 20, 30)) = 2;
  const cv::Mat page = scene.of_first(10);
  EXPECT_EQ(page.at<cv::Vec4b>(30 - 20 + 13, 39 - 20 + 13), cv::Vec4b(39, 30, 7, 255));
}

TEST(ElementSurroundings, MarginFollowsTheSizeOfElements) {
  const auto with_area = [](double area_px2) { return PhotoElement{1, {}, area_px2}; };
  EXPECT_EQ(surroundings_margin_px({with_area(10'000), with_area(10'000)}), 75);
  EXPECT_EQ(surroundings_margin_px({with_area(4)}), 16);
  EXPECT_EQ(surroundings_margin_px({with_area(1e8)}), 512);
  EXPECT_EQ(surroundings_margin_px({}), 16);
}

}  // namespace test_element_surroundings
}  // namespace tessera
