// The models stored in a library file equal those computed from its shapes, however few are read.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/matching/matching_context.h"
#include "core/pad/pad_index.h"
#include "library/library_view.h"
#include "library/storage/shape_models.h"
#include "support/many_shapes.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_stored_models {

constexpr std::uint32_t kShapes = kSegmentShapes + 40;

bool same_points(std::span<const Vec2> a, std::span<const Vec2> b, std::size_t stride = 1) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); i += stride) {
    if (a[i] != b[i]) return false;
  }
  return true;
}

void expect_same_contour(const ShapeModel& a, const ShapeModel& b) {
  EXPECT_TRUE(same_points(a.boundary, b.boundary) && same_points(a.tangent, b.tangent));
  EXPECT_TRUE(same_points(a.interior, b.interior));
  EXPECT_TRUE(same_points(a.colour.at, b.colour.at));
  EXPECT_EQ(a.colour.colour, b.colour.colour);
  EXPECT_EQ(a.colour.part, b.colour.part);
}

void expect_same_sketch(const ShapeModel& a, const ShapeModel& b) {
  EXPECT_EQ(a.perimeter, b.perimeter);
  EXPECT_EQ(a.radius, b.radius);
  EXPECT_EQ(a.disc_centre, b.disc_centre);
  EXPECT_EQ(a.disc_radius, b.disc_radius);
  EXPECT_EQ(a.colour.mean, b.colour.mean);
  EXPECT_EQ(a.colour.cell, b.colour.cell);
  EXPECT_TRUE(same_points(a.boundary, b.boundary, kCoarseStride));
  EXPECT_TRUE(same_points(a.interior, b.interior, kInteriorStride));
}

/// Compares PADs with their key points, or without.
void expect_same_pads(const ShapeModel& a, const ShapeModel& b, bool keypoints) {
  ASSERT_EQ(a.levels.size(), b.levels.size());
  for (std::size_t k = 0; k < a.levels.size(); ++k) {
    ASSERT_EQ(a.levels[k].level, b.levels[k].level);
    std::vector<ModelSample> samples = a.levels[k].samples;
    std::vector<ModelSample> others = b.levels[k].samples;
    for (std::vector<ModelSample>* some : {&samples, &others}) {
      for (ModelSample& sample : *some) {
        if (!keypoints) sample.keypoint = {};
      }
    }
    EXPECT_EQ(samples, others);
  }
}

class StoredModelsTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<test::ScratchFolder>();
    test::write_many_shapes(path(), kShapes);
    context_ = make_matching_context(CollageSettings(), kShapes);
    LibraryFile library(path());
    made_ = read_models(library, {0, kShapes}, context_);
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::string path() { return folder_->path("many.h5"); }

  StoredModelsTest() : library_(path()), stored_(library_.stored_models(context_)) {}

  inline static std::unique_ptr<test::ScratchFolder> folder_;
  inline static MatchingContext context_;
  inline static std::vector<ShapeModel> made_;
  LibraryFile library_;
  std::shared_ptr<const ModelSource> stored_;
};

TEST_F(StoredModelsTest, AreThoseOfTheShapes) {
  ASSERT_NE(stored_, nullptr);
  EXPECT_TRUE(stored_->supports_random_access());
  for (const ShapeRange range : {ShapeRange{0, 3}, {kSegmentShapes - 2, kSegmentShapes + 2}, {kShapes - 1, kShapes}}) {
    const std::vector<ShapeModel> models = stored_->models(range, {});
    ASSERT_EQ(models.size(), range.size());
    for (std::uint32_t i = 0; i < range.size(); ++i) {
      const ShapeModel& made = made_[range.begin + i];
      expect_same_sketch(models[i], made);
      expect_same_contour(models[i], made);
      expect_same_pads(models[i], made, true);
    }
  }
}

TEST_F(StoredModelsTest, AreReadInParts) {
  const std::vector<ShapeModel> models = stored_->models({0, kShapes}, {.contours = false, .keypoints = false});
  for (const std::uint32_t i : {0u, 5u, kSegmentShapes - 1, kSegmentShapes, kShapes - 1}) {
    expect_same_sketch(models[i], made_[i]);
    expect_same_pads(models[i], made_[i], false);
    EXPECT_NE(models[i].tangent, made_[i].tangent) << "what was not asked for is not read";
  }
  // Some shapes follow one another. They are so many that they are read in parts, and reach from one segment into the next.
  std::vector<ShapeId> ids = {ShapeId{kShapes - 1}, ShapeId{3}, ShapeId{kSegmentShapes}, ShapeId{3}};
  for (std::uint32_t shape = kSegmentShapes - 70; shape < kSegmentShapes + 2; ++shape) ids.push_back(ShapeId{shape});
  const std::vector<ShapeModel> contours = stored_->contours(ids);
  ASSERT_EQ(contours.size(), ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) expect_same_contour(contours[i], made_[index_of(ids[i])]);
}

/// Reads PADs without key points, for ranges in any order.
TEST_F(StoredModelsTest, GivePadsAlone) {
  EXPECT_TRUE(stored_->models({0, 2}, {.contours = false, .pads = false, .keypoints = false})[1].levels.empty());
  for (const ShapeRange range : {ShapeRange{kSegmentShapes - 2, kSegmentShapes + 2}, {0, 3}, {kShapes - 1, kShapes}}) {
    std::vector<LibraryPad> expected;
    for (std::uint32_t shape = range.begin; shape < range.end; ++shape) {
      for (const ModelLevel& level : made_[shape].levels) {
        for (const ModelSample& sample : level.samples) {
          expected.push_back({sample.pad, sample.scale_length, sample.convexity});
        }
      }
    }
    EXPECT_EQ(stored_->pads(range), expected);
  }
}

TEST_F(StoredModelsTest, GiveKeyPointsOfSinglePads) {
  stored_->models({0, kShapes}, {.contours = false, .keypoints = false});
  std::vector<ModelSource::PadName> names;
  std::vector<ModelSample::Step> expected;
  for (const std::uint32_t shape : {kShapes - 1, 0u, kSegmentShapes - 1}) {
    std::uint32_t source = 0;
    for (const ModelLevel& level : made_[shape].levels) {
      for (const std::size_t j : {std::size_t(0), level.samples.size() / 2, level.samples.size() - 1}) {
        names.push_back({ShapeId{shape}, source + std::uint32_t(j)});
        const auto& points = level.samples[j].keypoint;
        expected.insert(expected.end(), points.begin(), points.begin() + 11);
      }
      source += std::uint32_t(level.samples.size());
    }
  }
  EXPECT_EQ(stored_->keypoints(names), expected);
}

/// A whole segment has the order that would be computed for it; a part of a segment has an order of its own PADs.
TEST_F(StoredModelsTest, GiveOrdersOfTheirPads) {
  for (std::size_t k = 0; k < context_.levels.size(); ++k) {
    std::vector<PadBytes> pads;
    for (std::uint32_t i = kSegmentShapes; i < kShapes; ++i) {
      for (const ModelSample& sample : made_[i].levels[k].samples) {
        pads.push_back(pad_bytes(sample.pad, sample.scale_length, sample.convexity));
      }
    }
    EXPECT_EQ(stored_->pad_order({kSegmentShapes, kShapes}, k), pad_order(pads, 8));
    const std::size_t samples = made_[0].levels[k].samples.size();
    std::vector<std::uint32_t> part = stored_->pad_order({kSegmentShapes + 7, kSegmentShapes + 18}, k);
    std::sort(part.begin(), part.end());
    std::vector<std::uint32_t> all(11 * samples);
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_EQ(part, all);
  }
}

TEST_F(StoredModelsTest, AreOfAWholeFileAndItsParametersOnly) {
  EXPECT_NE(LibraryView({{path()}, {}}).stored_models(context_), nullptr);
  EXPECT_EQ(LibraryView({{path()}, {{"shape 1*"}, {}}}).stored_models(context_), nullptr);
  MatchingContext other = context_;
  other.pad.levels = 4;
  EXPECT_EQ(library_.stored_models(other), nullptr);
}

}  // namespace test_stored_models
}  // namespace tessera
