// The original file of a drawing: its own file, wherever that lies now, and never another one.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "artwork/images/sha256.h"
#include "render/pieces/artwork_original.h"
#include "support/images.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_artwork_original {

namespace fs = std::filesystem;

std::vector<std::uint8_t> bytes(const std::string& text) { return {text.begin(), text.end()}; }

class Original : public testing::Test {
 protected:
  void expect(const std::string& text, const std::string& reason) const {
    const ArtworkOriginal found = artwork_original(artwork_);
    EXPECT_EQ(std::string(found.bytes.begin(), found.bytes.end()), text);
    EXPECT_EQ(found.reason, reason);
  }

  test::ScratchFolder folder_;
  Artwork artwork_ = [&] {
    Artwork artwork;
    artwork.path = folder_.write("duck.svg", "<svg/>");
    artwork.sha256 = sha256_of(bytes("<svg/>"));
    return artwork;
  }();
};

TEST(Sha256, OfTheStandardsExample) {
  const Sha256 hash = sha256_of(bytes("abc"));
  EXPECT_EQ(hash[0], 0xba);
  EXPECT_EQ(hash[1], 0x78);
  EXPECT_EQ(hash[31], 0xad);
}

TEST_F(Original, IsTheFileOfTheBuild) { expect("<svg/>", ""); }

TEST_F(Original, AnEmbeddedOneNeedsNoFile) {
  artwork_.original = bytes("embedded");
  artwork_.path = "/none";
  expect("embedded", "");
}

// A foreign library could name a private file, but it cannot know the file's hash.
TEST_F(Original, AForeignPathIsNotDrawn) {
  artwork_.path = folder_.write("private.svg", "<svg>SECRET</svg>");
  expect("", kOriginalChanged);
  artwork_.path_beside_library = artwork_.path;
  expect("", kOriginalChanged);
  artwork_.sha256.reset();
  expect("", kOriginalUnknown);
}

/// The outline was made from the picture without its EXIF rotation.
TEST_F(Original, OfAnOlderLibraryIsNotDrawnWhereItIsTurnedNow) {
  const cv::Mat picture(20, 30, CV_8UC3, cv::Scalar(200, 40, 40));
  for (const std::uint8_t orientation : {1, 3, 6}) {
    artwork_.original = test::encoded_with_orientation(picture, ".jpg", orientation);
    artwork_.reader = 2;
    EXPECT_EQ(artwork_original(artwork_).reason, "");
    artwork_.reader = 1;
    EXPECT_EQ(artwork_original(artwork_).reason, orientation == 1 ? "" : kOriginalReadOtherwise);
    EXPECT_EQ(artwork_original(artwork_).bytes.empty(), orientation != 1);
  }
}

TEST_F(Original, AChangedFileIsNotDrawn) {
  folder_.write("duck.svg", "<svg>changed</svg>");
  expect("", kOriginalChanged);
}

TEST_F(Original, MovedWithTheLibrary) {
  artwork_.path_beside_library = folder_.path("moved.svg");
  fs::rename(folder_.path("duck.svg"), artwork_.path_beside_library);
  expect("<svg/>", "");
  fs::remove(artwork_.path_beside_library);
  expect("", kOriginalMissing);
}

TEST_F(Original, ALinkToTheFileIsTheFile) {
  fs::rename(folder_.path("duck.svg"), folder_.path("elsewhere.svg"));
  fs::create_symlink(folder_.path("elsewhere.svg"), folder_.path("duck.svg"));
  expect("<svg/>", "");
}

TEST_F(Original, PipesDevicesAndFoldersAreNotOpened) {
  fs::remove(artwork_.path);
  ASSERT_EQ(::mkfifo(artwork_.path.c_str(), 0600), 0);
  expect("", kOriginalNoFile);
  for (const char* path : {"/dev/zero", "/dev/tty", "/"}) {
    artwork_.path = path;
    expect("", kOriginalNoFile);
  }
}

}  // namespace test_artwork_original
}  // namespace tessera
