// The models that a library file holds are those that its shapes give, however few are read; damage is told.
#include <gtest/gtest.h>
#include <hdf5.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>

#include "core/base/error.h"
#include "core/matching/matching_context.h"
#include "io/library/hdf5_handles.h"
#include "io/library/library_file.h"
#include "io/library/library_view.h"
#include "io/library/segment_bytes.h"
#include "io/library/segment_columns.h"
#include "io/library/shape_models.h"
#include "io/scratch_folder.h"
#include "support/matching_scene.h"

namespace tessera::io {
namespace {

constexpr std::uint32_t kShapes = kSegmentShapes + 40;

/// Some outlines again and again, with other lengths.
void write_library(const std::string& path, std::uint32_t count) {
  const std::vector<Shape> some = test::formula_shapes(6, PadParameters());
  LibraryWriter writer(path, PadParameters());
  for (std::uint32_t i = 0; i < count; ++i) {
    Shape shape = some[i % some.size()];
    shape.name = "shape " + std::to_string(i);
    shape.artwork.width_px = shape.artwork.height_px = 600;
    shape.mean_lab = {50, 10, -20};
    shape.perimeter *= 1 + float(i) / float(count);  // tells the models apart
    writer.append(shape);
  }
  writer.finish();
}

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

/// With their key points, or without.
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
    write_library(path(), kShapes);
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
  EXPECT_TRUE(stored_->reads_singly());
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
  const std::vector<ShapeId> ids = {ShapeId{kShapes - 1}, ShapeId{3}, ShapeId{kSegmentShapes}, ShapeId{3}};
  const std::vector<ShapeModel> contours = stored_->contours(ids);
  ASSERT_EQ(contours.size(), ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) expect_same_contour(contours[i], made_[index_of(ids[i])]);
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

/// Of a whole segment as it would be made; of a part of one an order of that part.
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

/// A small library, to be damaged.
class DamagedModels : public testing::Test {
 protected:
  static constexpr std::uint32_t kFew = 7;

  DamagedModels() : path_(folder_.path("few.h5")) {
    write_library(path_, kFew);
    context_ = make_matching_context(CollageSettings(), kFew);
    layout_ = SegmentLayout(library_segments(PadParameters()), kFew);
    const Hdf5Handle file(H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "file");
    begin_ = segment_places(file.get(), PadParameters(), kFew).begins.at(0);
  }

  void flip(std::size_t at) {
    std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(std::streamoff(begin_ + at));
    const char byte = char(file.get());
    file.seekp(std::streamoff(begin_ + at));
    file.put(char(byte ^ 0x10));
  }

  /// All that a matcher asks for.
  void read_everything() const {
    const LibraryFile library(path_);
    const auto stored = library.stored_models(context_);
    ASSERT_NE(stored, nullptr);
    stored->models({0, kFew}, {});
    for (std::size_t k = 0; k < context_.levels.size(); ++k) stored->pad_order({0, kFew}, k);
  }

  void expect_damage(const std::string& what) const {
    try {
      read_everything();
      FAIL() << "not told: " << what;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(path_), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  }

  test::ScratchFolder folder_;
  std::string path_;
  MatchingContext context_;
  SegmentLayout layout_{{}, 0};
  std::uint64_t begin_ = 0;
};

TEST_F(DamagedModels, AreTold) {
  const LevelSection& level = layout_.levels[std::size_t(context_.levels[0])];
  const std::pair<std::size_t, std::string> places[] = {{layout_.sketches_at + 8, "a sketch"},
                                                        {layout_.contours_at + 4711, "a contour"},
                                                        {level.pads_at + level.pads_row - 30, "PADs"},
                                                        {level.keypoints_at + 5 * level.keypoints_row, "key points"},
                                                        {level.order_at + 40, "an order of PADs"}};
  read_everything();
  for (const auto& [at, what] : places) {
    flip(at);
    expect_damage(what);
    flip(at);
  }
  read_everything();
}

TEST_F(DamagedModels, OfSinglePadsAndShapesAreTold) {
  const LibraryFile library(path_);
  const auto stored = library.stored_models(context_);
  stored->models({0, kFew}, {.contours = false, .keypoints = false});
  const LevelSection& level = layout_.levels[std::size_t(context_.levels[0])];
  const ModelSource::PadName pad{ShapeId{2}, 3};
  const ShapeId shape{4};
  EXPECT_FALSE(stored->keypoints(std::span(&pad, 1)).empty());
  flip(level.keypoints_at + (2 * level.samples + 3) * level.keypoints_row + 1);
  flip(layout_.contours_at + 4 * SegmentLayout::kContourBytes);
  EXPECT_THROW(stored->keypoints(std::span(&pad, 1)), InputError);
  EXPECT_THROW(stored->contours(std::span(&shape, 1)), InputError);
}

/// Rows that are right, but of another shape.
TEST_F(DamagedModels, InWrongPlacesAreTold) {
  std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
  std::vector<char> row(SegmentLayout::kContourBytes);
  file.seekg(std::streamoff(begin_ + layout_.contours_at));
  file.read(row.data(), std::streamsize(row.size()));
  file.seekp(std::streamoff(begin_ + layout_.contours_at + row.size()));
  file.write(row.data(), std::streamsize(row.size()));
  file.close();
  expect_damage("a contour");
}

/// Rows of which the digests are right: anyone can compute them.
class ForgedModels : public DamagedModels {
 protected:
  ForgedModels() {
    LibraryFile library(path_);
    const std::vector<ShapeHead> heads = library.heads(0, kFew);
    const std::vector<Shape> shapes = library.read(0, kFew, {});
    for (std::size_t i = 0; i < kFew; ++i) {
      owners_.push_back(segment_owner(shapes[i], heads[i].part_digest));
      models_.push_back(
          make_shape_model(shapes[i], PadParameters(), PadParameters(), library_segments(PadParameters()).levels));
    }
  }

  /// Reads the file with what `forge` makes of a shape's model.
  template <class Forge>
  void expect_refused(const std::string& what, Forge&& forge) {
    std::vector<ShapeModel> forged = models_;
    forge(forged[3]);
    write(forged);
    expect_damage(what);
  }

  void write(const std::vector<ShapeModel>& models) const {
    const std::vector<std::uint8_t> bytes = segment_bytes(library_segments(PadParameters()), models, owners_);
    std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(std::streamoff(begin_));
    file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  }

  std::vector<SegmentOwner> owners_;
  std::vector<ShapeModel> models_;
};

TEST_F(ForgedModels, OfNumbersThatNoModelHasAreTold) {
  write(models_);
  read_everything();
  constexpr float kHuge = 1e9f;
  const float nan = std::nanf("");
  const auto level = std::size_t(context_.levels[0]);
  expect_refused("a sketch", [&](ShapeModel& model) { model.perimeter = nan; });
  expect_refused("a sketch", [&](ShapeModel& model) { model.radius = -1; });
  expect_refused("a sketch", [&](ShapeModel& model) { model.disc_radius = kHuge; });
  expect_refused("a sketch", [&](ShapeModel& model) { model.disc_centre.x = nan; });
  expect_refused("a sketch", [&](ShapeModel& model) { model.colour.cell = nan; });
  expect_refused("a sketch", [&](ShapeModel& model) { model.colour.mean.a = kHuge; });
  expect_refused("a sketch", [&](ShapeModel& model) { model.boundary[kCoarseStride].y = kHuge; });
  expect_refused("a contour", [&](ShapeModel& model) { model.boundary[1].y = kHuge; });
  expect_refused("a contour", [&](ShapeModel& model) { model.tangent[7].x = nan; });
  expect_refused("a contour", [&](ShapeModel& model) { model.colour.at[2].x = nan; });
  expect_refused("a contour", [&](ShapeModel& model) { model.colour.colour[2].lightness = nan; });
  expect_refused("a contour", [&](ShapeModel& model) { model.colour.part[2] = 1.5f; });
  expect_refused("PADs", [&](ShapeModel& model) { model.levels[level].samples[5].scale_length = nan; });
  expect_refused("PADs", [&](ShapeModel& model) { model.levels[level].samples[5].scale_length = 0; });
  write(models_);
  read_everything();
}

/// An index has no room for them.
TEST_F(ForgedModels, WithMoreBitsThanALibraryKeepsAreTold) {
  const auto level = std::size_t(context_.levels[0]);
  expect_refused("PADs", [&](ShapeModel& model) { model.levels[level].samples[5].pad.element[2] ^= 1; });
  expect_refused("PADs", [&](ShapeModel& model) { model.levels[level].samples[5].scale_length *= 1 + 1.f / 1024; });
}

/// Whatever column it is that was changed since: a choice of all shapes, of which models are made, must not differ.
TEST_F(DamagedModels, OfOtherLengthsAndColoursAreTold) {
  const auto scale_third = [&](const char* column, hid_t type, auto factor) {
    const Hdf5Handle file(H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "file");
    const Hdf5Handle set(H5Dopen2(file.get(), column, H5P_DEFAULT), column);
    const Hdf5Handle space(H5Dget_space(set.get()), column);
    std::vector<decltype(factor)> numbers(std::size_t(H5Sget_simple_extent_npoints(space.get())));
    ASSERT_GE(H5Dread(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()), 0);
    numbers[2] = decltype(factor)(numbers[2] * factor);
    ASSERT_GE(H5Dwrite(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()), 0);
  };
  for (const char* column : {"/shapes/perimeter", "/shapes/radius", "/shapes/mean_lab"}) {
    SCOPED_TRACE(column);
    scale_third(column, H5T_NATIVE_FLOAT, 2.f);
    expect_damage("a sketch");
    scale_third(column, H5T_NATIVE_FLOAT, 0.5f);
    read_everything();
  }
  scale_third("/shapes/colour_grid", H5T_NATIVE_UINT8, std::uint8_t(3));
  expect_damage("a sketch");
}

/// The file that was opened and checked is read, not what its name leads to since.
TEST_F(DamagedModels, AreNotThoseOfAFileThatCameLater) {
  const LibraryFile library(path_);
  write_library(folder_.path("later.h5"), kFew + 20);
  std::filesystem::rename(folder_.path("later.h5"), path_);
  const auto stored = library.stored_models(context_);
  ASSERT_NE(stored, nullptr);
  EXPECT_EQ(stored->models({0, kFew}, {}).size(), kFew);
}

/// Opening them would open other files, or wait for a pipe.
TEST_F(DamagedModels, ThatAreLinksAreTold) {
  {
    const Hdf5Handle file(H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "file");
    ASSERT_GE(H5Ldelete(file.get(), "/models/segment_00000", H5P_DEFAULT), 0);
    ASSERT_GE(H5Lcreate_external("/dev/null", "/x", file.get(), "/models/segment_00000", H5P_DEFAULT, H5P_DEFAULT), 0);
  }
  expect_damage("data set /models/segment_00000 is only a link");
}

TEST_F(DamagedModels, ThatAreInAGroupElsewhereAreTold) {
  {
    const Hdf5Handle file(H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "file");
    ASSERT_GE(H5Lmove(file.get(), "/models", file.get(), "/others", H5P_DEFAULT, H5P_DEFAULT), 0);
    ASSERT_GE(H5Lcreate_soft("/others", file.get(), "/models", H5P_DEFAULT, H5P_DEFAULT), 0);
  }
  expect_damage("group /models is only a link");
}

TEST_F(DamagedModels, InPiecesOrOfAnotherLengthAreTold) {
  const auto replace = [&](bool chunked) {
    const Hdf5Handle file(H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "file");
    ASSERT_GE(H5Ldelete(file.get(), "/models/segment_00000", H5P_DEFAULT), 0);
    const hsize_t size = layout_.bytes - (chunked ? 0 : 1);
    const hsize_t chunk = 4096;
    const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), "properties");
    if (chunked) H5Pset_chunk(properties.get(), 1, &chunk);
    const Hdf5Handle space(H5Screate_simple(1, &size, nullptr), "space");
    const Hdf5Handle set(H5Dcreate2(file.get(), "/models/segment_00000", H5T_STD_U8LE, space.get(), H5P_DEFAULT,
                                    properties.get(), H5P_DEFAULT),
                         "set");
    const std::vector<std::uint8_t> zeros(size);
    ASSERT_GE(H5Dwrite(set.get(), H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data()), 0);
  };
  replace(true);
  expect_damage("is not in one piece");
  replace(false);
  expect_damage("not as many bytes");
}

TEST_F(DamagedModels, OfOtherVersionsAreMadeAnew) {
  {
    const Hdf5Handle file(H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "file");
    ASSERT_GE(H5Adelete_by_name(file.get(), "/models", "version", H5P_DEFAULT), 0);
    const Hdf5Handle space(H5Screate(H5S_SCALAR), "space");
    const Hdf5Handle group(H5Gopen2(file.get(), "/models", H5P_DEFAULT), "group");
    const Hdf5Handle attribute(H5Acreate2(group.get(), "version", H5T_STD_I32LE, space.get(), H5P_DEFAULT, H5P_DEFAULT),
                               "attribute");
    const int version = 1000;
    ASSERT_GE(H5Awrite(attribute.get(), H5T_NATIVE_INT, &version), 0);
  }
  const LibraryFile library(path_);
  EXPECT_EQ(library.stored_models(context_), nullptr);
  EXPECT_EQ(models_of(library, context_)->models({0, kFew}, {}).size(), kFew);
}

TEST_F(DamagedModels, ThatAreMissingAreMadeAnew) {
  {
    const Hdf5Handle file(H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "file");
    ASSERT_GE(H5Ldelete(file.get(), "/models", H5P_DEFAULT), 0);
  }
  const LibraryFile library(path_);
  EXPECT_EQ(library.stored_models(context_), nullptr);
  EXPECT_FALSE(models_of(library, context_)->reads_singly());
}

}  // namespace
}  // namespace tessera::io
