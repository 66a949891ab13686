// Damaged and harmful artwork.
#include <glib.h>
#include <gtest/gtest.h>

#include "artwork/artwork_render.h"
#include "core/base/error.h"
#include "support/artwork_samples.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_artwork_safety {

using test::area_fraction;
using test::area_px2;
using test::Bytes;
using test::disc_with_alpha;
using test::encoded;
using test::kDisc;
using test::svg;

std::string mistake(const Bytes& bytes) {
  try {
    make_silhouette(bytes, "some/file");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no mistake found";
}

void expect_mistake(const Bytes& bytes, const std::string& about) {
  const std::string message = mistake(bytes);
  EXPECT_TRUE(message.starts_with("some/file: ")) << message;
  EXPECT_NE(message.find(about), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(ArtworkSafety, NoOtherFileIsRead) {
  const test::ScratchFolder folder;
  const cv::Mat opaque(8, 8, CV_8UC3, cv::Scalar(0, 0, 255));
  const Bytes png = encoded(opaque, ".png");
  const std::string secret = folder.write("secret.png", std::string(png.begin(), png.end()));
  const std::string text = folder.write("secret.txt", "MMMMMMMM");
  for (const std::string& href : {"file://" + secret, secret, std::string("secret.png")}) {
    const std::string image = R"(<image width="100" height="50" xlink:href=")" + href + R"("/>)";
    EXPECT_EQ(area_px2(make_silhouette(svg(image), folder.path("a.svg"))), 0) << href;
  }
  const std::string include =
      R"(<text y="40" font-size="40"><xi:include xmlns:xi="http://www.w3.org/2001/XInclude" href="file://)" + text +
      R"(" parse="text"/></text>)";
  EXPECT_EQ(area_px2(make_silhouette(svg(include), folder.path("a.svg"))), 0);
}

TEST(ArtworkSafety, EmbeddedImagesAreDrawn) {  // the test above would notice a file that is read
  const Bytes png = encoded(cv::Mat(8, 8, CV_8UC3, cv::Scalar(0, 0, 255)), ".png");
  gchar* base64 = g_base64_encode(png.data(), png.size());
  const std::string image =
      std::string(R"(<image width="100" height="50" xlink:href="data:image/png;base64,)") + base64 + R"("/>)";
  g_free(base64);
  EXPECT_NEAR(area_fraction(make_silhouette(svg(image), "a.svg")), 0.5, 0.05);  // a square on a page twice as wide
}

TEST(ArtworkSafety, ExternalEntityIsNotRead) {
  const std::string text = R"(<!DOCTYPE svg [<!ENTITY x SYSTEM "file:///etc/hostname">]>)"
                           R"(<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><text>&x;</text></svg>)";
  expect_mistake(Bytes(text.begin(), text.end()), "not a readable SVG");
}

TEST(ArtworkSafety, DamagedFilesAreInputErrors) {
  Bytes cut = svg(kDisc);
  cut.resize(cut.size() / 2);
  expect_mistake(cut, "not a readable SVG");
  expect_mistake({}, "neither SVG nor");
  expect_mistake(Bytes(1000, 'x'), "neither SVG nor");
  expect_mistake(Bytes(1000, '<'), "not a readable SVG");
  expect_mistake({0x1f, 0x8b, 8, 0, 1, 2, 3}, "gzip");
  expect_mistake(svg(kDisc, R"(width="0" height="0")"), "no area");
  for (const std::string extension : {".png", ".jpg", ".bmp", ".webp", ".tiff"}) {
    Bytes image = encoded(disc_with_alpha(), extension);
    image.resize(40);
    EXPECT_THROW(make_silhouette(image, "a"), InputError) << extension;
  }
}

TEST(ArtworkSafety, LimitsAreEnforced) {
  Bytes bomb = encoded(disc_with_alpha(), ".png");
  for (const std::size_t at : {16, 20}) bomb[at + 1] = 1;  // claims 65,836 x 65,736 pixels
  expect_mistake(bomb, "more than the 50 million allowed");
  std::string laughs = R"(<defs><g id="l0"/>)";
  for (int i = 1; i < 12; ++i) {
    laughs += "<g id=\"l" + std::to_string(i) + "\">";
    for (int k = 0; k < 10; ++k) laughs += "<use xlink:href=\"#l" + std::to_string(i - 1) + "\"/>";
    laughs += "</g>";
  }
  expect_mistake(svg(laughs + "</defs><g display=\"inline\"><use xlink:href=\"#l11\"/></g>"), "referenced elements");
}

TEST(ArtworkFile, Reads) {
  const test::ScratchFolder folder;
  EXPECT_EQ(read_artwork_file(folder.write("a.svg", "abc")), (Bytes{'a', 'b', 'c'}));
  EXPECT_THROW(read_artwork_file(folder.path("missing.svg")), InputError);
  EXPECT_THROW(read_artwork_file(folder.path("")), InputError);
  EXPECT_THROW(read_artwork_file("/dev/zero"), InputError);
  EXPECT_THROW(read_artwork_file(folder.write("large.svg", std::string(kMaxArtworkFileBytes + 1, ' '))), InputError);
}

}  // namespace test_artwork_safety
}  // namespace tessera
