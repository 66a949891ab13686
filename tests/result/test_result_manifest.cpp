// The fields that a folder's manifest must have before the program trusts the folder.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "result/collage_files.h"
#include "result/folder/result_manifest.h"
#include "support/input_error.h"
#include "support/sample_collage.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_result_manifest {

TEST(ResultManifest, of_another_format_is_refused) {
  const test::ScratchFolder scratch;
  const test::SampleCollage sample;
  const std::string dir = scratch.path("");
  publish_result(dir, sample.report, sample.source(), true);
  const std::string path = scratch.path(kManifestName);
  std::ifstream file(path);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::string format = "\"format\":1";
  ASSERT_NE(text.find(format), std::string::npos);
  EXPECT_TRUE(read_manifest(dir).finished);
  text.replace(text.find(format), format.size(), "\"format\":2");
  scratch.write(kManifestName, text);
  EXPECT_EQ(test::message_of([&] { read_manifest(dir); }), path + ": another format than 1");
}

TEST(ResultManifest, keeps_the_colours_of_silhouettes) {
  const test::ScratchFolder scratch;
  test::SampleCollage sample;
  const std::string dir = scratch.path("");
  publish_result(dir, sample.report, sample.source(), true);
  EXPECT_TRUE(read_manifest(dir).colours.empty());
  sample.report.colours = {"#123456", "#abcdef"};
  publish_result(dir, sample.report, sample.source(), true);
  EXPECT_EQ(read_manifest(dir).colours, sample.report.colours);
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"#123456"}, {"#123456", "url(x)"}}) {
    sample.report.colours = wrong;
    publish_result(dir, sample.report, sample.source(), true);
    EXPECT_NE(test::message_of([&] { read_manifest(dir); }).find(kManifestName), std::string::npos) << wrong.back();
  }
}

TEST(ResultManifest, counts_what_is_missing) {
  const test::ScratchFolder scratch;
  test::SampleCollage sample;
  const std::string dir = scratch.path("");
  publish_result(dir, sample.report, sample.source(), true);
  EXPECT_TRUE(read_manifest(dir).complete());
  sample.report.missing = {{ShapeId{0}, "ant", 5, 3}, {ShapeId{1}, "bee", 1, 0}};
  publish_result(dir, sample.report, sample.source(), true);
  EXPECT_EQ(read_manifest(dir).missing, 3u);
  EXPECT_FALSE(read_manifest(dir).complete());
  sample.report.missing.clear();
  sample.report.placements.clear();
  publish_result(dir, sample.report, sample.source(), true);
  EXPECT_FALSE(read_manifest(dir).complete()) << "without a piece";
}

TEST(ResultManifest, keeps_what_the_collage_began_from) {
  const test::ScratchFolder scratch;
  test::SampleCollage sample;
  const std::string dir = scratch.path("");
  publish_result(dir, sample.report, sample.source(), true);
  EXPECT_TRUE(read_manifest(dir).start.empty());
  sample.job.start.pieces = scratch.path("old.geojson");
  sample.job.start.digest = 0x0123456789abcdef;
  publish_result(dir, sample.report, sample.source(), true);
  EXPECT_EQ(read_manifest(dir).start, scratch.path("old.geojson"));
  EXPECT_EQ(read_manifest(dir).start_digest, 0x0123456789abcdefu);
}

TEST(ResultManifest, keeps_what_was_drawn_and_reads_what_earlier_versions_said) {
  const test::ScratchFolder scratch;
  const test::SampleCollage sample;
  const std::string dir = scratch.path("");
  publish_result(dir, sample.report, sample.source(), true);
  ResultManifest manifest = read_manifest(dir);
  manifest.pictures = {{"collage.svg", {.width_px = 300, .background = "#102030"}},
                       {"collage.png",
                        {.width_px = 1177,
                         .width_mm = 100,
                         .dpi = 299,
                         .background = kNoColour,
                         .outline_px = 2,
                         .outline_colour = "#123456",
                         .shadow_strength = 0.25,
                         .shadow_offset_px = {-1, 7},
                         .shadow_blur_px = 9,
                         .clip = kNoClip,
                         .keep_out = "artwork",
                         .ground = "/mortar.png",
                         .ground_px = 333},
                        std::vector<std::string>{"#123456"},
                        12,
                        Harmony{HarmonicTemplate::Y, 359},
                        0.25}};
  write_manifest(dir, manifest);
  EXPECT_EQ(read_manifest(dir).pictures, manifest.pictures);
  std::ifstream file(scratch.path(kManifestName));
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto begin = text.find("{\"file\"", text.find("\"pictures\":"));
  text.replace(begin, text.rfind(']') - begin, R"({"file":"collage.svg","width_px":300,"background":"#102030"})");
  scratch.write(kManifestName, text);
  ASSERT_EQ(read_manifest(dir).pictures.size(), 1u);
  EXPECT_EQ(read_manifest(dir).pictures[0], manifest.pictures[0]);
}

}  // namespace test_result_manifest
}  // namespace tessera
