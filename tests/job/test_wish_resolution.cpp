// The resolution of names in a job's tables to classes of shapes and regions.
#include "job/pieces/wish_resolution.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/processor_time.h"
#include "job/pieces/shape_group.h"
#include "support/input_error.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_wish_resolution {

const std::vector<NamedShape> kShapes = {{"cat", 40}, {"cow", 80}, {"owl"}, {"owl_2", 1.5f}};

class WishResolution : public testing::Test {
 protected:
  Job resolved(const std::string& tables, const std::vector<NamedShape>& shapes = kShapes) {
    const std::string job_text = "[library]\nfile = 'x.h5'\n[canvas]\nfile = 'c.svg'\n[pieces]\nscale_px = [30, 50]\n";
    Job job = load_job(folder_.write("job.toml", job_text + tables), {});
    resolve_wishes(shapes, job);
    return job;
  }

  std::string mistake(const std::string& tables, const std::vector<NamedShape>& shapes = kShapes) {
    try {
      resolved(tables, shapes);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no mistake";
  }

  test::ScratchFolder folder_;
};

TEST_F(WishResolution, WithoutTablesThereAreNoWishes) {
  const Job job = resolved("");
  EXPECT_EQ(job.settings.wishes, Wishes{});
  EXPECT_FALSE(has_shape_wishes(job));
}

TEST_F(WishResolution, LaterTablesWinKeyByKey) {
  const Wishes wishes = resolved(
                            "[[shapes]]\nnames = 'o*'\nweight = 2\nuses = 5\n"
                            "[[shapes]]\nnames = ['owl', 'cat']\nuses = [0, 1]\nrotation_deg = 90\n")
                            .settings.wishes;
  ASSERT_EQ(wishes.class_of_shape.size(), 4u);
  const auto of = [&](std::size_t shape) { return wishes.classes[wishes.class_of_shape[shape]]; };
  EXPECT_EQ(of(0).weight, 1);
  EXPECT_EQ(of(0).uses, 1);
  EXPECT_EQ(of(1), ShapeWish{}) << "no table is about the cow";
  EXPECT_EQ(of(2).weight, 2);
  EXPECT_EQ(of(2).uses, 1);
  ASSERT_EQ(of(2).poses.rotation_rad.size(), 1u);
  EXPECT_FLOAT_EQ(of(2).poses.rotation_rad[0].max, 1.5707963f);
  EXPECT_EQ(of(3).uses, 5);
  EXPECT_TRUE(of(3).poses.rotation_rad.empty());
}

/// start.not_anew wins over other wishes for a shape, and takes names instead of patterns.
TEST_F(WishResolution, WhatIsNotToComeInHasNoWeight) {
  const std::string start = "[start]\npieces = 'old'\nnot_anew = ['owl']\n";
  const Job job = resolved(start + "[[shapes]]\nnames = 'o*'\nweight = 2\n");
  EXPECT_TRUE(has_shape_wishes(job));
  const Wishes& wishes = job.settings.wishes;
  ASSERT_EQ(wishes.class_of_shape.size(), 4u);
  const auto weight = [&](std::size_t shape) { return wishes.classes[wishes.class_of_shape[shape]].weight; };
  EXPECT_EQ(weight(0), 1);
  EXPECT_EQ(weight(2), 0);
  EXPECT_EQ(weight(3), 2);
  EXPECT_TRUE(has_shape_wishes(resolved(start)));
  EXPECT_NE(mistake("[start]\nnot_anew = ['o*']\n").find("start.not_anew: the library has no shape \"o*\""),
            std::string::npos);
}

/// A shape's class follows from all tables about it, in their order.
TEST_F(WishResolution, ClassesAreOfTheShapesThatTheSameTablesAreAbout) {
  const std::vector<std::vector<std::string>> names = {{"*"}, {"owl*"}, {"cat", "owl"}, {"c*"}, {"owl_2"}, {"?o?"}};
  std::string tables;
  for (std::size_t row = 0; row < names.size(); ++row) {
    tables += "[[shapes]]\nnames = [";
    for (const std::string& name : names[row]) tables += "'" + name + "',";
    tables += "]\n" + std::string(row % 2 ? "weight" : "uses") + " = " + std::to_string(row + 1) + "\n";
  }
  const Wishes wishes = resolved(tables).settings.wishes;
  EXPECT_EQ(wishes.class_of_shape, (std::vector<std::uint32_t>{0, 1, 2, 3})) << "numbered as the library has them";
  const auto expect = [&](std::size_t shape, float weight, int uses) {
    EXPECT_EQ(wishes.classes.at(shape).weight, weight) << shape;
    EXPECT_EQ(wishes.classes.at(shape).uses, uses) << shape;
  };
  expect(0, 4, 3);
  expect(1, 6, 1);
  expect(2, 2, 3);
  expect(3, 2, 5);
}

TEST_F(WishResolution, ThousandsOfTablesAboutThousandsOfShapesTakeNoTime) {
  std::vector<NamedShape> shapes;
  Job job;
  for (int i = 0; i < 10'000; ++i) {
    shapes.push_back({"shape_" + std::to_string(i), float(20 + i % 2)});
    for (const std::string& name : {shapes.back().name, std::string("*")}) {
      JobRow row;
      row["names"].texts = {name};
      row["weight"].numbers = {double(i % 7)};
      if (name != "*" || i % 100 == 0) job.tables["shapes"].push_back(row);
    }
  }
  const double before_s = processor_time_s();
  resolve_wishes(shapes, job);
  EXPECT_LT(processor_time_s() - before_s, 4) << "tables times shapes: 10 s";
  const Wishes& wishes = job.settings.wishes;
  ASSERT_EQ(wishes.classes.size(), shapes.size());
  for (std::uint32_t i = 0; i < shapes.size(); ++i) ASSERT_EQ(wishes.class_of_shape[i], i);
  EXPECT_EQ(wishes.classes[9'999].weight, 9'999 % 7);
  EXPECT_EQ(wishes.classes[5].weight, 9'900 % 7) << "a later table about all";
}

TEST_F(WishResolution, SizesOfShapesAndRegionsWidenTheRange) {
  const Job job = resolved(
      "[[shapes]]\nnames = 'cat'\nscale_px = [60, 200]\n[[regions]]\nname = 'sea'\ncolour = '#0000ff'\nscale_px = "
      "10\n");
  EXPECT_EQ(job.settings.pieces.min_scale_px, 10);
  EXPECT_EQ(job.settings.pieces.max_scale_px, 200);
  EXPECT_EQ(job.settings.pieces.poses().scale_px, (std::vector<Interval>{{30, 50}})) << "of all others";
  EXPECT_NE(to_toml(job).find("scale_px = [30, 50]"), std::string::npos) << to_toml(job);
}

TEST_F(WishResolution, ShapesNameRegions) {
  const Wishes wishes = resolved(
                            "[[regions]]\nname = 'sea'\ncolour = '#0000ff'\n[[regions]]\nname = 'land'\ncolour = "
                            "'#00ff00'\nrotation_deg = 0\n[[shapes]]\nnames = 'owl*'\nregions = 'land'\n")
                            .settings.wishes;
  EXPECT_EQ(wishes.classes[wishes.class_of_shape[3]].in_region, (std::vector<std::uint8_t>{0, 1}));
  EXPECT_TRUE(wishes.classes[wishes.class_of_shape[0]].in_region.empty());
  ASSERT_EQ(wishes.regions.size(), 2u);
  EXPECT_EQ(wishes.regions[1].poses.rotation_rad.size(), 1u);
}

TEST_F(WishResolution, DrawnSizesAreThoseOfTheDrawings) {
  const Job job = resolved(
      "sizes = 'drawn'\n[[shapes]]\nnames = 'owl*'\nscale_px = [50, 60]\n[[shapes]]\nnames = 'cow'\nuses = 2\n");
  const Wishes& wishes = job.settings.wishes;
  const auto sizes = [&](std::size_t shape) { return wishes.classes[wishes.class_of_shape[shape]].poses.scale_px; };
  EXPECT_EQ(sizes(0), (std::vector<Interval>{{40, 40}}));
  EXPECT_EQ(sizes(1), (std::vector<Interval>{{80, 80}}));
  EXPECT_EQ(sizes(2), (std::vector<Interval>{{50, 60}})) << "a table says another, and asks no drawing";
  EXPECT_EQ(wishes.classes[wishes.class_of_shape[1]].uses, 2);
  EXPECT_EQ(job.settings.pieces.min_scale_px, 40);
  EXPECT_EQ(job.settings.pieces.max_scale_px, 80);
}

TEST_F(WishResolution, DrawnSizesThatAreUnknownOrTooSmallAreTold) {
  EXPECT_NE(
      mistake("sizes = 'drawn'\nfit = 'all'").find("pieces.sizes: found \"drawn\", but the shape \"owl\" does not say"),
      std::string::npos);
  const std::string but_owl = "[[shapes]]\nnames = 'owl'\nweight = 0\n";
  EXPECT_NE(mistake("sizes = 'drawn'\n" + but_owl).find("\"owl_2\" was drawn at 1.5 px, allowed: 2 to 5000 px"),
            std::string::npos);
  EXPECT_EQ(mistake("sizes = 'drawn'\nfit = 'all'\n" + but_owl), "no mistake") << "sizes count against each other";
}

TEST_F(WishResolution, ATableWithADistanceMakesACompany) {
  const Wishes wishes = resolved(
                            "[[shapes]]\nnames = '*'\napart_px = 50\n[[shapes]]\nnames = 'owl*'\napart_px = 120\n"
                            "[[shapes]]\nnames = 'owl'\nweight = 2\n")
                            .settings.wishes;
  const auto of = [&](std::size_t shape) { return wishes.classes[wishes.class_of_shape[shape]].apart.value(); };
  EXPECT_EQ(of(0), of(1));
  EXPECT_EQ(of(0).distance_px, 50);
  EXPECT_EQ(of(2), of(3)) << "of the same company, though not of the same class";
  EXPECT_EQ(of(2).distance_px, 120);
  EXPECT_NE(of(2).company, of(0).company);
}

TEST_F(WishResolution, TheLastTableThatNamesAGroupHolds) {
  const Job job = resolved(
      "[[shapes]]\nnames = '*'\ngroup = 'animals'\n[[shapes]]\nnames = 'owl*'\ngroup = 'birds'\n"
      "[[shapes]]\nnames = 'owl'\nweight = 2\n");
  EXPECT_EQ(shape_groups(job, {"owl", "cat"}), (std::vector<std::string>{"birds", "animals"}));
  EXPECT_EQ(shape_groups(resolved(""), {"owl"}), (std::vector<std::string>{""}));
}

/// Styles that differ in bits of the palette; each bit is a distance of 1.
std::vector<NamedShape> styled_shapes() {
  std::vector<NamedShape> shapes = kShapes;
  const float bits[] = {1, 2, 3.1f, 1.1f};
  for (std::size_t i = 0; i < shapes.size(); ++i) shapes[i].style.palette = bits[i];
  return shapes;
}

std::vector<float> weights(const Job& job) {
  std::vector<float> weights;
  for (const std::uint32_t of : job.settings.wishes.class_of_shape)
    weights.push_back(job.settings.wishes.classes[of].weight);
  return weights;
}

TEST_F(WishResolution, DrawingsOfAnotherStyleAreWishedForLess) {
  using Weights = std::vector<float>;
  EXPECT_EQ(weights(resolved("[style]\nlike = 'cat'", styled_shapes())), (Weights{1, 0.5f, 0.25f, 1}));
  EXPECT_EQ(weights(resolved("[style]\nlike = 'cat'\nweight = 2", styled_shapes())), (Weights{1, 0.25f, 0.0625f, 1}));
  EXPECT_EQ(weights(resolved("[style]\nlike = 'cow'\n[[shapes]]\nnames = 'cat'\nweight = 4", styled_shapes())),
            (Weights{2, 1, 0.5f, 0.5f}))
      << "both weights hold";
  EXPECT_EQ(weights(resolved("[style]\nlike = ['cat', 'owl_2']", styled_shapes()))[0], 1) << "near their mean";
  EXPECT_EQ(weights(resolved("[style]\nlike = 'auto'", styled_shapes())), (Weights{1, 0.5f, 0.25f, 1}))
      << "of groups of one drawing each the plainest prevails";
}

TEST_F(WishResolution, WithoutWeightStylesAreNoWish) {
  const Job job = resolved("[style]\nlike = 'cat'\nweight = 0", styled_shapes());
  EXPECT_EQ(job.settings.wishes, Wishes{});
  EXPECT_FALSE(has_shape_wishes(job));
}

TEST_F(WishResolution, StylesThatAreNotKnownAreTold) {
  EXPECT_NE(mistake("[style]\nlike = 'cat'").find("style.like: the library does not know the style of cat"),
            std::string::npos);
  EXPECT_NE(mistake("[style]\nlike = 'owls'", styled_shapes()).find("near it are: owl,"), std::string::npos);
}

TEST_F(WishResolution, GivenPiecesHaveTheirPose) {
  const Wishes wishes =
      resolved("[[given]]\nshape = 'owl'\nat_px = [100, -5]\nscale_px = 300\nrotation_deg = 90\n").settings.wishes;
  ASSERT_EQ(wishes.given.size(), 1u);
  EXPECT_EQ(wishes.given[0].shape, ShapeId{2});
  const Similarity& pose = wishes.given[0].canvas_from_shape;
  EXPECT_NEAR(pose.a, 0, 1e-4);
  EXPECT_FLOAT_EQ(pose.b, 300);
  EXPECT_EQ(pose.translation(), (Vec2{100, -5}));
}

TEST_F(WishResolution, NamesThatThereAreNotAreTold) {
  EXPECT_NE(mistake("[[shapes]]\nnames = 'owls'")
                .find("[[shapes]] names: no shape of the library has a name like "
                      "\"owls\"; near it are: owl,"),
            std::string::npos)
      << mistake("[[shapes]]\nnames = 'owls'");
  EXPECT_NE(mistake("[[given]]\nshape = 'owls'\nat_px = [1, 2]\nscale_px = 30").find("(did you mean \"owl\"?)"),
            std::string::npos);
  EXPECT_NE(mistake("[[shapes]]\nnames = 'cat'\nregions = 'sea'").find("no [[regions]] with the name \"sea\""),
            std::string::npos);
  const std::string region = "[[regions]]\nname = 'sea'\ncolour = '#0000ff'\n";
  EXPECT_NE(mistake(region + region).find("two with the name \"sea\""), std::string::npos);
  EXPECT_NE(mistake("fit = 'all'\n" + region).find("pieces.fit: found \"all\" where there are [[regions]]"),
            std::string::npos);
}

/// The table names shapes that the job left out.
TEST_F(WishResolution, AWishForAShapeThatWasLeftOutGoesToNoOther) {
  Job job = resolved("[[shapes]]\nnames = 'c[ao]?'\nuses = 9\ngroup = 'them'\n");
  EXPECT_EQ(job.settings.wishes.classes[job.settings.wishes.class_of_shape[0]].uses, 9);
  const std::string message = test::message_of([&] { resolve_wishes(kShapes, job, {"c[ao]?"}); });
  EXPECT_NE(message.find("[[shapes]] names: no shape of the library has a name like \"c[ao]?\""), std::string::npos)
      << message;
  EXPECT_EQ(shape_groups(job, {"cat", "owl"}), (std::vector<std::string>{"them", ""}));
  EXPECT_EQ(shape_groups(job, {"cat", "owl"}, {"c[ao]?"}), (std::vector<std::string>{"", ""}));
}

}  // namespace test_wish_resolution
}  // namespace tessera
