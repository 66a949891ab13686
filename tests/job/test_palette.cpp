// The palettes of silhouettes, and which libraries consist of silhouettes.
#include <gtest/gtest.h>

#include "job/job_file.h"
#include "job/palette.h"
#include "library/one_colour.h"
#include "library/storage/library_file.h"
#include "support/input_error.h"
#include "support/random_shape.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_palette {

using Colours = std::vector<std::string>;

class Palettes : public testing::Test {
 protected:
  Job job(const std::string& palette, const std::vector<std::string>& overrides = {}) const {
    return load_job(folder_.write("job.toml", "[library]\nfile = \"a.h5\"\n[colour]\npalette = " + palette), overrides);
  }
  Colours colours(const std::string& palette) const { return load_palette(job(palette)); }
  std::string mistake(const std::string& palette) const {
    return test::message_of([&] { load_palette(job(palette)); });
  }

  test::ScratchFolder folder_;
};

TEST_F(Palettes, AreBuiltInOrListed) {
  for (const std::string& name : built_in_palettes()) EXPECT_GE(colours('"' + name + '"').size(), 6u) << name;
  EXPECT_EQ(load_palette(Job()), colours("\"dusk\""));
  EXPECT_EQ(colours("[\"#AAbbcc\", \"#123456\", \"#aabbcc\"]"), (Colours{"#aabbcc", "#123456"}));
  EXPECT_EQ(colours("\"#AABBCC\""), Colours{"#aabbcc"});
  EXPECT_EQ(load_palette(job("\"ink\"", {"colour.palette=[\"#010203\"]"})), Colours{"#010203"});
}

TEST_F(Palettes, ComeFromFilesBesideTheJob) {
  folder_.write("lines.txt", "#0000FF\r\n\n  #00ff00 \n#0000ff");
  EXPECT_EQ(colours("\"lines.txt\""), (Colours{"#0000ff", "#00ff00"}));
  folder_.write("sea.gpl", "GIMP Palette\nName: Sea\nColumns: 2\n#\n  0 128 255\tsky\n 10  20  30\n");
  EXPECT_EQ(colours("\"sea.gpl\""), (Colours{"#0080ff", "#0a141e"}));
  EXPECT_EQ(job("\"sea.gpl\"").colour.palette, Colours{folder_.path("sea.gpl")});
  const std::string again = to_toml(job("\"sea.gpl\""));
  EXPECT_EQ(job_from_toml(again, "again").colour.palette, Colours{folder_.path("sea.gpl")});
}

/// A result is drawn later, and other ranks read the job, in places where the file may be missing.
TEST_F(Palettes, OfTheLibrarysChoiceAreInTheJob) {
  EXPECT_EQ(load_library_colours(job("\"ink\"")), Colours{}) << "all";
  folder_.write("lines.txt", "#0000FF\n#00ff00\n");
  const Job from_file = job("\"ink\"", {"library.colours=" + folder_.path("lines.txt")});
  EXPECT_EQ(from_file.library_colours, (Colours{"#0000ff", "#00ff00"}));
  EXPECT_EQ(job("\"ink\"", {"library.colours=ink"}).library_colours, load_palette(job("\"ink\"")));
  EXPECT_NE(test::message_of([&] { job("\"ink\"", {"library.colours=/duks"}); }).find("library.colours: /duks"),
            std::string::npos);
}

TEST_F(Palettes, SayWhatIsWrong) {
  EXPECT_NE(mistake("\"duks\"").find("job.toml: colour.palette: " + folder_.path("duks")), std::string::npos);
  EXPECT_NE(mistake("\"duks\"").find("(did you mean dusk?)"), std::string::npos);
  EXPECT_EQ(mistake("\"elsewhere\"").find("did you mean"), std::string::npos);
  EXPECT_NE(mistake("\"duks\"").find("allowed: dusk, forest, ink, a GIMP palette"), std::string::npos);
  folder_.write("bad.txt", "#000000\nred\n");
  EXPECT_NE(mistake("\"bad.txt\"").find("bad.txt:2: found \"red\", allowed: #rrggbb"), std::string::npos);
  folder_.write("bad.gpl", "GIMP Palette\n1 2 256 x\n");
  EXPECT_NE(mistake("\"bad.gpl\"").find("bad.gpl:2: found \"1 2 256 x\", allowed: red, green"), std::string::npos);
  folder_.write("empty.txt", "\n");
  EXPECT_NE(mistake("\"empty.txt\"").find("empty.txt: no colours in it"), std::string::npos);
  std::string many;
  for (int i = 0; i < 257; ++i) many += "#" + std::to_string(100'000 + i) + "\n";
  folder_.write("many.txt", many);
  EXPECT_NE(mistake("\"many.txt\"").find("257 colours, allowed: 256"), std::string::npos);
  folder_.write("large.txt", std::string(100'000, '\n'));
  EXPECT_NE(mistake("\"large.txt\"").find("large.txt"), std::string::npos);
  for (const char* palette :
       {"[]", "\"\"", "[\"dusk\"]", "[\"#123456\", \"forest\"]", "7", "\"#12345\"", "[\"#12345g\"]"}) {
    EXPECT_NE(mistake(palette).find("job.toml:4: colour.palette: found "), std::string::npos) << palette;
  }
}

/// Writes shapes with these lightnesses and spreads. Returns whether their library counts as one of silhouettes.
bool one_colour(const std::string& path, const std::vector<std::pair<float, float>>& colours) {
  LibraryWriter writer(path, {});
  Shape shape = test::RandomShape(1, 5).make();
  for (const auto& [lightness, spread] : colours) {
    shape.mean_lab = {lightness, 0, 0};
    shape.colour_spread = spread;
    writer.append(shape);
  }
  writer.finish();
  return is_of_one_colour(LibraryFile(path));
}

TEST_F(Palettes, SuitLibrariesOfOneColour) {
  const std::string path = folder_.path("a.h5");
  EXPECT_TRUE(one_colour(path, {{0, 0}, {1, 0.5f}, {4, 4}}));
  EXPECT_FALSE(one_colour(path, {{0, 0}, {0, 0}, {20, 0}})) << "another colour";
  EXPECT_FALSE(one_colour(path, {{0, 0}, {0, 0}, {0, 6}})) << "several colours in one";
  EXPECT_FALSE(one_colour(path, {{50, 30}})) << "one drawing in colours";
  EXPECT_FALSE(one_colour(path, {{0, -1}, {0, -1}})) << "a library that does not know";
  std::vector<std::pair<float, float>> many(20, {0, 0});
  many[3] = {90, 40};
  EXPECT_TRUE(one_colour(path, many)) << "nearly all";
  many[4] = {90, 0};
  EXPECT_FALSE(one_colour(path, many));
}

}  // namespace test_palette
}  // namespace tessera
