// Harmful libraries. The program refuses each with its name, or reads it as before; without a crash, a hang, or more than 1 GB.
// No shape gets a field that is not its outline's.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

#include "core/base/error.h"
#include "core/base/rank_pool.h"
#include "core/shape/shape_contradiction.h"
#include "core/shape/shape_field.h"
#include "forged_library.h"
#include "hdf5_metadata.h"
#include "library/library_shapes.h"
#include "library/storage/library_file.h"
#include "library_surgery.h"
#include "render/pieces/artwork_original.h"
#include "support/hostile_file.h"
#include "support/images.h"
#include "support/scratch_folder.h"
#include "support/synthetic_library.h"

namespace tessera {
namespace test_hostile_library {

using test::ScratchFolder;

const LibraryParts kEverything{
    .outline = true, .field = true, .levels = ~0u, .artwork = true, .original = true, .surroundings = true};

std::vector<std::uint8_t> small_png(int side_px) {
  const std::vector<std::uint8_t> png =
      test::encoded(cv::Mat(side_px, side_px, CV_8UC4, cv::Scalar(10, 200, 30, 255)), ".png");
  return png;
}

bool same(const Shape& a, const Shape& b) {
  for (std::size_t k = 0; k < a.levels.size(); ++k) {
    if (a.levels[k].points != b.levels[k].points || a.levels[k].samples != b.levels[k].samples ||
        a.levels[k].perimeter != b.levels[k].perimeter)
      return false;
  }
  return a.name == b.name && a.outline == b.outline && a.perimeter == b.perimeter && a.radius == b.radius &&
         a.mean_lab == b.mean_lab && a.field.extent == b.field.extent &&
         a.field.distance.data() == b.field.distance.data() && a.artwork.thumbnail_png == b.artwork.thumbnail_png &&
         a.artwork.original == b.artwork.original && a.artwork.surroundings_png == b.artwork.surroundings_png &&
         a.artwork.surroundings_margin_px == b.artwork.surroundings_margin_px && a.artwork.unit_px == b.artwork.unit_px;
}

class HostileLibrary : public test::HostileFile {
 protected:
  void SetUp() override {
    LibraryWriter writer(path_, {});
    for (Shape& shape : test::synthetic_library(5)) {
      shape.field = make_shape_field(shape.outline);
      shape.artwork.thumbnail_png = small_png(40);
      shape.artwork.path = folder_.write(shape.name + ".svg", "<svg/>" + shape.name);
      if (shape.name == "shape1") {
        shape.artwork.original = small_png(100);
        shape.artwork.surroundings_png = small_png(120);
        shape.artwork.surroundings_margin_px = 10;
      }
      writer.append(shape);
    }
    writer.finish();
    good_ = LibraryFile(path_).read(0, 100, kEverything);
    std::ifstream file(path_, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(file), {});
    rank_pool().resize(rank_cores());  // ends the writer's threads, as the sanitizer allows no fork beside threads
  }

  std::string read(bool may_differ) const override {
    const LibraryFile library(path_);
    library.summary();
    library.content_digest();
    const std::vector<Shape> shapes = library.read(0, library.size(), kEverything);
    LibraryShapes placed(library);
    for (std::uint32_t i = 0; i < library.size(); ++i) {
      placed.shape(ShapeId{i});  // throws if the shape's parts contradict each other
      artwork_original(shapes[i].artwork);
      if (!may_differ && (shapes.size() != good_.size() || !same(shapes[i], good_[i]))) return "other shapes";
    }
    return {};
  }

  test::Forgery forge(std::uint32_t seed) override {
    folder_.write("library.h5", bytes_);
    return test::forge_library(path_, seed);
  }

  const std::string& path() const override { return path_; }

  ScratchFolder folder_;
  std::string path_ = folder_.path("library.h5");
  std::string bytes_;
  std::vector<Shape> good_;
};

TEST_F(HostileLibrary, IsFineBefore) { EXPECT_EQ(use(false), ""); }

TEST_F(HostileLibrary, TwoHundredForgeries) { EXPECT_GT(try_forgeries(0, 208), 208u * 2 / 3); }

// ctest runs it under the label "long".
TEST_F(HostileLibrary, DISABLED_ThousandsOfForgeries) { EXPECT_GT(try_forgeries(1000, 4000), 4000u * 2 / 3); }

// HDF5 itself crashes in one or two of a hundred such cases.
TEST_F(HostileLibrary, ForgedMetadata) {
  const std::vector<test::MetadataBlock> blocks = test::metadata_blocks(bytes_);
  ASSERT_GT(blocks.size(), 100u);
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    std::string forged = bytes_;
    test::forge_metadata(forged, blocks[random() % blocks.size()], random);
    folder_.write("library.h5", forged);
    try_file({"metadata", true}, seed);
  }
}

// All parts of a shape must belong together. A field that is too shallow would let pieces overlap, and the run would report no error.
TEST_F(HostileLibrary, AFieldThatIsNotItsOutlines) {
  std::vector<Shape> shapes = good_;
  const auto refusal = [&] {
    LibraryWriter writer(path_, {});
    for (const Shape& shape : shapes) writer.append(shape);
    writer.finish();
    return use(true);
  };
  ASSERT_EQ(refusal(), "");
  const std::string message = path_ + ": damaged: shape 2: its distance field is not its outline's; build it again" +
                              " with tessera library build";
  for (float& d : shapes[2].field.distance.data()) d *= 0.5f;  // pieces would overlap
  EXPECT_EQ(refusal(), message);
  shapes = good_;
  for (float& d : shapes[2].field.distance.data()) d = std::abs(d);
  EXPECT_EQ(refusal(), message);
  shapes = good_;
  shapes[2].field = shapes[3].field;
  EXPECT_EQ(refusal(), message);
  shapes = good_;
  shapes[2].radius = 0.1f;  // nothing would lie in its window
  EXPECT_NE(refusal().find("its radius is not its outline's"), std::string::npos);
  shapes = good_;
  for (auto& curve : shapes[2].outline.curves) {
    for (Vec2& p : curve) p = p * 0.5f;
  }
  EXPECT_NE(refusal().find("its outline's area is not 1"), std::string::npos);
}

// A library that asks for a thousand times its size in memory does not get it.
TEST_F(HostileLibrary, ManyRowsThatInflateWell) {
  test::change_library(path_, [](hid_t file) {
    const hid_t set = H5Dopen2(file, "/artwork/original", H5P_DEFAULT);
    const hsize_t rows = 50'000'000;
    H5Dset_extent(set, &rows);
    const std::vector<char> zeros(rows);
    ASSERT_GE(H5Dwrite(set, H5T_NATIVE_UCHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data()), 0);
    H5Dclose(set);
  });
  ASSERT_LT(std::filesystem::file_size(path_), 2'000'000u);
  EXPECT_NE(use(false).find("allowed are 16 times its size"), std::string::npos) << use(false);
}

/// A chunk is read as HDF5 reads it, or refused: another program must not see another shape in it.
TEST_F(HostileLibrary, ChunksThatHdf5WouldReadOtherwise) {
  using Bytes = std::vector<std::uint8_t>;
  const test::Column column = layout::library_columns(5).outline_points;
  const auto refusal = [&](std::uint32_t skipped_filters,
                           const std::function<Bytes(Bytes, const ChunkPacking&)>& make) {
    folder_.write("library.h5", bytes_);
    test::change_library(path_, [&](hid_t file) {
      const test::OpenColumn open = test::open_column(file, column);
      const ChunkPacking packing = test::packing_of(open, column);
      test::store_chunk_at(open, 0, make(test::read_chunk_at(open, 0, packing), packing), skipped_filters);
      H5Dclose(open.set);
    });
    return use(false);
  };
  const std::string chunk = path_ + ": data set /outline/points is damaged: the chunk of row 0: ";
  EXPECT_EQ(refusal(0, test::packed), "");
  EXPECT_EQ(refusal(1, test::packed), chunk + "filters are skipped");
  const auto with_a_tail = [](Bytes content, const ChunkPacking& packing) {
    Bytes stored = test::packed(content, packing);
    stored.resize(stored.size() - 4);  // removes its checksum
    stored.push_back(7);
    return test::with_checksum(stored);
  };
  EXPECT_EQ(refusal(0, with_a_tail), chunk + "it does not inflate to its size");
  const auto far_too_long = [](const Bytes& content, const ChunkPacking& packing) {
    return test::with_checksum(Bytes(2 * packing.bytes + content.size(), 7));
  };
  EXPECT_EQ(refusal(0, far_too_long), chunk + "more bytes are stored than it can need");
}

TEST_F(HostileLibrary, ThumbnailsThatAreLarge) {
  const auto refused = [&](std::vector<std::uint8_t> png) {
    Shape shape = good_[0];
    shape.artwork.thumbnail_png = std::move(png);
    try {
      LibraryWriter(path_, {}).append(shape);
      return false;
    } catch (const InputError&) {
      return true;
    }
  };
  EXPECT_FALSE(refused(small_png(192)));
  EXPECT_TRUE(refused(small_png(193)));
  const std::vector<std::uint8_t> grey = test::encoded(cv::Mat(9, 9, CV_8UC1, cv::Scalar(7)), ".png");
  EXPECT_TRUE(refused(grey));
  std::vector<std::uint8_t> longer = small_png(10);
  longer.push_back(0);
  EXPECT_TRUE(refused(longer));
}

}  // namespace test_hostile_library
}  // namespace tessera
