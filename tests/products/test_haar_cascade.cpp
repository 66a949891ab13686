// Windows that a cascade accepts, and files without a cascade.
#include <gtest/gtest.h>

#include <string>

#include "core/base/error.h"
#include "products/mosaic/haar_cascade_file.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_haar_cascade {

/// One tree of two nodes in a window of 20 x 20 px. It accepts windows that are bright in the middle, but not everywhere.
struct Cascade {
  std::string rects = "<_>0 0 20 20 -1.</_><_>5 5 10 10 4.</_>";
  std::string nodes = "0 1 0 1.7 -1 -2 1 2";
  std::string leaves = "0. 1. 0.";
  std::string tilted = "<tilted>0</tilted>";
  std::string kind = "HAAR";
  std::string width = "20";
  std::string declaration = "";
};

std::string xml_of(const Cascade& c) {
  return "<?xml version=\"1.0\"?>" + c.declaration +
         "<opencv_storage><cascade><stageType>BOOST</stageType><featureType>" + c.kind +
         "</featureType><height>20</height><width>" + c.width +
         "</width><stages><_><stageThreshold>0.5</stageThreshold><weakClassifiers><_><internalNodes>" + c.nodes +
         "</internalNodes><leafValues>" + c.leaves + "</leafValues></_></weakClassifiers></_></stages><features>" +
         "<_><rects>" + c.rects + "</rects>" + c.tilted + "</_>" +
         "<_><rects><_>0 0 20 20 1.</_></rects></_></features></cascade></opencv_storage>";
}

HaarCascade cascade(const Cascade& written = {}) {
  const test::ScratchFolder folder;
  return read_haar_cascade(folder.write("cascade.xml", xml_of(written)));
}

/// A black picture with a white square at (60, 40).
cv::Mat picture(int side_px) {
  cv::Mat grey(200, 240, CV_8U, cv::Scalar(0));
  grey(cv::Rect(60, 40, side_px, side_px)) = 255;
  return grey;
}

bool is_refused(const std::string& xml) {
  const test::ScratchFolder folder;
  try {
    read_haar_cascade(folder.write("cascade.xml", xml));
  } catch (const InputError& error) {
    return std::string(error.what()).find("cascade.xml: is no cascade of upright Haar-like") != std::string::npos;
  }
  return false;
}

TEST(HaarCascade, FindsItsPatternAtAllSizes) {
  for (const int side_px : {13, 24, 40}) {
    const std::vector<HaarHit> hits = cascade().find(picture(side_px), 20, 200, 1);
    ASSERT_EQ(hits.size(), 1u) << side_px;
    const cv::Rect box = hits[0].box_px;
    EXPECT_NEAR(box.x + box.width / 2., 60 + side_px / 2., 0.1 * side_px);
    EXPECT_NEAR(box.y + box.height / 2., 40 + side_px / 2., 0.1 * side_px);
    EXPECT_NEAR(box.width, 2 * side_px, 0.2 * side_px);
  }
}

TEST(HaarCascade, FindsNothingWhereThePatternIsInverseOrFaint) {
  EXPECT_TRUE(cascade().find(255 - picture(40), 20, 200, 1).empty());
  EXPECT_TRUE(cascade().find(picture(40) / 16, 20, 200, 1).empty());
  EXPECT_TRUE(cascade().find(cv::Mat(5, 300, CV_8U, cv::Scalar(9)), 20, 200, 1).empty());
  EXPECT_TRUE(cascade().find(cv::Mat(1, 1, CV_8U, cv::Scalar(9)), 20, 200, 1).empty());
}

TEST(HaarCascade, KeepsToTheSizesAskedFor) {
  EXPECT_TRUE(cascade().find(picture(40), 20, 60, 1).empty());
  EXPECT_TRUE(cascade().find(picture(24), 70, 200, 1).empty());
}

TEST(HaarCascade, PutsTheSurestFirstAndLeavesOutTheOthers) {
  cv::Mat two = picture(40);
  two(cv::Rect(150, 120, 13, 13)) = 255;
  const std::vector<HaarHit> hits = cascade().find(two, 20, 200, 1);
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_GT(hits[0].windows, hits[1].windows);
  EXPECT_EQ(cascade().find(two, 20, 200, hits[0].windows).size(), 1u);
}

TEST(HaarCascade, EndsSoonWhereEveryWindowIsAccepted) {
  cv::Mat noise(480, 640, CV_8U);
  cv::RNG(7).fill(noise, cv::RNG::UNIFORM, 0, 256);
  EXPECT_FALSE(cascade({.leaves = "1. 1. 1."}).find(noise, 20, 480, 1).empty());
}

TEST(HaarCascade, RefusesWhatIsNone) {
  ASSERT_FALSE(is_refused(xml_of({})));
  for (const char* text : {"", "text", "<?xml version=\"1.0\"?>", "<?xml version=\"1.0\"?><opencv_storage/>"})
    EXPECT_TRUE(is_refused(text)) << text;
  const std::string whole = xml_of({});
  for (std::size_t length = 0; length < whole.size(); length += 7)
    EXPECT_TRUE(is_refused(whole.substr(0, length))) << length;
}

TEST(HaarCascade, RefusesWhatWouldReadElsewhere) {
  EXPECT_TRUE(is_refused(xml_of({.kind = "LBP"})));
  EXPECT_TRUE(is_refused(xml_of({.tilted = "<tilted>1</tilted>"})));
  for (const char* width : {"0", "2", "-20", "19", "2000000000", "x"})
    EXPECT_TRUE(is_refused(xml_of({.width = width})));
  for (const char* rects :
       {"<_></_>", "<_>0 0 20 21 -1.</_>", "<_>0 0 20 20 -1.</_><_>0 0 20 2.</_>",
        "<_>0 0 20 21 -1.</_><_>0 0 20 10 2.</_>", "<_>-1 0 20 20 -1.</_><_>0 0 20 10 2.</_>",
        "<_>0 0 -5 20 -1.</_><_>0 0 20 10 2.</_>", "<_>2147483647 0 2147483647 20 -1.</_><_>0 0 20 10 2.</_>",
        "<_>0 0 2.5 20 -1.</_><_>0 0 20 10 2.</_>"})
    EXPECT_TRUE(is_refused(xml_of({.rects = rects}))) << rects;
  for (const char* nodes : {"", "0 1 0", "0 1 2 0.8 -1 -2 1 2", "0 1 -1 0.8 -1 -2 1 2", "0 2 0 0.8 -1 -2 1 2",
                            "0 1 0 0.8 1 -2 1 2", "0 1 0 0.8 -3 -2 1 2", "0 1 0 0.8 -2147483648 -2 1 2"})
    EXPECT_TRUE(is_refused(xml_of({.nodes = nodes}))) << nodes;
  for (const char* leaves : {"", "1.", "0. 1. nan", "0. 1. 1e999", "0. 1. x"})
    EXPECT_TRUE(is_refused(xml_of({.leaves = leaves}))) << leaves;
  EXPECT_TRUE(is_refused(xml_of({.declaration = "<!DOCTYPE a [<!ENTITY b \"0.\">]>"})));
}

}  // namespace test_haar_cascade
}  // namespace tessera
