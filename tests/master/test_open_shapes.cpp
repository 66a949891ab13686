// The shapes and sizes that are open at the moment.
#include "master/rules/open_shapes.h"

#include <gtest/gtest.h>

#include "support/synthetic_library.h"

namespace tessera::master {
namespace test_open_shapes {

constexpr std::uint32_t kShapes = 4;

const std::vector<Shape>& library() {
  static const std::vector<Shape> shapes = test::synthetic_library(int(kShapes));
  return shapes;
}

CollageSettings settings() {
  CollageSettings s;
  s.pieces.min_scale_px = 20;
  s.pieces.max_scale_px = 80;
  return s;
}

/// The open shapes, with the settings that they follow from.
struct Job {
  explicit Job(const CollageSettings& s) : context(make_matching_context(s, kShapes)), scoring(s, context.stances) {
    open_shapes.emplace(context, s.pieces, scoring, shapes, 1.f);
  }

  std::vector<ShapeId> open() const {
    std::vector<ShapeId> open;
    for (std::uint32_t i = 0; i < open_shapes->stances().open_shapes(); ++i)
      open.push_back(open_shapes->stances().open_shape(i));
    return open;
  }

  bool stand(std::uint32_t shape, float scale_px = 40) {
    scoring.count({ShapeId{shape}, {scale_px, 0, 50, 50}, 0, 0});
    return open_shapes->update({}, 1e4);
  }

  test::VectorShapes shapes{library()};
  MatchingContext context;
  Scoring scoring;
  std::optional<OpenShapes> open_shapes;
};

TEST(OpenShapes, WithoutWishesAllMayStandAndNothingIsMissing) {
  Job job(settings());
  EXPECT_EQ(job.open().size(), kShapes);
  EXPECT_FALSE(job.stand(1)) << "nothing changes";
  EXPECT_TRUE(job.open_shapes->missing().empty());
  EXPECT_EQ(job.open_shapes->shortage().pieces, 0u);
  EXPECT_TRUE(job.open_shapes->may_go_on());
}

TEST(OpenShapes, AShapeThatIsUsedUpMayNotStand) {
  CollageSettings s = settings();
  s.pieces.uses = 1;
  Job job(s);
  const std::uint64_t version = job.open_shapes->version();
  EXPECT_TRUE(job.stand(1));
  EXPECT_NE(job.open_shapes->version(), version);
  EXPECT_EQ(job.open(), (std::vector{ShapeId{0}, ShapeId{2}, ShapeId{3}}));
  EXPECT_EQ(job.open_shapes->limits().used_up, std::vector{ShapeId{1}});
  for (const std::uint32_t shape : {0u, 2u, 3u}) {
    EXPECT_TRUE(job.open_shapes->may_go_on());
    job.stand(shape);
  }
  EXPECT_FALSE(job.open_shapes->may_go_on());
  job.scoring.forget_placements();
  EXPECT_TRUE(job.open_shapes->update({}, 1e4)) << "it follows from what stands now";
  EXPECT_EQ(job.open().size(), kShapes);
}

TEST(OpenShapes, OtherShapesWaitForThoseThatAreMissing) {
  CollageSettings s = settings();
  s.pieces.least_uses = 1;
  Job job(s);
  EXPECT_EQ(job.open_shapes->missing().size(), kShapes);
  EXPECT_TRUE(job.stand(2));
  EXPECT_EQ(job.open(), (std::vector{ShapeId{0}, ShapeId{1}, ShapeId{3}}));
  const Shortage shortage = job.open_shapes->shortage();
  EXPECT_EQ(shortage.pieces, 3u);
  EXPECT_DOUBLE_EQ(shortage.placed, 0.25);
  for (const std::uint32_t shape : {0u, 1u, 3u}) job.stand(shape);
  EXPECT_EQ(job.open().size(), kShapes) << "all stand: any may come in again";
}

/// The loop does not wait for a shape that finds no place.
TEST(OpenShapes, AShapeThatIsShutOutMayNotStandAndIsNotWaitedFor) {
  CollageSettings s = settings();
  s.pieces.least_uses = 1;
  Job job(s);
  for (const std::uint32_t shape : {0u, 1u, 2u}) job.stand(shape);
  EXPECT_EQ(job.open(), std::vector{ShapeId{3}});
  EXPECT_TRUE(job.open_shapes->update({ShapeId{3}}, 1e4));
  EXPECT_EQ(job.open(), (std::vector{ShapeId{0}, ShapeId{1}, ShapeId{2}}));
}

/// With fit = "all", pieces leave room for the missing ones.
TEST(OpenShapes, MissingPiecesLimitTheSizes) {
  CollageSettings s = settings();
  s.pieces.fit_all = true;
  s.pieces.uses = 1;
  Job job(s);
  const auto most_scale_px = [&](double free_px2) {
    job.open_shapes->update({}, free_px2);
    return job.open_shapes->limits().most_scale_px;
  };
  const float little = most_scale_px(3000);
  EXPECT_LT(little, most_scale_px(9000));
  most_scale_px(3000);
  Candidate candidate;
  candidate.shape = ShapeId{1};
  candidate.canvas_from_shape = {0.99f * little, 0, 50, 50};
  EXPECT_TRUE(job.open_shapes->allows(candidate));
  candidate.canvas_from_shape.a = 1.01f * little;
  EXPECT_FALSE(job.open_shapes->allows(candidate));
}

TEST(OpenShapes, ARegionBeginsWithItsOwnStances) {
  CollageSettings s = settings();
  s.pieces.uses = 1;
  Job job(s);
  job.stand(1);
  job.open_shapes->begin(0, 3);
  EXPECT_EQ(job.open_shapes->given(), 3u);
  EXPECT_EQ(job.open().size(), kShapes) << "until update() says what stands";
}

TEST(OpenShapes, APieceMayHaveThePosesOfItsStanceOrItsOwn) {
  const Job job(settings());
  const PoseRange within = job.open_shapes->poses_of({ShapeId{0}, {40, 0, 50, 50}, 0, 0});
  EXPECT_FLOAT_EQ(within.min_scale_px, 20);
  EXPECT_FLOAT_EQ(within.max_scale_px, 80);
  const PoseRange rounded = job.open_shapes->poses_of({ShapeId{0}, {80.0005f, 0, 50, 50}, 0, 0});
  EXPECT_FLOAT_EQ(rounded.max_scale_px, 80) << "results have poses to three decimals";
  const PoseRange own = job.open_shapes->poses_of({ShapeId{0}, {100, 0, 50, 50}, 0, 0});
  EXPECT_EQ(own.min_scale_px, 100);
  EXPECT_EQ(own.max_scale_px, 100);
}

}  // namespace test_open_shapes
}  // namespace tessera::master
