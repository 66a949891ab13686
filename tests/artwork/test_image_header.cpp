// Sizes from file headers, including headers that are wrong or end early.
#include "artwork/images/image_header.h"
#include "support/images.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace tessera {
namespace test_image_header {

using test::Bytes;

cv::Mat grey_page(int channels) { return cv::Mat(123, 457, CV_8UC(channels), cv::Scalar::all(200)); }

const std::vector<Bytes>& samples() {
  static const std::vector<Bytes> all = {test::encoded(grey_page(4), ".png"),
                                         test::encoded(grey_page(1), ".png"),
                                         test::bmp_of(grey_page(3)),
                                         test::jpeg_of(grey_page(3)),
                                         test::jpeg_of(grey_page(3), {.progressive = true}),
                                         test::webp_of(grey_page(4)),
                                         test::webp_of(grey_page(3), 50),
                                         test::webp_of(grey_page(3)),
                                         test::tiff_of(grey_page(4)),
                                         test::tiff_of(grey_page(1))};
  return all;
}

TEST(ImageHeader, SizeOfEveryFormat) {
  for (const Bytes& bytes : samples()) {
    const auto size = image_size_from_header(bytes);
    ASSERT_TRUE(size.has_value()) << "first bytes " << std::string(bytes.begin(), bytes.begin() + 4);
    EXPECT_EQ(size->width, 457);
    EXPECT_EQ(size->height, 123);
  }
}

TEST(ImageHeader, AnimationsAndPagesAreSeveralPictures) {
  for (const Bytes& bytes : samples()) EXPECT_FALSE(has_several_pictures(bytes));
  const cv::Mat first = grey_page(3), second = cv::Mat(123, 457, CV_8UC3, cv::Scalar::all(50));
  EXPECT_TRUE(has_several_pictures(test::animated_webp({first, second})));
  EXPECT_TRUE(has_several_pictures(test::tiff_of_pages({first, second})));
  Bytes animated = test::encoded(grey_page(4), ".png");
  const Bytes control = {0, 0, 0, 8, 'a', 'c', 'T', 'L', 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0};
  animated.insert(animated.begin() + 33, control.begin(), control.end());  // after the header chunk
  EXPECT_TRUE(has_several_pictures(animated));
}

TEST(ImageHeader, BmpFromTheTopHasNegativeHeight) {
  Bytes bytes = test::bmp_of(grey_page(3));
  const std::int32_t height = -123;
  for (int i = 0; i < 4; ++i) bytes[22 + std::size_t(i)] = std::uint8_t(std::uint32_t(height) >> 8 * i);
  EXPECT_EQ(image_size_from_header(bytes)->height, 123);
}

TEST(ImageHeader, OtherFilesHaveNoSize) {
  EXPECT_FALSE(image_size_from_header({}).has_value());
  EXPECT_FALSE(image_size_from_header(Bytes(100, 'x')).has_value());
}

TEST(ImageHeader, DamagedHeadersNeverReadBeyondTheEnd) {
  EXPECT_TRUE(rc::check([] {
    Bytes bytes = *rc::gen::elementOf(samples());
    bytes.resize(*rc::gen::inRange<std::size_t>(0, std::min<std::size_t>(bytes.size(), 600)));
    const Bytes exact(bytes);  // a sanitizer detects a read beyond the last byte
    image_size_from_header(exact);
    for (std::size_t i = 4; i < bytes.size(); i += *rc::gen::inRange<std::size_t>(1, 40))
      bytes[i] = *rc::gen::arbitrary<std::uint8_t>();
    image_size_from_header(Bytes(bytes));
  }));
}

}  // namespace test_image_header
}  // namespace tessera
