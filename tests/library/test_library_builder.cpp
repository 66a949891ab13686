// From files to a library: which files, in which order, under which names, and the reasons why others are left out.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "artwork/protocol/shape_codec.h"
#include "core/base/error.h"
#include "files/leftover_file.h"
#include "library/contact_sheet.h"
#include "library/left_out_list.h"
#include "library/library_builder.h"
#include "library/library_names.h"
#include "library/skip_reason_text.h"
#include "library/storage/library_file.h"
#include "support/artwork_samples.h"
#include "support/images.h"
#include "support/random_shape.h"
#include "support/scratch_folder.h"
#include "text/utf8_text.h"

namespace tessera {
namespace test_library_builder {

using test::RandomShape;
using test::ScratchFolder;

const BuildProgress kSilent = [](std::size_t, std::size_t) {};
const LibraryParts kEverything{
    .outline = true, .field = true, .levels = ~0u, .artwork = true, .original = true, .surroundings = true};

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Loads a test file by its content: a number is the seed of its silhouette, words mean trouble.
std::variant<ArtworkShape, SkipReason> fake_load(const std::string& path) {
  const std::string content = bytes_of(path);
  if (content == "hairlines") return SkipReason::hairlines;
  if (content == "hollow") return SkipReason::hollow;
  if (content == "unreadable") throw InputError(path + ": not a drawing");
  ArtworkShape result{.shape = RandomShape(std::stoul(content), 5).make()};
  result.shape.name = std::filesystem::path(path).stem();
  result.shape.artwork.path = path;
  result.shape.artwork.original.clear();
  result.other_components = content == "7" ? 2 : 0;
  result.loses_parts = content == "9";
  result.hollowness = content == "8" ? 2.5f : 1;
  std::this_thread::sleep_for(std::chrono::milliseconds(std::stoul(content) * 7 % 5));
  return result;
}

const ShapeLoader kFake{fake_load};

class LibraryBuilder : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories(std::filesystem::path(folder_.path("in/" + name)).parent_path());
    folder_.write("in/" + name, content);
  }

  ArtworkFiles found(const std::string& glob = "") const { return find_artwork({folder_.path("in")}, glob); }

  LibraryBuildReport build(const LibraryBuildSettings& settings = {}, const std::string& name = "out.h5") const {
    return build_library(found(), folder_.path(name), settings, kFake, kSilent);
  }

  std::vector<Shape> shapes(const std::string& name = "out.h5") const {
    const LibraryFile library(folder_.path(name));
    return library.read(0, library.size(), kEverything);
  }

  LibraryBuildReport build_really() const {
    Drawers drawers({.processes = 2});
    LibraryBuildSettings settings;
    settings.files_at_a_time = 2;
    return build_library(found(), folder_.path("out.h5"), settings, artwork_loader(drawers, {}), kSilent);
  }

  ScratchFolder folder_;
};

TEST_F(LibraryBuilder, FindsArtworkSortedAndOnce) {
  for (const char* name : {"b.svg", "a/z.PNG", "a/y.svgz", "c.txt", "d.jpeg"}) write(name, "1");
  std::filesystem::create_symlink(folder_.path("in/b.svg"), folder_.path("in/a/again.svg"));
  std::filesystem::create_symlink(folder_.path("in"), folder_.path("in/a/loop"));
  const std::string in = folder_.path("in/");
  EXPECT_EQ(found().paths, (std::vector<std::string>{in + "a/y.svgz", in + "a/z.PNG", in + "b.svg", in + "d.jpeg"}));
  EXPECT_EQ(found("*.txt").paths, std::vector<std::string>{in + "c.txt"});
  EXPECT_EQ(find_artwork({in + "c.txt", in + "a", in + "a/../a"}, "").paths.size(), 4u);
  EXPECT_THROW(find_artwork({in + "nothing"}, ""), InputError);
}

TEST_F(LibraryBuilder, NamesPicturesInOtherFormats) {
  for (const char* name : {"a.svg", "b.GIF", "c.pdf", "d.eps", "e.txt", "f.heic"}) write(name, "1");
  ::mkfifo(folder_.path("in/g.svg").c_str(), 0600);
  const LibraryBuildReport report = build();
  EXPECT_EQ(report.shapes, 1u);
  std::vector<std::string> names, reasons;
  for (const UnusedFile& file : report.skipped) {
    names.push_back(std::filesystem::path(file.path).filename());
    reasons.push_back(file.reason);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"b.GIF", "c.pdf", "d.eps", "f.heic", "g.svg"}));
  EXPECT_EQ(reasons[0], "a format that is not read; convert it to SVG or PNG: gif");
  EXPECT_EQ(reasons[4], "not a regular file");
  EXPECT_TRUE(found("*.svg").left_out.size() == 1);  // the pipe
  const ArtworkFiles matching = found("*.GIF");
  EXPECT_TRUE(matching.paths.empty());
  ASSERT_EQ(matching.left_out.size(), 1u);
  EXPECT_EQ(matching.left_out[0].reason, reasons[0]);
  EXPECT_EQ(find_artwork({folder_.path("in/g.svg")}, "").left_out[0].reason, reasons[4]);
  EXPECT_EQ(report.files, 6u) << "all but the text";
}

/// Patterns work as for names in a library: if a file's name equals the pattern, it is the only match.
TEST_F(LibraryBuilder, AnExactNameWinsOverAPattern) {
  for (const char* name : {"logo [final].svg", "logo f.svg", "logo i.svg"}) write(name, name);
  EXPECT_EQ(found("logo [final].svg").paths, std::vector<std::string>{folder_.path("in/logo [final].svg")});
  EXPECT_EQ(found("logo [fi].svg").paths.size(), 2u);
  EXPECT_EQ(found("logo*").paths.size(), 3u);
}

TEST_F(LibraryBuilder, JudgesWhatIsNamedByItsContent) {
  for (const char* name : {"pic.ai", "b.GIF"}) {
    write(name, "1");
    const ArtworkFiles named = find_artwork({folder_.path(std::string("in/") + name)}, "");
    EXPECT_EQ(named.paths, std::vector<std::string>{folder_.path(std::string("in/") + name)});
    EXPECT_TRUE(named.left_out.empty());
  }
}

TEST(SkipReasonText, SaysWhatToDo) {
  EXPECT_EQ(
      skip_reason_text(SkipReason::several_large_components),
      "several large parts that do not touch; save each as a file of its own, or join them; a photo is for tessera "
      "library extract");
  EXPECT_EQ(skip_reason_text(SkipReason::hairlines),
            "too much of it is thin lines; fill what they enclose, or make them thicker");
  EXPECT_EQ(skip_reason_text(SkipReason::faint),
            "too faint: parts of an opacity below 0.08, or lines too thin, do not count, and the rest makes no shape; "
            "make them more opaque or thicker, or build with --edge-opacity 0.05");
}

TEST_F(LibraryBuilder, WritesShapesInTheOrderOfTheFiles) {
  for (int i = 10; i < 40; ++i) write(std::to_string(i) + ".svg", std::to_string(i));
  const LibraryBuildReport report = build();
  EXPECT_TRUE(report.written);
  EXPECT_EQ(report.shapes, 30u);
  const auto all = shapes();
  ASSERT_EQ(all.size(), 30u);
  for (std::size_t i = 0; i < 30; ++i) EXPECT_EQ(all[i].name, std::to_string(10 + i));
  EXPECT_EQ(all[5].outline, RandomShape(15, 5).make().outline);
}

TEST_F(LibraryBuilder, BytesDoNotDependOnTheProcesses) {
  for (int i = 10; i < 30; ++i) write(std::to_string(i) + ".svg", std::to_string(i));
  LibraryBuildSettings settings;
  build(settings, "one.h5");
  settings.files_at_a_time = 4;
  build(settings, "four.h5");
  EXPECT_EQ(bytes_of(folder_.path("one.h5")), bytes_of(folder_.path("four.h5")));
}

TEST_F(LibraryBuilder, SkipsWithReasons) {
  write("a.svg", "1");
  write("b.svg", "hairlines");
  write("c.svg", "unreadable");
  write("e.svg", "7");
  write("f.svg", "9");
  const LibraryBuildReport report = build();
  EXPECT_TRUE(report.written);
  EXPECT_EQ(report.files, 5u);
  EXPECT_EQ(report.shapes, 3u);
  ASSERT_EQ(report.skipped.size(), 2u);
  EXPECT_EQ(report.skipped[0].path, folder_.path("in/b.svg"));
  EXPECT_EQ(report.skipped[0].reason, skip_reason_text(SkipReason::hairlines));
  EXPECT_EQ(report.skipped[1].reason, "not a drawing");
  EXPECT_EQ(report.trimmed, std::vector<std::string>{folder_.path("in/e.svg")});
  EXPECT_EQ(report.faint, std::vector<std::string>{folder_.path("in/f.svg")});
}

TEST_F(LibraryBuilder, NamesWhatEnclosesMuchUnlessItIsFilled) {
  write("a.svg", "1");
  write("b.svg", "hollow");
  write("c.svg", "8");
  write("d.svg", "8");
  const LibraryBuildReport report = build();
  EXPECT_EQ(report.hollow, std::vector<std::string>{folder_.path("in/c.svg")}) << "the others are not in the library";
  EXPECT_EQ(report.skipped.size(), 1u);
  EXPECT_EQ(report.merged.size(), 1u);
  const LibraryBuildSettings filled{.tracing = {.pad = {}, .rules = {.fill_holes = true}}};
  EXPECT_TRUE(build(filled).hollow.empty());
}

TEST_F(LibraryBuilder, StrictWritesNothingWhereAFileIsSkipped) {
  write("a.svg", "1");
  EXPECT_TRUE(build({.tracing = {}, .embed = false, .strict = true}).written);
  std::filesystem::remove(folder_.path("out.h5"));
  write("b.svg", "unreadable");
  EXPECT_FALSE(build({.tracing = {}, .embed = false, .strict = true}).written);
  EXPECT_FALSE(std::filesystem::exists(folder_.path("out.h5")));
  EXPECT_FALSE(std::filesystem::exists(folder_.path("out.h5.tmp")));
}

TEST_F(LibraryBuilder, WritesNothingWithoutShapes) {
  write("a.svg", "unreadable");
  EXPECT_FALSE(build().written);
  EXPECT_FALSE(std::filesystem::exists(folder_.path("out.h5")));
}

/// All pieces of a puzzle are needed, even if they are alike; they repeat each other.
TEST_F(LibraryBuilder, KeepsTwinsWhereTheyAreWished) {
  for (const char* name : {"a.svg", "b.svg", "c.svg"}) write(name, *name == 'b' ? "2" : "1");
  LibraryBuildSettings settings;
  settings.keep_twins = true;
  const LibraryBuildReport report = build(settings);
  EXPECT_EQ(report.shapes, 3u);
  EXPECT_TRUE(report.merged.empty());
  EXPECT_EQ(LibraryFile(folder_.path("out.h5")).variant_of(), (std::vector<std::uint32_t>{0, 1, 0}));
}

TEST_F(LibraryBuilder, MergesEqualSilhouettesAndNamesThem) {
  write("a.svg", "1");
  write("b.svg", "2");
  write("c.svg", "1");
  const LibraryBuildReport report = build();
  EXPECT_EQ(report.shapes, 2u);
  ASSERT_EQ(report.merged.size(), 1u);
  EXPECT_EQ(report.merged[0].path, folder_.path("in/c.svg"));
  EXPECT_EQ(report.merged[0].name, "a");
}

TEST_F(LibraryBuilder, NamesAreUnique) {
  write("a.svg", "1");
  write("x/a.svg", "2");
  write("x/a.png", "3");
  build();
  const auto all = shapes();
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].name, "a");
  EXPECT_EQ(all[1].name, "a (x)");
  EXPECT_EQ(all[2].name, "a (x) 2");
}

TEST_F(LibraryBuilder, EmbedsTheFiles) {
  write("a.svg", "17");
  build({.tracing = {}, .embed = true, .strict = false});
  EXPECT_EQ(shapes()[0].artwork.original, (std::vector<std::uint8_t>{'1', '7'}));
}

TEST_F(LibraryBuilder, ASignalLeavesNothing) {
  write("a.svg", "1");
  const std::string unfinished = folder_.path("out.h5.tmp");
  const BuildProgress signalled = [&](std::size_t, std::size_t) {
    EXPECT_TRUE(std::filesystem::exists(unfinished));
    remove_leftover_files();  // as the signal handler does
    EXPECT_FALSE(std::filesystem::exists(unfinished));
  };
  EXPECT_THROW(build_library(found(), folder_.path("out.h5"), {}, kFake, signalled), EnvironmentError);
  EXPECT_FALSE(std::filesystem::exists(folder_.path("out.h5")));
}

TEST_F(LibraryBuilder, ReportsProgress) {
  for (int i = 0; i < 5; ++i) write(std::to_string(i) + ".svg", std::to_string(i));
  std::vector<std::size_t> seen;
  build_library(found(), folder_.path("out.h5"), {}, kFake,
                [&](std::size_t done, std::size_t) { seen.push_back(done); });
  EXPECT_EQ(seen, (std::vector<std::size_t>{1, 2, 3, 4, 5}));
}

std::string svg(const std::string& path_data, const std::string& fill) {
  return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'><path fill='" + fill + "' d='" + path_data +
         "'/></svg>";
}

// The whole way with real drawings: one silhouette twice in one colour and once in another, and invalid files.
TEST_F(LibraryBuilder, BuildsFromRealDrawings) {
  const std::string drop = "M50 5 C80 40 90 60 90 70 A40 25 0 1 1 10 70 C10 60 20 40 50 5Z";
  write("blue.svg", svg(drop, "#0000ff"));
  write("moon.svg", svg("M70 10 A42 42 0 1 0 70 90 A50 50 0 0 1 70 10Z", "gold"));
  write("blue_again.svg", svg(drop, "#0300fc"));
  write("red.svg", svg(drop, "#ff0000"));
  write("rubbish.svg", "this is no drawing");
  const LibraryBuildReport report = build_really();
  EXPECT_EQ(report.shapes, 3u);
  ASSERT_EQ(report.merged.size(), 1u);
  EXPECT_EQ(report.merged[0].path, folder_.path("in/blue_again.svg"));
  EXPECT_EQ(report.merged[0].name, "blue");
  ASSERT_EQ(report.skipped.size(), 1u);
  const auto all = shapes();
  EXPECT_EQ(all[1].name, "moon");
  EXPECT_LT(all[0].mean_lab[2], -50);  // blue
  EXPECT_GT(all[1].mean_lab[2], 50);   // yellow
  EXPECT_EQ(all[2].name, "red");
  for (int cell = 0; cell < kColourCells; ++cell) {
    const std::uint8_t* blue = all[0].colour_grid.bytes.data() + 4 * cell;
    if (blue[3] == 0) continue;
    EXPECT_NEAR(blue[0] / 2.55, 32, 1.5) << cell;
    EXPECT_NEAR(blue[2] - 128, -108, 3) << cell;
  }
  const auto covered = [&](int cell) { return int(all[0].colour_grid.bytes[std::size_t(4 * cell + 3)]); };
  EXPECT_LT(covered(0), 10) << "a drop has nothing beside its tip";
  EXPECT_GT(covered(9), 245);
  EXPECT_EQ(all[2].outline, all[0].outline);

  const LibraryFile library(folder_.path("out.h5"));
  EXPECT_EQ(library.variant_of(), (std::vector<std::uint32_t>{0, 1, 0}));
  EXPECT_EQ(write_contact_sheet(library, folder_.path("sheet.png")), 3u);
  const cv::Mat sheet = test::read_image(folder_.path("sheet.png"));
  ASSERT_FALSE(sheet.empty());
  const cv::Scalar mean = cv::mean(sheet);
  EXPECT_GT(mean[0], 150);  // mostly paper
  EXPECT_LT(mean[0], 250);  // but not only
}

/// librsvg 2.54 panics on this file. In a process forked from this one, a panic would run this process' clean-up, which removes the
/// half-written library.
TEST_F(LibraryBuilder, APanicCostsItsOwnFile) {
  std::string matrix;
  for (int i = 0; i < 100 * 100; ++i) matrix += "1 ";
  const std::string filter = "<filter id='f'><feConvolveMatrix order='100' kernelMatrix='" + matrix + "'/></filter>";
  for (const char* name : {"a.svg", "c.svg", "e.svg"}) {
    write(name, "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'>" + filter +
                    "<circle cx='50' cy='50' r='30' filter='url(#f)'/></svg>");
  }
  write("b.svg", svg("M70 10 A42 42 0 1 0 70 90 A50 50 0 0 1 70 10Z", "gold"));
  write("d.svg", svg("M50 5 C80 40 90 60 90 70 A40 25 0 1 1 10 70 C10 60 20 40 50 5Z", "gold"));
  const LibraryBuildReport report = build_really();
  EXPECT_TRUE(report.written);
  EXPECT_EQ(shapes().size(), 2u);
  ASSERT_EQ(report.skipped.size(), 3u);
  for (const UnusedFile& file : report.skipped) EXPECT_EQ(file.reason, test::kPanicReason);
}

TEST(ShapeCodec, GivesBackTheShape) {
  const Shape shape = RandomShape(3, 5).make();
  const std::string bytes = encode_shape(shape);
  EXPECT_EQ(encode_shape(decode_shape(bytes)), bytes);
  EXPECT_EQ(decode_shape(bytes).outline, shape.outline);
  EXPECT_EQ(decode_shape(bytes).field.distance.data(), shape.field.distance.data());
  EXPECT_EQ(decode_shape(bytes).levels[2].samples, shape.levels[2].samples);
}

TEST(ShapeCodec, RefusesOtherBytes) {
  const std::string bytes = encode_shape(RandomShape(3, 5).make());
  for (std::size_t length = 0; length < bytes.size(); length += 997) {
    EXPECT_THROW(decode_shape(std::string_view(bytes).substr(0, length)), std::runtime_error) << length;
  }
  EXPECT_THROW(decode_shape(bytes + "x"), std::runtime_error);
  EXPECT_THROW(decode_shape(std::string(8, '\xff')), std::runtime_error);
}

TEST(LibraryNames, ArePrintableAndShort) {
  EXPECT_EQ(printable_utf8("Käfer 🐞"), "Käfer 🐞");
  EXPECT_EQ(printable_utf8("a\nb\x7f\xff\xc3"), "a_b___");
  EXPECT_EQ(printable_utf8("\xc0\xaf \xed\xa0\x80"), "__ ___");
  LibraryNames names;
  EXPECT_EQ(names.unique("", "/x/.svg"), "_");
  std::string umlauts;
  for (int i = 0; i < 150; ++i) umlauts += "ü";
  const std::string first = names.unique(umlauts, "/" + umlauts + "/a.svg");
  const std::string second = names.unique(umlauts, "/" + umlauts + "/a.svg");
  EXPECT_EQ(printable_utf8(first), first);  // the text is not cut inside a character
  EXPECT_EQ(printable_utf8(second), second);
  EXPECT_NE(first, second);
  EXPECT_LT(second.size(), layout::kNameBytes);
}

TEST(LeftOutList, is_beside_the_library) {
  EXPECT_EQ(left_out_path("out/animals.h5"), "out/animals.left_out.txt");
  EXPECT_EQ(left_out_path("v1.2"), "v1.2.left_out.txt");
}

TEST(LeftOutList, has_a_line_a_file_whatever_its_name) {
  LibraryBuildReport report;
  EXPECT_EQ(left_out_list(report), "");
  report.skipped = {{"/a/x\ty.svg", "not a readable SVG file: line 3:\n no"}, {"/a/b.svg", "hairlines"}};
  report.merged = {{"/a/red.svg", "blue"}};
  report.trimmed = {"/a/deer.svg"};
  report.faint = {"/a/fly.svg"};
  EXPECT_EQ(
      left_out_list(report),
      "skipped\t/a/x_y.svg\tnot a readable SVG file: line 3:_ no\n"
      "skipped\t/a/b.svg\thairlines\n"
      "merged\t/a/red.svg\tthe silhouette and colour of blue\n"
      "trimmed\t/a/deer.svg\tparts that do not touch the largest one are not in the silhouette; join them to have "
      "them, or, where a soft shadow joins them, build with --edge-opacity 0.05\n"
      "trimmed\t/a/fly.svg\tparts that are too faint (an opacity below 0.08) or too thin, or a plate behind the "
      "drawing, "
      "are not in the silhouette; make them more opaque or thicker to have them, or build with --edge-opacity 0.05\n");
}

}  // namespace test_library_builder
}  // namespace tessera
