// A written library is read back in any range and any part; an unfinished library leaves no file.
#include <gtest/gtest.h>
#include <hdf5.h>
#include <rapidcheck/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "core/base/error.h"
#include "files/atomic_file.h"
#include "library/storage/library_file.h"
#include "library_surgery.h"
#include "support/planted_files.h"
#include "support/random_shape.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_library_file {

using test::RandomShape;
using test::ScratchFolder;

const LibraryParts kEverything{
    .outline = true, .field = true, .levels = ~0u, .artwork = true, .original = true, .surroundings = true};

std::vector<Shape> random_shapes(std::uint64_t seed, int count, int pad_levels) {
  RandomShape random(seed, pad_levels);
  std::vector<Shape> shapes;
  for (int i = 0; i < count; ++i) shapes.push_back(random.make());
  return shapes;
}

void write_library(const std::string& path, const std::vector<Shape>& shapes, const PadParameters& pad) {
  LibraryWriter writer(path, pad);
  for (const Shape& shape : shapes) writer.append(shape);
  writer.finish();
}

bool equal(const LevelCurve& a, const LevelCurve& b) {
  return a.points == b.points && a.perimeter == b.perimeter && a.samples == b.samples;
}

bool equal(const Artwork& a, const Artwork& b) {
  return a.path == b.path && a.width_px == b.width_px && a.height_px == b.height_px && a.centroid_px == b.centroid_px &&
         a.unit_px == b.unit_px && a.thumbnail_png == b.thumbnail_png && a.original == b.original &&
         a.surroundings_png == b.surroundings_png && a.surroundings_margin_px == b.surroundings_margin_px;
}

float largest_difference(const Grid<float>& a, const Grid<float>& b) {
  if (a.data().size() != b.data().size()) return INFINITY;
  float largest = 0;
  for (std::size_t i = 0; i < a.data().size(); ++i) largest = std::max(largest, std::abs(a.data()[i] - b.data()[i]));
  return largest;
}

bool equal(const Shape& a, const Shape& b) {
  return a.name == b.name && a.outline == b.outline && a.perimeter == b.perimeter && a.radius == b.radius &&
         a.mean_lab == b.mean_lab && a.colour_grid == b.colour_grid && a.drawn_scale_px == b.drawn_scale_px &&
         a.field.extent == b.field.extent && largest_difference(a.field.distance, b.field.distance) < 1e-4f &&
         std::equal(a.levels.begin(), a.levels.end(), b.levels.begin(),
                    [](const LevelCurve& x, const LevelCurve& y) { return equal(x, y); }) &&
         equal(a.artwork, b.artwork);
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool all_equal(const std::vector<Shape>& read, const std::vector<Shape>& written, std::size_t begin) {
  for (std::size_t i = 0; i < read.size(); ++i) {
    if (!equal(read[i], written[begin + i])) return false;
  }
  return true;
}

RC_GTEST_PROP(LibraryFile, GivesBackWhatWasWritten, ()) {
  const ScratchFolder folder;
  const PadParameters pad{*rc::gen::inRange(2, kMaxPadLevels + 1), 0.15f};
  const auto shapes = random_shapes(*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::inRange(1, 6), pad.levels);
  write_library(folder.path("a.h5"), shapes, pad);

  const LibraryFile library(folder.path("a.h5"));
  RC_ASSERT(library.size() == shapes.size());
  RC_ASSERT(library.pad_parameters() == pad);
  const auto begin = *rc::gen::inRange<std::size_t>(0, shapes.size());
  const auto end = *rc::gen::inRange<std::size_t>(begin, shapes.size() + 1);
  const auto read = library.read(begin, end, kEverything);
  RC_ASSERT(read.size() == end - begin);
  RC_ASSERT(all_equal(read, shapes, begin));
}

StyleFeatures style_of(float part) {
  return {part / 50, part, 1 - part, 4 * part, 60 * part, part, part / 2, part / 3};
}

TEST(LibraryFile, KnowsTheStylesThatWereWrittenAndOlderOnesNone) {
  const ScratchFolder folder;
  const auto shapes = random_shapes(3, 2, 5);
  LibraryWriter writer(folder.path("a.h5"), {});
  writer.append(shapes[0], {}, style_of(0.25f));
  writer.append(shapes[1]);
  writer.finish();
  EXPECT_EQ(LibraryFile(folder.path("a.h5")).styles(), (std::vector<StyleFeatures>{style_of(0.25f), {}}));
  test::change_library(folder.path("a.h5"), [](hid_t file) { H5Ldelete(file, "/shapes/style", H5P_DEFAULT); });
  EXPECT_EQ(LibraryFile(folder.path("a.h5")).styles(), std::vector<StyleFeatures>(2));
  EXPECT_TRUE(all_equal(LibraryFile(folder.path("a.h5")).read(0, 2, kEverything), shapes, 0));
}

TEST(LibraryWriter, RefusesStylesThatNoReaderWouldTake) {
  const ScratchFolder folder;
  const auto shapes = random_shapes(3, 1, 5);
  LibraryWriter writer(folder.path("a.h5"), {});
  for (float StyleFeatures::*number : {&StyleFeatures::outlined, &StyleFeatures::palette, &StyleFeatures::texture}) {
    for (const float value : {-2.f, 1000.f, NAN}) {
      StyleFeatures style = style_of(0.5f);
      style.*number = value;
      EXPECT_THROW(writer.append(shapes[0], {}, style), InputError);
    }
  }
}

// There are more shapes than fit into a chunk of any column except the smallest.
TEST(LibraryFile, ReadsRangesAcrossChunks) {
  const ScratchFolder folder;
  const auto shapes = random_shapes(1, 150, 5);
  write_library(folder.path("a.h5"), shapes, {});
  const LibraryFile library(folder.path("a.h5"));
  for (const auto& [begin, end] : {std::pair<std::size_t, std::size_t>{0, 150}, {31, 33}, {99, 150}, {149, 150}}) {
    EXPECT_TRUE(all_equal(library.read(begin, end, kEverything), shapes, begin)) << begin;
  }
  EXPECT_TRUE(library.read(7, 7, kEverything).empty());
}

TEST(LibraryFile, ReadsOnlyTheAskedParts) {
  const ScratchFolder folder;
  const auto shapes = random_shapes(2, 2, 5);
  write_library(folder.path("a.h5"), shapes, {});
  const LibraryParts parts{.outline = false, .field = false, .levels = 1u << 3, .artwork = false, .original = false};
  const Shape shape = LibraryFile(folder.path("a.h5")).read(1, 2, parts).at(0);
  EXPECT_EQ(shape.name, shapes[1].name);
  EXPECT_TRUE(equal(shape.levels[3], shapes[1].levels[3]));
  EXPECT_TRUE(shape.outline.curves.empty());
  EXPECT_TRUE(shape.field.distance.data().empty());
  EXPECT_TRUE(shape.levels[2].points.empty());
  EXPECT_TRUE(shape.artwork.path.empty() && shape.artwork.thumbnail_png.empty() && shape.artwork.original.empty());
}

TEST(LibraryFile, SummaryCountsWhatIsStored) {
  const ScratchFolder folder;
  const auto shapes = random_shapes(3, 5, 5);
  write_library(folder.path("a.h5"), shapes, {});
  std::size_t curves = 0, points = 0, original_bytes = 0;
  for (const Shape& shape : shapes) {
    curves += shape.outline.curves.size();
    for (const auto& curve : shape.outline.curves) points += curve.size();
    original_bytes += shape.artwork.original.size();
  }
  const LibrarySummary summary = LibraryFile(folder.path("a.h5")).summary();
  EXPECT_EQ(summary.shapes, shapes.size());
  EXPECT_EQ(summary.curves, curves);
  EXPECT_EQ(summary.outline_points, points);
  EXPECT_EQ(summary.original_bytes, original_bytes);
  EXPECT_EQ(summary.file_bytes, std::filesystem::file_size(folder.path("a.h5")));
  std::uint64_t stored = 0;
  for (const auto& [part, bytes] : summary.stored_bytes_of_part) stored += bytes;
  EXPECT_GT(stored, 0u);
  EXPECT_LT(stored, summary.file_bytes);
}

std::uint64_t content_digest(const std::string& path) { return LibraryFile(path).content_digest(); }

/// Makes the library look as an older version wrote it.
void remove_new_data_sets(const std::string& path) {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, access);
  for (const char* name : {"/shapes/part_digest", "/artwork/path_from_library", "/artwork/sha256", "/artwork/reader"})
    H5Ldelete(file, name, H5P_DEFAULT);
  H5Fclose(file);
  H5Pclose(access);
}

// Ranks and checkpoints compare libraries by the digest; the size of the file says nothing.
TEST(LibraryFile, DigestChangesWithEveryPartThatDecides) {
  const ScratchFolder folder;
  const auto shapes = random_shapes(12, 70, 5);  // more than are read at once
  write_library(folder.path("a.h5"), shapes, {});
  const std::uint64_t digest = content_digest(folder.path("a.h5"));
  const auto changes = [&](auto change) {
    auto changed = shapes;
    change(changed[66]);
    write_library(folder.path("b.h5"), changed, {});
    return content_digest(folder.path("b.h5")) != digest;
  };
  EXPECT_FALSE(changes([](Shape&) {}));
  EXPECT_FALSE(changes([](Shape& s) { s.artwork.path = "/elsewhere.svg"; }));
  EXPECT_TRUE(changes([](Shape& s) { s.name = "x"; }));
  EXPECT_TRUE(changes([](Shape& s) { s.perimeter += 0.001f; }));
  EXPECT_TRUE(changes([](Shape& s) { s.outline.curves[0][1].x += 1e-6f; }));
  EXPECT_TRUE(changes([](Shape& s) { s.field.distance(3, 5) += 0.01f; }));
  EXPECT_TRUE(changes([](Shape& s) { s.field.extent += 1e-6f; }));
  EXPECT_TRUE(changes([](Shape& s) { s.levels[4].samples[7].left[2] += 1e-6f; }));
  EXPECT_TRUE(changes([](Shape& s) { std::swap(s.levels[1].points[0], s.levels[1].points[1]); }));
  write_library(folder.path("b.h5"), shapes, {5, 0.25f});
  EXPECT_NE(content_digest(folder.path("b.h5")), digest);
}

TEST(LibraryFile, AnOlderLibraryHasTheSameDigestAndShapes) {
  const ScratchFolder folder;
  const auto shapes = random_shapes(13, 70, 5);
  write_library(folder.path("a.h5"), shapes, {});
  const std::uint64_t digest = content_digest(folder.path("a.h5"));
  remove_new_data_sets(folder.path("a.h5"));
  const LibraryFile older(folder.path("a.h5"));
  EXPECT_EQ(older.content_digest(), digest);
  const auto read = older.read(0, older.size(), kEverything);
  EXPECT_TRUE(all_equal(read, shapes, 0));
  EXPECT_FALSE(read[0].artwork.sha256.has_value());
  EXPECT_EQ(read[0].artwork.path_beside_library, "");
  EXPECT_EQ(read[0].artwork.reader, 1) << "it does not say by what it was made";
}

TEST(LibraryFile, KeepsTheHashAndFindsWhatMovedWithIt) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path("old"));
  auto shapes = random_shapes(14, 2, 5);
  shapes[0].artwork.path = folder.path("old/drawings/duck.svg");
  shapes[0].artwork.sha256.emplace().fill(7);
  shapes[0].artwork.reader = 1;  // this one was copied from an older library
  write_library(folder.path("old/a.h5"), shapes, {});
  std::filesystem::rename(folder.path("old"), folder.path("new"));
  const auto read = LibraryFile(folder.path("new/a.h5")).read(0, 2, kEverything);
  EXPECT_EQ(read[0].artwork.path, shapes[0].artwork.path);
  EXPECT_EQ(read[0].artwork.path_beside_library, folder.path("new/drawings/duck.svg"));
  EXPECT_EQ(read[0].artwork.sha256, shapes[0].artwork.sha256);
  EXPECT_EQ(read[0].artwork.reader, 1);
  EXPECT_EQ(read[1].artwork.reader, kArtworkReader);
  EXPECT_FALSE(read[1].artwork.sha256.has_value());
}

TEST(LibraryFile, IsReadByH5dump) {
  const ScratchFolder folder;
  auto shapes = random_shapes(10, 2, 5);
  shapes[1].name = "duck";  // h5dump escapes characters outside ASCII
  write_library(folder.path("a.h5"), shapes, {});
  FILE* dump = ::popen(("h5dump -d /shapes/name -d /field/scale " + folder.path("a.h5")).c_str(), "r");
  ASSERT_NE(dump, nullptr);
  std::string text(100'000, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), dump));
  EXPECT_EQ(::pclose(dump), 0);
  EXPECT_NE(text.find("\"duck\""), std::string::npos) << text;
  EXPECT_NE(text.find("one step of /field/distance"), std::string::npos) << text;
}

TEST(LibraryWriter, GivesTheSameBytesForTheSameShapes) {
  const ScratchFolder folder;
  const auto shapes = random_shapes(4, 20, 5);
  write_library(folder.path("a.h5"), shapes, {});
  write_library(folder.path("b.h5"), shapes, {});
  EXPECT_EQ(bytes_of(folder.path("a.h5")), bytes_of(folder.path("b.h5")));
}

TEST(LibraryWriter, LeavesNothingWhenUnfinished) {
  const ScratchFolder folder;
  { LibraryWriter(folder.path("a.h5"), {}).append(random_shapes(5, 1, 5)[0]); }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path("")));
}

TEST(LibraryWriter, KeepsTheOldLibraryUntilTheNewOneIsWhole) {
  const ScratchFolder folder;
  const auto old_shapes = random_shapes(6, 2, 5);
  write_library(folder.path("a.h5"), old_shapes, {});
  { LibraryWriter(folder.path("a.h5"), {}).append(random_shapes(7, 1, 5)[0]); }
  EXPECT_TRUE(all_equal(LibraryFile(folder.path("a.h5")).read(0, 2, kEverything), old_shapes, 0));
}

TEST(LibraryWriter, FollowsNothingThatOthersPutThere) {
  for (const test::Plant plant : test::kPlants) {
    const ScratchFolder folder;
    const test::PlantedFiles planted;
    const std::string path = folder.path("library.h5");
    planted.put(plant, path);
    planted.put(plant, temporary_path(path));
    write_library(path, random_shapes(3, 1, 5), {});
    EXPECT_EQ(LibraryFile(path).size(), 1u);
    EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::symlink_status(path)));
    EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(temporary_path(path))));
    planted.expect_untouched();
  }
}

TEST(LibraryWriter, RefusesShapesThatNoReaderWouldTake) {
  const ScratchFolder folder;
  const Shape good = random_shapes(8, 1, 5)[0];
  LibraryWriter writer(folder.path("a.h5"), {});
  const auto refuses = [&](auto spoil) {
    Shape shape = good;
    spoil(shape);
    EXPECT_THROW(writer.append(shape), InputError);
  };
  refuses([](Shape& s) { s.perimeter = NAN; });
  refuses([](Shape& s) { s.outline.curves.clear(); });
  refuses([](Shape& s) { s.outline.curves[0][1].x = INFINITY; });
  refuses([](Shape& s) { s.outline.curves[0].resize(2); });
  refuses([](Shape& s) { s.field.distance(5, 7) = NAN; });
  refuses([](Shape& s) { s.field.distance = Grid<float>(64, 64); });
  refuses([](Shape& s) { s.levels[2].samples.pop_back(); });
  refuses([](Shape& s) { s.levels[1].samples[3].left[2] = NAN; });
  refuses([](Shape& s) { s.levels[1].samples[3].convexity = 1.5f; });
  refuses([](Shape& s) { s.name = std::string(1000, 'x'); });
  refuses([](Shape& s) { s.artwork.unit_px = 0; });
  writer.append(good);
  writer.finish();
  EXPECT_EQ(LibraryFile(folder.path("a.h5")).size(), 1u);
}

TEST(LibraryWriter, NamesThePlaceThatCannotBeWritten) {
  try {
    LibraryWriter("/no/such/folder/a.h5", {});
    FAIL();
  } catch (const EnvironmentError& error) {
    EXPECT_STREQ(error.what(), "cannot write /no/such/folder/a.h5: No such file or directory");
  }
}

TEST(LibraryWriter, DoesNotReplaceAFolder) {
  const ScratchFolder folder;
  EXPECT_THROW(LibraryWriter(folder.path(""), {}), EnvironmentError);
}

/// A limit on the size of files acts like a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    old_handler_ = ::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &old_);
    ::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_{};
  void (*old_handler_)(int) = nullptr;
};

TEST(LibraryWriter, LeavesNothingOnAFullDisk) {
  const ScratchFolder folder;
  const auto shapes = random_shapes(9, 30, 5);
  for (const rlim_t bytes : {1000, 200'000, 2'000'000}) {
    const FileSizeLimit limit(bytes);
    try {
      write_library(folder.path("a.h5"), shapes, {});
      ADD_FAILURE() << bytes;
    } catch (const EnvironmentError& error) {
      EXPECT_NE(std::string(error.what()).find("File too large"), std::string::npos) << error.what();
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path(""))) << bytes;
  }
}

}  // namespace test_library_file
}  // namespace tessera
