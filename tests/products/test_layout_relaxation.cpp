// Joints of a layout become even.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "products/random_labels.h"
#include "products/texture/element_joints.h"
#include "products/texture/layout_relaxation.h"
#include "products/texture/spring_network.h"

namespace tessera {
namespace test_layout_relaxation {

const cv::Size kBrick(80, 36), kWall(8 * 84, 6 * 40);

/// Rows of bricks, each moved by half a brick, with joints of 4 px. The photo is two bricks larger on each side than
/// what is laid, so that all of these are whole.
struct Wall {
  Wall() : labels(drawn()), elements(find_elements(labels, {}).elements) {}

  static cv::Mat drawn() {
    cv::Mat map = cv::Mat::zeros(kWall.height + 8, kWall.width + 100, CV_32S);
    int count = 0;
    for (int row = 0; row < 6; ++row) {
      for (int i = 0; i < 8; ++i) map(cv::Rect({4 + i * 84 + row % 2 * 42, 4 + row * 40}, kBrick)) = ++count;
    }
    return map;
  }

  PhotoLayout layout() const { return {labels, elements, label_roles(labels, elements, 0)}; }

  /// All bricks as in the photo; those right of a column are moved as another patch.
  std::vector<LaidElement> laid(int column_px, cv::Point moved) const {
    std::vector<LaidElement> all;
    for (std::size_t i = 0; i < elements.size(); ++i)
      all.push_back({i, elements[i].box.x >= column_px ? moved : cv::Point()});
    return all;
  }

  LabelRuns labels;
  std::vector<PhotoElement> elements;
};

/// The widths of the joints between neighbours in a row, px; below 0: they overlap.
std::vector<int> joints_in_rows(const Wall& wall, const std::vector<LaidElement>& laid) {
  std::vector<int> widths;
  for (std::size_t i = 0; i + 1 < laid.size(); ++i) {
    const cv::Rect left = wall.elements[i].box + laid[i].shift_px;
    const cv::Rect right = wall.elements[i + 1].box + laid[i + 1].shift_px;
    if (wall.elements[i].box.y == wall.elements[i + 1].box.y) widths.push_back(right.x - left.br().x);
  }
  return widths;
}

TEST(LayoutRelaxation, SpreadsAWideJointOverTheRow) {
  const Wall wall;
  const std::vector<LaidElement> laid = wall.laid(300, {16, 0});
  const std::vector<int> before = joints_in_rows(wall, laid);
  ASSERT_EQ(*std::max_element(before.begin(), before.end()), 20);
  const std::vector<int> after =
      joints_in_rows(wall, relaxed_layout(wall.layout(), laid, {kWall.width + 16, kWall.height}));
  EXPECT_LE(*std::max_element(after.begin(), after.end()), 10);
  EXPECT_GE(*std::min_element(after.begin(), after.end()), 3);
}

TEST(LayoutRelaxation, MovesOverlappingElementsApart) {
  const Wall wall;
  const std::vector<LaidElement> laid = wall.laid(300, {-12, 0});
  const std::vector<int> before = joints_in_rows(wall, laid);
  ASSERT_EQ(*std::min_element(before.begin(), before.end()), -8);
  const std::vector<int> after = joints_in_rows(wall, relaxed_layout(wall.layout(), laid, {kWall.width, kWall.height}));
  EXPECT_GE(*std::min_element(after.begin(), after.end()), 0);
}

TEST(LayoutRelaxation, LeavesAGapForAnotherElement) {
  const Wall wall;
  const std::vector<LaidElement> laid = wall.laid(300, {84, 0});
  const std::vector<int> after =
      joints_in_rows(wall, relaxed_layout(wall.layout(), laid, {kWall.width + 84, kWall.height}));
  EXPECT_GE(*std::max_element(after.begin(), after.end()), 60);
}

TEST(LayoutRelaxation, LeavesWhatLiesAsInThePhoto) {
  const Wall wall;
  const std::vector<LaidElement> laid = wall.laid(0, {12, 20});
  const std::vector<LaidElement> after = relaxed_layout(wall.layout(), laid, {kWall.width, kWall.height});
  for (std::size_t i = 0; i < laid.size(); ++i) EXPECT_EQ(after[i].shift_px, laid[i].shift_px);
}

/// The mean step from a tile to the next one in its row, px; a step of more than half a tile leads to another row.
double mean_step_px(const std::vector<PhotoElement>& elements, const std::vector<LaidElement>& laid, cv::Size canvas) {
  const auto middle = [&](const LaidElement& e) {
    return (elements[e.element].box.tl() + elements[e.element].box.br()) / 2 + e.shift_px;
  };
  const auto wrapped = [](int d, int period) { return ((d + period / 2) % period + period) % period - period / 2; };
  double steps = 0, count = 0;
  for (const LaidElement& one : laid) {
    for (const LaidElement& other : laid) {
      const cv::Point d = middle(other) - middle(one);
      const int dx = wrapped(d.x, canvas.width), dy = wrapped(d.y, canvas.height);
      if (dx < 30 || dx > 80 || std::abs(dy) > 25) continue;
      steps += std::abs(dy);
      ++count;
    }
  }
  return steps / std::max(count, 1.);
}

TEST(LayoutRelaxation, KeepsLinesOfTiles) {
  cv::RNG random(5);
  cv::Mat map = cv::Mat::zeros(8 * 58, 5 * 58, CV_32S);
  for (int i = 0; i < 40; ++i) {
    const cv::Point jitter(random.uniform(2, 6), random.uniform(2, 6));
    map(cv::Rect(cv::Point(i % 5 * 58, i / 5 * 58) + jitter, cv::Size(50, 50))) = i + 1;
  }
  const LabelRuns labels(map);
  const std::vector<PhotoElement> elements = find_elements(labels, {}).elements;
  const PhotoLayout photo{labels, elements, label_roles(labels, elements, 0)};
  for (const cv::Size canvas : {cv::Size(8 * 58, 6 * 58), cv::Size(9 * 58, 7 * 58), cv::Size(10 * 58, 5 * 58)}) {
    const std::vector<LaidElement> laid = texture_layout(photo, canvas, 1);
    EXPECT_LE(mean_step_px(elements, relaxed_layout(photo, laid, canvas), canvas),
              mean_step_px(elements, laid, canvas) + 0.5);
  }
}

TEST(LayoutRelaxation, MovesByStepsOnly) {
  const Wall wall;
  PhotoLayout photo = wall.layout();
  photo.step_px = 3;
  const std::vector<LaidElement> laid = wall.laid(300, {15, 0});
  int moved = 0;
  for (const LaidElement& element : relaxed_layout(photo, laid, {kWall.width + 16, kWall.height})) {
    const cv::Point shift = element.shift_px;
    EXPECT_EQ(shift.x % 3, 0);
    EXPECT_EQ(shift.y % 3, 0);
    moved += shift.x != 0 && shift.x != 15;
  }
  EXPECT_GT(moved, 0);
}

TEST(LayoutRelaxation, OfNothingIsNothing) {
  const Wall wall;
  EXPECT_TRUE(relaxed_layout(wall.layout(), {}, {100, 100}).empty());
}

RC_GTEST_PROP(LayoutRelaxation, MovesNothingFar, ()) {
  const LabelRuns labels(test::random_labels({70, 60}));
  const std::vector<PhotoElement> elements = find_elements(labels, {}).elements;
  RC_PRE(!elements.empty());
  const PhotoLayout photo{labels, elements, label_roles(labels, elements, 0)};
  const cv::Size canvas(*rc::gen::inRange(24, 120), *rc::gen::inRange(24, 120));
  const std::vector<LaidElement> laid = texture_layout(photo, canvas, 1);
  const std::vector<LaidElement> after = relaxed_layout(photo, laid, canvas);
  RC_ASSERT(after.size() == laid.size());
  for (std::size_t i = 0; i < laid.size(); ++i) {
    RC_ASSERT(after[i].element == laid[i].element);
    RC_ASSERT(cv::norm(after[i].shift_px - laid[i].shift_px) <= mean_side_px(elements) + 1);
  }
}

TEST(ElementJoints, LieBetweenNeighbours) {
  cv::Mat labels = cv::Mat::zeros(40, 60, CV_32S);
  labels(cv::Rect(5, 5, 20, 30)) = 7;
  labels(cv::Rect(30, 5, 20, 30)) = 3;
  int beside = 0;
  for (const JointPlace& place : joint_places(labels, 8)) {
    EXPECT_EQ(place.first, 3);
    EXPECT_EQ(place.second, 7);
    EXPECT_GE(place.width_px, 5);
    if (place.width_px != 5) continue;
    ++beside;
    EXPECT_EQ(place.across, cv::Vec2f(-1, 0));
  }
  EXPECT_GE(beside, 30);
  EXPECT_TRUE(joint_places(labels, 4).empty());
  EXPECT_TRUE(joint_places(cv::Mat::zeros(9, 9, CV_32S), 4).empty());
}

TEST(SpringNetwork, RestsWhereAllForcesAreZero) {
  // The second point is pulled by 6 to the right; between them and a third one there are springs.
  const cv::Matx22d stiff = cv::Matx22d::eye() * 100;
  const std::vector<cv::Vec2d> ways =
      ways_at_rest({{0, 1, stiff, {-600, 0}}, {1, 2, stiff, {0, 0}}}, std::vector<cv::Vec2d>(3));
  EXPECT_NEAR(ways[1][0] - ways[0][0], 6, 0.05);
  EXPECT_NEAR(ways[2][0] - ways[1][0], 0, 0.05);
  EXPECT_NEAR(ways[0][0] + ways[1][0] + ways[2][0], 0, 0.01);
  EXPECT_NEAR(ways[1][1], 0, 1e-9);
  // A point that no spring pulls goes home.
  EXPECT_NEAR(ways_at_rest({}, {{3, -4}})[0][1], 4, 1e-6);
}

}  // namespace test_layout_relaxation
}  // namespace tessera
