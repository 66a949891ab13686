// Damaged, forged or foreign models in a library file are reported or made again; no other file is opened.
#include <gtest/gtest.h>
#include <hdf5.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "core/matching/matching_context.h"
#include "library/hdf5/hdf5_handles.h"
#include "library/storage/segment_bytes.h"
#include "library/storage/segment_columns.h"
#include "library/storage/shape_models.h"
#include "support/many_shapes.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_damaged_models {

/// A small library that the tests damage.
class DamagedModels : public testing::Test {
 protected:
  static constexpr std::uint32_t kFew = 7;

  DamagedModels() : path_(folder_.path("few.h5")) {
    test::write_many_shapes(path_, kFew);
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

  /// Reads everything that a matcher asks for.
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
  flip(level.pads_at + 3 * level.pads_row + 9);
  flip(layout_.contours_at + 4 * SegmentLayout::kContourBytes);
  EXPECT_THROW(stored->keypoints(std::span(&pad, 1)), InputError);
  EXPECT_THROW(stored->contours(std::span(&shape, 1)), InputError);
  EXPECT_FALSE(stored->pads({0, 3}).empty());
  EXPECT_THROW(stored->pads({3, 4}), InputError);
}

/// The rows are valid, but belong to another shape.
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

/// Forged rows with valid digests, which anyone can compute.
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

  /// Reads the file after `forge` changed the model of a shape, and expects a refusal.
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

/// An index has no room for additional bits.
TEST_F(ForgedModels, WithMoreBitsThanALibraryKeepsAreTold) {
  const auto level = std::size_t(context_.levels[0]);
  expect_refused("PADs", [&](ShapeModel& model) { model.levels[level].samples[5].pad.element[2] ^= 1; });
  expect_refused("PADs", [&](ShapeModel& model) { model.levels[level].samples[5].scale_length *= 1 + 1.f / 1024; });
}

/// Any column may have changed since. Models made for a choice of all shapes must not differ.
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

/// The file that was opened and checked is read, even if its name leads to another file since.
TEST_F(DamagedModels, AreNotThoseOfAFileThatCameLater) {
  const LibraryFile library(path_);
  test::write_many_shapes(folder_.path("later.h5"), kFew + 20);
  std::filesystem::rename(folder_.path("later.h5"), path_);
  const auto stored = library.stored_models(context_);
  ASSERT_NE(stored, nullptr);
  EXPECT_EQ(stored->models({0, kFew}, {}).size(), kFew);
}

/// Links would open other files or wait for a pipe.
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
  EXPECT_FALSE(models_of(library, context_)->supports_random_access());
}

}  // namespace test_damaged_models
}  // namespace tessera
