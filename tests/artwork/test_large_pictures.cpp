// Small files with the largest allowed number of pixels: no process needs more than 512 MiB for them.
#include <gtest/gtest.h>
#include <zlib.h>

#include "artwork/images/reduced_picture.h"
#include "drawer_samples.h"
#include "support/large_file.h"
#include "support/limited_child.h"

namespace tessera {
namespace test_large_pictures {

constexpr int kWidth_px = 7000, kHeight_px = 7100;

void add_number(std::uint32_t number, test::Bytes& to) {
  for (int shift = 24; shift >= 0; shift -= 8) to.push_back(std::uint8_t(number >> shift));
}

void add_chunk(const std::string& name, const test::Bytes& data, test::Bytes& to) {
  test::Bytes named(name.begin(), name.end());
  named.insert(named.end(), data.begin(), data.end());
  add_number(std::uint32_t(data.size()), to);
  to.insert(to.end(), named.begin(), named.end());
  add_number(std::uint32_t(crc32(0, named.data(), uInt(named.size()))), to);
}

/// A PNG whose rows repeat the bytes `left` on the left, and are zero on the right.
test::Bytes png(std::uint8_t bits, std::uint8_t colour_type, int bits_per_pixel, const test::Bytes& left) {
  test::Bytes row(1 + std::size_t(kWidth_px * bits_per_pixel + 7) / 8, 0);
  for (std::size_t i = 1; i < row.size() / 2; ++i) row[i] = left[(i - 1) % left.size()];
  test::Bytes packed(kHeight_px * (row.size() / 100 + 100)), head;
  test::Bytes file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  z_stream stream{};
  deflateInit(&stream, 1);
  stream.next_out = packed.data();
  stream.avail_out = uInt(packed.size());
  for (int y = 0; y < kHeight_px; ++y) {
    stream.next_in = row.data();
    stream.avail_in = uInt(row.size());
    deflate(&stream, y + 1 < kHeight_px ? Z_NO_FLUSH : Z_FINISH);
  }
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  add_number(kWidth_px, head);
  add_number(kHeight_px, head);
  for (const std::uint8_t value : {bits, colour_type, std::uint8_t(0), std::uint8_t(0), std::uint8_t(0)})
    head.push_back(value);
  add_chunk("IHDR", head, file);
  add_chunk("IDAT", packed, file);
  add_chunk("IEND", {}, file);
  return file;
}

/// `draw` returns what is wrong, or an empty text. The limits hold for the reading process and its drawer.
template <class Draw>
void expect_bounded(const std::string& name, const test::Bytes& file, DrawerSettings settings, Draw draw) {
#ifdef __SANITIZE_ADDRESS__  // the sanitizer's memory counts as the drawer's, and it hangs without enough
  settings.bytes_per_process = std::size_t(4) << 30;
#endif
  const test::ChildReport report = test::in_child([&]() -> std::string {
    try {
      Drawers drawers(settings);
      return draw(drawers, file);
    } catch (const std::exception& error) {
      return error.what();
    }
  });
  EXPECT_EQ(report.death, "") << name;
  EXPECT_EQ(report.said, "") << name;
  EXPECT_LT(report.peak_bytes, test::kMostOfReader_bytes) << name;
}

void expect_all_bounded(const std::string& name, const test::Bytes& file) {
  expect_bounded(name + ", drawn", file, {}, [](Drawers& drawers, const test::Bytes& bytes) -> std::string {
    const cv::Mat page = drawers.render(bytes, "a.png", 600);
    const int left = page.at<cv::Vec4b>(300, 100)[3], right = page.at<cv::Vec4b>(300, 500)[3];
    return page.rows == 600 && std::abs(left - right) == 255 ? "" : "another page";
  });
  expect_bounded(name + ", its size", file, {}, [](Drawers& drawers, const test::Bytes& bytes) -> std::string {
    return drawers.natural_size(bytes, "a.png") == cv::Size2d(kWidth_px, kHeight_px) ? "" : "another size";
  });
  expect_bounded(
      name + ", all that it shows", file, photo_drawer_settings(1),
      [](Drawers& drawers, const test::Bytes& bytes) -> std::string {
        const cv::Mat page = drawers.whole_picture(bytes, "a.png", 8192);
        const double factor = double(kHeight_px) / page.rows;
        return page.total() <= kMostWorkedPixels && std::abs(page.cols * factor - kWidth_px) < 2 ? "" : "another page";
      });
}

TEST(LargePictures, StayWithinTheBound) {
  expect_all_bounded("grey of 1 bit", png(1, 0, 1, {255}));
  expect_all_bounded("RGB of 16 bits", png(16, 2, 48, {255}));
  expect_all_bounded("RGBA of 16 bits", png(16, 6, 64, {200, 0, 30, 0, 30, 0, 255, 255}));
}

cv::Mat gradient(cv::Size size) {
  cv::Mat picture(size, CV_16UC4);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x)
      picture.at<cv::Vec4w>(y, x) = {std::uint16_t(x * 257), std::uint16_t(y * 257), 0, 65535};
  }
  return picture;
}

TEST(ReducedPicture, RowsAreGivenBackOnlyAfterTheyWereRead) {
  const cv::Mat large(2'000, 2'000, CV_8UC3, cv::Scalar(10, 20, 30));
  const cv::Mat reduced = reduced_picture(large.clone(), 1'000'000);
  EXPECT_EQ(cv::norm(reduced, cv::Mat(reduced.size(), CV_8UC3, cv::Scalar(10, 20, 30)), cv::NORM_INF), 0);
}

TEST(ReducedPicture, KeepsPlacesAndSmallPictures) {
  const cv::Mat small = gradient({200, 250});
  cv::Mat eight;
  small.convertTo(eight, CV_8U, 1. / 257);
  EXPECT_TRUE(test::equal(reduced_picture(eight, 50'000), eight));
  EXPECT_TRUE(test::equal(reduced_picture(small.clone(), 50'000), eight));
  const cv::Mat reduced = reduced_picture(small.clone(), 30'000);  // each side is reduced to 8 / 11
  ASSERT_EQ(reduced.size(), cv::Size(145, 182));
  for (int y = 0; y < reduced.rows; ++y) {
    for (int x = 0; x < reduced.cols; ++x) {
      EXPECT_NEAR(reduced.at<cv::Vec4b>(y, x)[0], (x + 0.5) * 200 / 145 - 0.5, 1);
      EXPECT_NEAR(reduced.at<cv::Vec4b>(y, x)[1], (y + 0.5) * 11 / 8 - 0.5, 1.2);
    }
  }
}

}  // namespace test_large_pictures
}  // namespace tessera
