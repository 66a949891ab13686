// The readers of picture formats: they return the stored pixels, and refuse cut, damaged and harmful files.
#include "artwork/images/formats/image_readers.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>

#include "artwork/images/formats/orientation.h"
#include "artwork/images/image_decoding.h"
#include "core/base/error.h"
#include "support/images.h"

namespace tessera {
namespace test_image_readers {

using test::Bytes;

/// A picture that differs in every pixel and channel, with no two equal rows or columns.
cv::Mat pattern(int type, cv::Size size = {37, 22}) {
  cv::Mat image(size, type);
  const int channels = image.channels();
  for (int y = 0; y < image.rows; ++y) {
    for (int i = 0; i < image.cols * channels; ++i) {
      const int value = i * i * 7 + y * 1009 + i * y * 13;
      if (image.depth() == CV_8U) {
        image.ptr(y)[i] = std::uint8_t(value);
      } else {
        image.ptr<std::uint16_t>(y)[i] = std::uint16_t(value * 577);
      }
    }
  }
  return image;
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0;
}

std::string mistake(const Bytes& bytes) {
  try {
    test::decoded(bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no mistake found";
}

// BMPs built by hand, as hardly any program still writes most of their variants.

struct Bmp {
  std::uint32_t bits = 8;
  std::uint32_t compression = 0;
  cv::Size size{5, 3};
  Bytes pixels = {};
  Bytes palette = {};                     // blue, green, red, 0 each
  std::vector<std::uint32_t> masks = {};  // red, green, blue, alpha
  std::uint32_t header_bytes = 40;
};

void add(Bytes& bytes, std::uint32_t number, int width) {
  for (int i = 0; i < width; ++i) bytes.push_back(std::uint8_t(number >> 8 * i));
}

Bytes file_of(const Bmp& bmp) {
  Bytes header;
  add(header, bmp.header_bytes, 4);
  const int side_bytes = bmp.header_bytes == 12 ? 2 : 4;
  add(header, std::uint32_t(bmp.size.width), side_bytes);
  add(header, std::uint32_t(bmp.size.height), side_bytes);
  add(header, 1, 2);
  add(header, bmp.bits, 2);
  if (bmp.header_bytes > 12) {
    add(header, bmp.compression, 4);
    for (int i = 0; i < 3; ++i) add(header, 0, 4);
    add(header, std::uint32_t(bmp.palette.size() / 4), 4);
    add(header, 0, 4);
  }
  for (const std::uint32_t mask : bmp.masks) add(header, mask, 4);
  header.resize(std::max<std::size_t>(header.size(), bmp.header_bytes));
  Bytes file = {'B', 'M'};
  const auto pixels_at = std::uint32_t(14 + header.size() + bmp.palette.size());
  for (const std::uint32_t number : {pixels_at + std::uint32_t(bmp.pixels.size()), 0u, pixels_at}) add(file, number, 4);
  for (const Bytes& part : {header, bmp.palette, bmp.pixels}) file.insert(file.end(), part.begin(), part.end());
  return file;
}

/// A palette of black, blue, green, red, white and greys.
Bytes colour_palette(std::size_t colours) {
  Bytes palette = {0, 0, 0, 0, 255, 0, 0, 0, 0, 255, 0, 0, 0, 0, 255, 0, 255, 255, 255, 0};
  palette.resize(4 * colours, 77);
  return palette;
}

const cv::Vec3b kBlack(0, 0, 0), kBlue(255, 0, 0), kGreen(0, 255, 0), kRed(0, 0, 255), kWhite(255, 255, 255);

/// A BMP with runs, literal pixels, a skip of two columns and a row, and an early end.
Bmp bmp_of_runs() {
  Bmp bmp{.compression = 1, .palette = colour_palette(256)};
  bmp.pixels = {5, 1, 0, 0, 0, 3, 2, 3, 4, 0, 0, 2, 1, 1, 1, 3, 0, 1};
  return bmp;
}

Bmp bmp_of_nibble_runs() {
  Bmp bmp{.bits = 4, .compression = 2, .palette = colour_palette(16)};
  bmp.pixels = {5, 0x12, 0, 0, 0, 5, 0x23, 0x41, 0x20, 0, 0, 0, 3, 0x33, 2, 0x44, 0, 1};
  return bmp;
}

const std::map<std::string, Bytes>& samples() {
  static const std::map<std::string, Bytes> all = {
      {"grey PNG", test::encoded(pattern(CV_8UC1), ".png")},
      {"PNG with alpha", test::encoded(pattern(CV_8UC4), ".png")},
      {"PNG of 16 bits", test::encoded(pattern(CV_16UC3), ".png")},
      {"JPEG", test::jpeg_of(pattern(CV_8UC3))},
      {"grey JPEG", test::jpeg_of(pattern(CV_8UC1))},
      {"CMYK JPEG", test::jpeg_of(pattern(CV_8UC4))},
      {"progressive JPEG", test::jpeg_of(pattern(CV_8UC3), {.quality = 70, .progressive = true})},
      {"arithmetic JPEG", test::jpeg_of(pattern(CV_8UC3), {.quality = 70, .arithmetic = true})},
      {"WebP", test::webp_of(pattern(CV_8UC3))},
      {"WebP with alpha", test::webp_of(pattern(CV_8UC4))},
      {"lossy WebP", test::webp_of(pattern(CV_8UC3), 60)},
      {"lossy WebP with alpha", test::webp_of(pattern(CV_8UC4), 60)},
      {"TIFF", test::tiff_of(pattern(CV_8UC3))},
      {"plain TIFF", test::tiff_of(pattern(CV_8UC4), {.compression = COMPRESSION_NONE})},
      {"deflated TIFF", test::tiff_of(pattern(CV_8UC1), {.compression = COMPRESSION_ADOBE_DEFLATE})},
      {"JPEG in a TIFF", test::tiff_of(pattern(CV_8UC3), {.compression = COMPRESSION_JPEG})},
      {"TIFF of tiles", test::tiff_of(pattern(CV_8UC3), {.tile_px = 16})},
      {"TIFF of 16 bits", test::tiff_of(pattern(CV_16UC3))},
      {"TIFF of 16 bits in tiles", test::tiff_of(pattern(CV_16UC1), {.tile_px = 16})},
      {"grey BMP", test::bmp_of(pattern(CV_8UC1))},
      {"BMP", test::bmp_of(pattern(CV_8UC3))},
      {"BMP of runs", file_of(bmp_of_runs())},
      {"BMP of nibble runs", file_of(bmp_of_nibble_runs())}};
  return all;
}

TEST(ImageReaders, GiveThePixelsThatWereStored) {
  for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4, CV_16UC1, CV_16UC3, CV_16UC4}) {
    EXPECT_TRUE(same(test::decoded(test::encoded(pattern(type), ".png")), pattern(type))) << type;
    EXPECT_TRUE(same(test::decoded(test::tiff_of(pattern(type))), pattern(type))) << type;
    EXPECT_TRUE(same(test::decoded(test::tiff_of(pattern(type), {.tile_px = 16})), pattern(type))) << type;
  }
  for (const int type : {CV_8UC3, CV_8UC4}) {
    cv::Mat image = pattern(type);
    if (type == CV_8UC4) image.reshape(1).col(3) = 200;  // a fully transparent pixel has no colour in a WebP
    for (int x = 0; type == CV_8UC4 && x < image.cols; ++x) image.reshape(1).col(4 * x + 3) = 200 - x;
    EXPECT_TRUE(same(test::decoded(test::webp_of(image)), image)) << type;
  }
  for (const int type : {CV_8UC1, CV_8UC3})
    EXPECT_TRUE(same(test::decoded(test::bmp_of(pattern(type))), pattern(type))) << type;
  for (const int compression :
       {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS, COMPRESSION_ZSTD}) {
    EXPECT_TRUE(same(test::decoded(test::tiff_of(pattern(CV_8UC4), {.compression = compression})), pattern(CV_8UC4)))
        << compression;
  }
}

TEST(ImageReaders, JpegIsNearWhatWasStored) {
  cv::Mat smooth(40, 60, CV_8UC3);
  for (int y = 0; y < smooth.rows; ++y) {
    for (int x = 0; x < smooth.cols; ++x)
      smooth.at<cv::Vec3b>(y, x) = cv::Vec3b(std::uint8_t(4 * x), std::uint8_t(5 * y), 90);
  }
  for (const bool progressive : {false, true}) {
    const cv::Mat read = test::decoded(test::jpeg_of(smooth, {.progressive = progressive}));
    ASSERT_EQ(read.type(), CV_8UC3);
    EXPECT_LT(cv::norm(read, smooth, cv::NORM_INF), 12);
  }
  EXPECT_EQ(test::decoded(test::jpeg_of(pattern(CV_8UC1))).type(), CV_8UC1);
  // Adobe's programs invert CMYK: 255 is no ink.
  const cv::Mat cyan(16, 16, CV_8UC4, cv::Scalar(0, 255, 255, 255));
  EXPECT_LT(
      cv::norm(test::decoded(test::jpeg_of(cyan)), cv::Mat(16, 16, CV_8UC3, cv::Scalar(255, 255, 0)), cv::NORM_INF), 4);
}

TEST(ImageReaders, EightBitsWhereTheyAreAskedFor) {
  for (const Bytes& bytes : {test::encoded(pattern(CV_16UC3), ".png"), test::tiff_of(pattern(CV_16UC3))}) {
    const cv::Mat eight = decode_image(bytes, "a", PixelBits::eight).pixels;
    ASSERT_EQ(eight.type(), CV_8UC3);
    cv::Mat rounded;
    pattern(CV_16UC3).convertTo(rounded, CV_8U, 1. / 257);
    EXPECT_LE(cv::norm(eight, rounded, cv::NORM_INF), 1);
  }
}

cv::Mat turned_by_hand(const cv::Mat& stored, int orientation) {
  cv::Mat seen(orientation >= 5 ? cv::Size(stored.rows, stored.cols) : stored.size(), stored.type());
  for (int y = 0; y < seen.rows; ++y) {
    for (int x = 0; x < seen.cols; ++x) {
      const int right = seen.cols - 1 - x, up = seen.rows - 1 - y;
      const cv::Point from[] = {{x, y}, {right, y}, {right, up}, {x, up}, {y, x}, {y, right}, {up, right}, {up, x}};
      seen.at<cv::Vec3b>(y, x) = stored.at<cv::Vec3b>(from[orientation - 1]);
    }
  }
  return seen;
}

TEST(ImageReaders, ATiffIsTurnedAsItSays) {
  for (int orientation = 1; orientation <= 8; ++orientation) {
    const cv::Mat seen = turned_by_hand(pattern(CV_8UC3), orientation);
    EXPECT_TRUE(same(turned_upright(pattern(CV_8UC3), orientation), seen)) << orientation;
    for (const int tile_px : {0, 16}) {
      const Bytes bytes = test::tiff_of(pattern(CV_8UC3), {.tile_px = tile_px, .orientation = orientation});
      EXPECT_TRUE(same(upright_pixels(decode_image(bytes, "picture", PixelBits::as_stored)), seen)) << orientation;
    }
  }
}

TEST(Orientation, OfDamagedExifDataIsUpright) {
  const Bytes exif = {'I', 'I', 42, 0, 8, 0, 0, 0, 1, 0, 0x12, 1, 3, 0, 1, 0, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(exif_orientation(exif), 6);
  for (std::size_t bytes = 0; bytes < 20; ++bytes)
    EXPECT_EQ(exif_orientation(Bytes(exif.begin(), exif.begin() + std::ptrdiff_t(bytes))), 1) << bytes;
  for (const int value : {0, 9, 255}) {
    Bytes odd = exif;
    odd[18] = std::uint8_t(value);
    EXPECT_EQ(exif_orientation(odd), 1) << value;
  }
}

/// Tries every end of the file, and any lengths in it.
TEST(Orientation, IsFoundInFilesThatEndAnywhere) {
  for (const char* extension : {".jpg", ".png", ".webp"}) {
    const Bytes whole = test::encoded_with_orientation(pattern(CV_8UC3), extension, 6);
    EXPECT_EQ(orientation_in_file(whole), 6) << extension;
    for (std::size_t bytes = 0; bytes < whole.size(); ++bytes) {
      const int found = orientation_in_file({whole.data(), bytes});
      EXPECT_TRUE(found == 1 || found == 6) << extension << " " << bytes;
      Bytes forged = whole;
      forged[bytes] ^= 0xff;
      const int in_forged = orientation_in_file(forged);
      EXPECT_TRUE(in_forged >= 1 && in_forged <= 8) << extension << " " << bytes;
    }
  }
  EXPECT_EQ(orientation_in_file(test::encoded(pattern(CV_8UC3), ".jpg")), 1);
}

TEST(BmpReader, RunsSkipsAndPixelsAsTheyAre) {
  const cv::Mat image = test::decoded(file_of(bmp_of_runs()));
  ASSERT_EQ(image.type(), CV_8UC3);
  const cv::Vec3b rows[3][5] = {{kBlack, kBlack, kBlack, kBlack, kRed},  // the lowest row is stored first
                                {kGreen, kRed, kWhite, kBlack, kBlack},
                                {kBlue, kBlue, kBlue, kBlue, kBlue}};
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) EXPECT_EQ(image.at<cv::Vec3b>(y, x), rows[y][x]) << x << " " << y;
  }
}

TEST(BmpReader, RunsOfNibbles) {
  const cv::Mat image = test::decoded(file_of(bmp_of_nibble_runs()));
  ASSERT_EQ(image.type(), CV_8UC3);
  const cv::Vec3b rows[3][5] = {
      {kRed, kRed, kRed, kWhite, kWhite}, {kGreen, kRed, kWhite, kBlue, kGreen}, {kBlue, kGreen, kBlue, kGreen, kBlue}};
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) EXPECT_EQ(image.at<cv::Vec3b>(y, x), rows[y][x]) << x << " " << y;
  }
}

TEST(BmpReader, FewBits) {
  const Bmp nibbles{.bits = 4, .size = {3, 1}, .pixels = {0x12, 0x30, 0, 0}, .palette = colour_palette(16)};
  cv::Mat image = test::decoded(file_of(nibbles));
  EXPECT_EQ(image.at<cv::Vec3b>(0, 0), kBlue);
  EXPECT_EQ(image.at<cv::Vec3b>(0, 1), kGreen);
  EXPECT_EQ(image.at<cv::Vec3b>(0, 2), kRed);
  const Bmp bits{.bits = 1, .size = {9, 1}, .pixels = {0x40, 0x80, 0, 0}, .palette = {0, 0, 0, 0, 255, 255, 255, 0}};
  image = test::decoded(file_of(bits));
  ASSERT_EQ(image.type(), CV_8UC1);  // its palette is grey
  for (int x = 0; x < 9; ++x) EXPECT_EQ(image.at<std::uint8_t>(0, x), x == 1 || x == 8 ? 255 : 0) << x;
}

TEST(BmpReader, Masks) {
  Bmp bmp{.bits = 16, .compression = 3, .size = {2, 1}, .pixels = {0x00, 0xf8, 0xe0, 0x07}};
  bmp.masks = {0xf800, 0x7e0, 0x1f};
  EXPECT_EQ(test::decoded(file_of(bmp)).at<cv::Vec3b>(0, 0), cv::Vec3b(0, 0, 248));
  EXPECT_EQ(test::decoded(file_of(bmp)).at<cv::Vec3b>(0, 1), cv::Vec3b(0, 252, 0));
  bmp = {.bits = 32, .compression = 3, .size = {1, 1}, .pixels = {1, 2, 3, 4}, .header_bytes = 124};
  bmp.masks = {0xff, 0xff00, 0xff0000, 0xff000000};
  ASSERT_EQ(test::decoded(file_of(bmp)).type(), CV_8UC4);
  EXPECT_EQ(test::decoded(file_of(bmp)).at<cv::Vec4b>(0, 0), cv::Vec4b(3, 2, 1, 4));
  bmp.masks[3] = 0;
  EXPECT_EQ(test::decoded(file_of(bmp)).type(), CV_8UC3);
}

TEST(BmpReader, OfOs2) {
  const Bmp bmp{.bits = 24, .size = {1, 1}, .pixels = {9, 8, 7, 0}, .header_bytes = 12};
  EXPECT_EQ(test::decoded(file_of(bmp)).at<cv::Vec3b>(0, 0), cv::Vec3b(9, 8, 7));
}

TEST(BmpReader, RunsThatLeaveThePictureAreRefused) {
  for (const Bytes& pixels : {Bytes{6, 1, 0, 1}, Bytes{0, 2, 200, 0, 1, 1, 0, 1}, Bytes{0, 6, 1, 1, 1, 1, 1, 1}}) {
    Bmp bmp = bmp_of_runs();
    bmp.pixels = pixels;
    EXPECT_EQ(mistake(file_of(bmp)), "picture: a damaged image");
  }
}

/// A cut file never gives half a picture: it is refused, or all pixels were there.
TEST(ImageReaders, NoCutFileIsTakenForAWholeOne) {
  for (const auto& [name, bytes] : samples()) {
    const cv::Mat whole = test::decoded(bytes);
    std::size_t refused = 0;
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      const Bytes cut(bytes.begin(),
                      bytes.begin() + std::ptrdiff_t(size));  // a sanitizer detects a read beyond the last byte
      try {
        ASSERT_TRUE(same(test::decoded(cut), whole)) << name << ": " << size << " of " << bytes.size() << " bytes";
      } catch (const InputError&) {
        ++refused;
      }
    }
    EXPECT_GE(refused + 200, bytes.size()) << name;  // the end of a TIFF may hold unused data
  }
}

TEST(ImageReaders, ACutFileIsSaidToEndEarly) {
  for (const char* name : {"grey PNG", "JPEG", "progressive JPEG", "BMP", "BMP of runs"}) {
    const Bytes& bytes = samples().at(name);
    const Bytes half(bytes.begin(), bytes.begin() + std::ptrdiff_t(bytes.size() * 3 / 4));
    EXPECT_EQ(mistake(half), "picture: a damaged image: its file ends early") << name;
  }
}

/// A JPEG may have a forged end, but the pixels before it are still missing.
TEST(ImageReaders, AJpegWithAnEndButNotAllPixelsIsRefused) {
  for (const char* name : {"JPEG", "grey JPEG"}) {
    Bytes bytes = samples().at(name);
    bytes.resize(bytes.size() * 3 / 4);
    for (const std::uint8_t byte : {0xff, 0xd9}) bytes.push_back(byte);
    EXPECT_EQ(mistake(bytes), "picture: a damaged image") << name;
  }
}

TEST(ImageReaders, ATiffWithADamagedStripIsRefused) {
  for (const int type : {CV_8UC3, CV_16UC3}) {
    Bytes bytes = test::tiff_of(pattern(type));
    std::fill_n(bytes.begin() + 60, 200, std::uint8_t(0xff));  // strips come first, after 8 bytes
    EXPECT_EQ(mistake(bytes), "picture: a damaged image") << type;
  }
}

TEST(ImageReaders, DamagedFilesAreReadOrRefused) {
  std::vector<Bytes> files;
  for (const auto& [name, bytes] : samples()) files.push_back(bytes);
  EXPECT_TRUE(rc::check([&] {
    for (Bytes bytes : files) {
      for (int changes = *rc::gen::inRange(1, 12); changes > 0; --changes) {
        // Half of the changes hit only the headers, which are the more dangerous part.
        const std::size_t most = *rc::gen::arbitrary<bool>() ? std::min<std::size_t>(bytes.size(), 120) : bytes.size();
        bytes[*rc::gen::inRange<std::size_t>(2, most)] = *rc::gen::arbitrary<std::uint8_t>();
      }
      try {
        const cv::Mat image =
            decode_image(bytes, "a", *rc::gen::elementOf(std::vector{PixelBits::as_stored, PixelBits::eight})).pixels;
        RC_ASSERT(double(image.total()) <= kMaxImagePixels);
      } catch (const InputError&) {
      }
    }
  }));
}

TEST(ImageReaders, HugeClaimsAreRefusedByTheirHeaders) {
  Bmp bmp = bmp_of_runs();
  bmp.size = {60'000, 60'000};
  EXPECT_EQ(mistake(file_of(bmp)), "picture: 60000 x 60000 pixels, more than the 50 million allowed");
  bmp.size = {2'000'000, 1};
  EXPECT_EQ(mistake(file_of(bmp)), "picture: 2000000 x 1 pixels, allowed: sides of 1048576 at most");
  bmp.size = {0, 5};
  EXPECT_EQ(mistake(file_of(bmp)), "picture: a damaged image");
  bmp = {.bits = 24, .size = {7'000, 7'000}, .pixels = Bytes(100)};  // an allowed size, but the pixels are missing
  EXPECT_EQ(mistake(file_of(bmp)), "picture: a damaged image: its file ends early");
}

TEST(ImageReaders, SayWhatTheyDoNotRead) {
  EXPECT_EQ(mistake({'x', 'y'}), "picture: neither SVG nor a readable PNG, WebP, TIFF, BMP or JPEG image");
  const Bmp bmp{.bits = 2, .pixels = Bytes(100)};
  EXPECT_EQ(mistake(file_of(bmp)), "picture: a BMP of a kind that is not read; convert it to PNG");
}

TEST(PngEncoder, SaysThatItsBytesWereNotTaken) {
  for (const bool throws : {false, true}) {
    std::size_t taken = 0;
    PngEncoder encoder([&](std::span<const std::uint8_t> bytes) {
      taken += bytes.size();
      if (taken > 500 && throws) throw std::bad_alloc();
      return taken <= 500;
    });
    const cv::Mat image = pattern(CV_8UC3, {200, 200});
    EXPECT_FALSE(encoder.begin({.size = image.size(), .type = image.type()}) && encoder.write(image) && encoder.end());
  }
  EXPECT_THROW(png_of(cv::Mat(1, 1'100'000, CV_8UC1, cv::Scalar(0))), EnvironmentError);
}

}  // namespace test_image_readers
}  // namespace tessera
