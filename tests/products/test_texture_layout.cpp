// The layout of a texture: elements lie beside each other as in the photo.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "products/drawn_elements.h"
#include "products/texture/texture_layout.h"

namespace tessera {
namespace test_texture_layout {

/// A map of labels with what a layout needs of it.
struct Photo {
  explicit Photo(const cv::Mat& map) : truth(map), labels(map), elements(find_elements(labels, {}).elements) {}

  PhotoLayout layout() const { return {labels, elements, label_roles(labels, elements, 0)}; }

  cv::Mat truth;
  LabelRuns labels;
  std::vector<PhotoElement> elements;
};

/// A canvas on which elements are laid: how many lie at each pixel.
struct Canvas {
  Canvas(const Photo& photo, const std::vector<LaidElement>& laid, cv::Size size)
      : depth(size, CV_32S, cv::Scalar(0)),
        owner(size, CV_32S, cv::Scalar(0)) {
    for (std::size_t i = 0; i < laid.size(); ++i) {
      const PhotoElement& element = photo.elements[laid[i].element];
      for (int y = element.box.y; y < element.box.br().y; ++y) {
        for (int x = element.box.x; x < element.box.br().x; ++x) {
          if (photo.truth.at<int>(y, x) != element.label) continue;
          const int to_x = wrapped(x + laid[i].shift_px.x, size.width);
          const int to_y = wrapped(y + laid[i].shift_px.y, size.height);
          ++depth.at<int>(to_y, to_x);
          owner.at<int>(to_y, to_x) = int(i) + 1;
        }
      }
    }
  }

  static int wrapped(int at, int period) { return (at % period + period) % period; }
  double part(int least_depth) const { return double(cv::countNonZero(depth >= least_depth)) / double(depth.total()); }

  cv::Mat depth, owner;
};

/// Six rows of six bricks, each row moved by half a brick.
cv::Mat wall() {
  cv::Mat truth = cv::Mat::zeros(6 * 40, 6 * 84, CV_32S);
  int count = 0;
  for (int row = 0; row < 6; ++row) {
    for (int i = -1; i < 6; ++i) {
      const cv::Rect brick(i * 84 + row % 2 * 42 + 2, row * 40 + 2, 80, 36);
      const cv::Rect seen = brick & cv::Rect({}, truth.size());
      if (!seen.empty()) truth(seen) = ++count;
    }
  }
  return truth;
}

TEST(TextureLayout, CoversAsMuchAsThePhotoAndHardlyOverlaps) {
  for (const cv::Mat& truth : {wall(), test::cobbles()}) {
    const Photo photo(truth);
    const cv::Size size(900, 700);
    const Canvas canvas(photo, texture_layout(photo.layout(), size, 1), size);
    const double in_photo = double(cv::countNonZero(truth)) / double(truth.total());
    EXPECT_GT(canvas.part(1), in_photo - 0.12);
    EXPECT_LT(canvas.part(1), in_photo + 0.05);
    EXPECT_LT(canvas.part(2), 0.015);
  }
}

TEST(TextureLayout, KeepsTheRowsOfAWall) {
  const Photo photo(wall());
  const std::vector<LaidElement> laid = texture_layout(photo.layout(), {840, 480}, 1);
  // In the photo the middles of neighbours in a row are 84 px apart, and on one level.
  int in_row = 0;
  const auto middle = [&](const LaidElement& e) {
    const cv::Rect& box = photo.elements[e.element].box;
    return (box.tl() + box.br()) / 2 + e.shift_px;
  };
  for (const LaidElement& one : laid) {
    in_row += std::any_of(laid.begin(), laid.end(), [&](const LaidElement& other) {
      const cv::Point d = middle(other) - middle(one);
      return std::abs(Canvas::wrapped(d.x + 420, 840) - 420 - 84) <= 12 &&
             std::abs(Canvas::wrapped(d.y + 240, 480) - 240) <= 4;
    });
  }
  EXPECT_GT(in_row, 0.8 * double(laid.size()));
}

TEST(TextureLayout, KeepsTheJoints) {
  const Photo photo(wall());
  const cv::Size size(840, 480);
  const Canvas canvas(photo, texture_layout(photo.layout(), size, 1), size);
  int touching = 0, edges = 0;  // pixels of an element beside one of another, or beside ground
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x + 1 < size.width; ++x) {
      const int left = canvas.owner.at<int>(y, x), right = canvas.owner.at<int>(y, x + 1);
      if (left == right) continue;
      ++edges;
      touching += left > 0 && right > 0;
    }
  }
  EXPECT_LT(touching, 0.15 * edges);
}

TEST(TextureLayout, UsesAllElementsAboutEquallyOften) {
  const Photo photo(test::cobbles());
  std::map<std::size_t, int> uses;
  const std::vector<LaidElement> laid = texture_layout(photo.layout(), {1200, 1000}, 1);
  for (const LaidElement& element : laid) ++uses[element.element];
  EXPECT_GT(double(uses.size()), 0.8 * double(photo.elements.size()));
  const double mean = double(laid.size()) / double(photo.elements.size());
  for (const auto& [element, count] : uses) EXPECT_LT(count, 3 * mean) << element;
}

TEST(TextureLayout, CoversTheCanvasWithElementsWhereHalfOfThePhotoIsBare) {
  cv::Mat truth = cv::Mat::zeros(330, 840, CV_32S);
  test::cobbles().copyTo(truth(cv::Rect(0, 0, 420, 330)));
  const Photo photo(truth);
  const cv::Size size(800, 600);
  const Canvas canvas(photo, texture_layout(photo.layout(), size, 1), size);
  EXPECT_GT(canvas.part(1), 0.6);
}

TEST(TextureLayout, IsTheSameForTheSameSeed) {
  const Photo photo(test::cobbles());
  const auto shifts = [&](std::uint64_t seed) {
    std::vector<int> all;
    for (const LaidElement& e : texture_layout(photo.layout(), {700, 500}, seed))
      all.insert(all.end(), {int(e.element), e.shift_px.x, e.shift_px.y});
    return all;
  };
  EXPECT_EQ(shifts(3), shifts(3));
  EXPECT_NE(shifts(3), shifts(4));
}

TEST(TextureLayout, IsEmptyWithoutElements) {
  const Photo photo(cv::Mat::zeros(50, 60, CV_32S));
  EXPECT_TRUE(texture_layout(photo.layout(), {200, 200}, 1).empty());
}

TEST(LabelRoles, TellElementsFromPartsAndSmallThings) {
  cv::Mat truth = cv::Mat::zeros(100, 100, CV_32S);
  truth(cv::Rect(20, 20, 30, 30)) = 1;  // whole
  truth(cv::Rect(0, 60, 30, 30)) = 2;   // at the edge
  truth(cv::Rect(70, 70, 5, 5)) = 3;    // small
  const LabelRuns labels(truth);
  const std::vector<PhotoElement> elements = find_elements(labels, {.least_px = 10}).elements;
  EXPECT_EQ(label_roles(labels, elements, 10),
            (std::vector<LabelRole>{LabelRole::ground, LabelRole::element, LabelRole::cut, LabelRole::ground}));
}

RC_GTEST_PROP(TextureLayout, HoldsForAnyPhotoAndCanvas, ()) {
  cv::Mat truth = cv::Mat::zeros(*rc::gen::inRange(20, 300), *rc::gen::inRange(20, 300), CV_32S);
  for (int i = 1, count = *rc::gen::inRange(1, 30); i <= count; ++i) {
    const cv::Point at(*rc::gen::inRange(0, truth.cols), *rc::gen::inRange(0, truth.rows));
    cv::circle(truth, at, *rc::gen::inRange(1, 40), i, cv::FILLED);
  }
  const Photo photo(truth);
  const cv::Size size(*rc::gen::inRange(16, 600), *rc::gen::inRange(16, 600));
  PhotoLayout layout = photo.layout();
  layout.step_px = *rc::gen::inRange(1, 4);
  const std::vector<LaidElement> all = texture_layout(layout, size, *rc::gen::arbitrary<std::uint64_t>());
  double area = 0;
  for (const LaidElement& laid : all) {
    RC_ASSERT(laid.element < photo.elements.size());
    RC_ASSERT(laid.shift_px.x % layout.step_px == 0 && laid.shift_px.y % layout.step_px == 0);
    area += photo.elements[laid.element].area_px2;
  }
  // A tenth of each element may lie on others; cells and steps are coarse.
  const Canvas canvas(photo, all, size);
  RC_ASSERT(area - cv::countNonZero(canvas.depth) <= 0.3 * area);
}

}  // namespace test_texture_layout
}  // namespace tessera
