#include <tiffio.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "artwork/images/formats/image_readers.h"

namespace tessera {
namespace {

/// The file in memory and the read position, for the functions that libtiff calls.
struct MemoryFile {
  std::span<const std::uint8_t> bytes;
  std::size_t at = 0;
};

tmsize_t read_memory(thandle_t handle, void* to, tmsize_t count) {
  auto* file = static_cast<MemoryFile*>(handle);
  const std::size_t there = std::min(std::size_t(std::max<tmsize_t>(count, 0)), file->bytes.size() - file->at);
  std::memcpy(to, file->bytes.data() + file->at, there);
  file->at += there;
  return tmsize_t(there);
}

tmsize_t write_nothing(thandle_t, void*, tmsize_t) { return 0; }

toff_t seek_memory(thandle_t handle, toff_t offset, int whence) {
  auto* file = static_cast<MemoryFile*>(handle);
  const toff_t from = whence == SEEK_CUR ? file->at : whence == SEEK_END ? file->bytes.size() : 0;
  file->at = std::size_t(std::min<toff_t>(from + offset, file->bytes.size()));
  return file->at;
}

int close_nothing(thandle_t) { return 0; }
toff_t size_of_memory(thandle_t handle) { return static_cast<MemoryFile*>(handle)->bytes.size(); }

/// Takes libtiff's messages and drops them: functions that fail say so by their result.
int ignore(TIFF*, void*, const char*, const char*, va_list) { return 1; }

struct CloseTiff {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using TiffPtr = std::unique_ptr<TIFF, CloseTiff>;

TiffPtr open_tiff(MemoryFile& file, const ReadingRules& rules) {
  constexpr double kMostBytesPerPixel = 8;
  constexpr tmsize_t kTables_bytes = 1 << 20;
  const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                 TIFFOpenOptionsFree);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), ignore, nullptr);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore, nullptr);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), tmsize_t(kMostBytesPerPixel * rules.most_pixels) + kTables_bytes);
  return TiffPtr(TIFFClientOpenExt("", "r", &file, read_memory, write_nothing, seek_memory, close_nothing,
                                   size_of_memory, nullptr, nullptr, options.get()));
}

template <class Value>
Value field(TIFF* tiff, std::uint32_t tag, Value otherwise) {
  Value value = otherwise;
  return TIFFGetFieldDefaulted(tiff, tag, &value) ? value : otherwise;
}

/// The size of the blocks (tiles or strips) in which a TIFF stores its pixels.
struct Blocks {
  bool are_tiles;
  std::uint32_t width_px, height_px;
};

struct Layout {
  std::uint32_t width_px, height_px;
  std::uint16_t bits, channels, photometric;
  bool has_one_plane, is_unsigned;
  int orientation;
  Blocks blocks;

  bool is_grey() const { return photometric == PHOTOMETRIC_MINISWHITE || photometric == PHOTOMETRIC_MINISBLACK; }
  double pixels() const { return double(width_px) * height_px; }
};

Layout layout_of(TIFF* tiff) {
  Layout layout{};
  layout.width_px = field<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH, 0);
  layout.height_px = field<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH, 0);
  layout.bits = field<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE, 1);
  layout.channels = field<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  layout.photometric =
      field<std::uint16_t>(tiff, TIFFTAG_PHOTOMETRIC, layout.channels < 3 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB);
  layout.has_one_plane = field<std::uint16_t>(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) == PLANARCONFIG_CONTIG;
  layout.is_unsigned = field<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT) == SAMPLEFORMAT_UINT;
  layout.orientation = field<std::uint16_t>(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  const bool tiled = TIFFIsTiled(tiff) != 0;
  layout.blocks = {tiled, tiled ? field<std::uint32_t>(tiff, TIFFTAG_TILEWIDTH, 0) : layout.width_px,
                   field<std::uint32_t>(tiff, tiled ? TIFFTAG_TILELENGTH : TIFFTAG_ROWSPERSTRIP, layout.height_px)};
  if (!tiled) layout.blocks.height_px = std::min(layout.blocks.height_px, layout.height_px);
  return layout;
}

/// Refuses blocks that are larger than both the picture and the largest picture allowed. A small picture may lie in a
/// larger block.
void check_blocks(const Layout& layout, const ReadingRules& rules) {
  const double pixels = double(layout.blocks.width_px) * layout.blocks.height_px;
  if (pixels < 1 || pixels > std::max(rules.most_pixels, layout.pixels())) throw_damaged();
}

bool has_deep_pixels(const Layout& layout) {
  const bool known_bits = layout.bits == 10 || layout.bits == 12 || layout.bits == 14 || layout.bits == 16;
  const bool known_channels =
      layout.is_grey() ? layout.channels == 1
                       : layout.photometric == PHOTOMETRIC_RGB && (layout.channels == 3 || layout.channels == 4);
  return known_bits && known_channels && layout.has_one_plane && layout.is_unsigned;
}

/// Unpacks numbers of 10 to 16 bits, which follow one another highest bit first, into the highest bits of 16.
void widen(const std::uint8_t* packed, int bits, std::span<std::uint16_t> to) {
  std::uint32_t window = 0;
  int held = 0;
  for (std::uint16_t& value : to) {
    for (; held < bits; held += 8) window = window << 8 | *packed++;
    held -= bits;
    value = std::uint16_t((window >> held) << (16 - bits));
  }
}

/// Reads pictures of 10 to 16 bits a channel. Rows and columns stay in the order of the file.
class DeepReader {
 public:
  DeepReader(TIFF* tiff, const Layout& layout)
      : tiff_(tiff),
        layout_(layout),
        row_bytes_((std::size_t(layout.blocks.width_px) * layout.channels * layout.bits + 7) / 8),
        packed_(row_bytes_ * layout.blocks.height_px),
        row_(1, int(layout.blocks.width_px), CV_16UC(layout.channels)) {}

  void read(cv::Mat& pixels) {
    for (std::uint32_t y = 0; y < layout_.height_px; y += layout_.blocks.height_px) {
      for (std::uint32_t x = 0; x < layout_.width_px; x += layout_.blocks.width_px) read_block(x, y, pixels);
    }
  }

 private:
  void read_block(std::uint32_t x, std::uint32_t y, cv::Mat& pixels) {
    const int columns = int(std::min(layout_.blocks.width_px, layout_.width_px - x));
    const int rows = int(std::min(layout_.blocks.height_px, layout_.height_px - y));
    const bool tiled = layout_.blocks.are_tiles;
    const auto bytes = tmsize_t(tiled ? packed_.size() : row_bytes_ * std::size_t(rows));
    const tmsize_t got = tiled ? TIFFReadEncodedTile(tiff_, TIFFComputeTile(tiff_, x, y, 0, 0), packed_.data(), bytes)
                               : TIFFReadEncodedStrip(tiff_, TIFFComputeStrip(tiff_, y, 0), packed_.data(), bytes);
    if (got < 0) throw_damaged();
    if (got < bytes) throw_ends_early();
    for (int i = 0; i < rows; ++i) {
      unpack(packed_.data() + row_bytes_ * std::size_t(i));
      cv::Mat to = pixels(cv::Rect(int(x), int(y) + i, columns, 1));
      in_order(row_.colRange(0, columns), to);
    }
  }

  void unpack(const std::uint8_t* packed) {
    auto* values = row_.ptr<std::uint16_t>();
    if (layout_.bits == 16) return void(std::memcpy(values, packed, row_bytes_));
    widen(packed, layout_.bits, {values, std::size_t(layout_.blocks.width_px) * layout_.channels});
  }

  void in_order(const cv::Mat& from, cv::Mat& to) const {
    if (layout_.photometric == PHOTOMETRIC_MINISWHITE) return void(cv::bitwise_not(from, to));
    if (layout_.channels == 1) return void(from.copyTo(to));
    cv::cvtColor(from, to, layout_.channels == 3 ? cv::COLOR_RGB2BGR : cv::COLOR_RGBA2BGRA);
  }

  TIFF* tiff_;
  const Layout& layout_;
  std::size_t row_bytes_;
  std::vector<std::uint8_t> packed_;
  cv::Mat row_;
};

/// Reads all other pictures as 8 bits a channel: libtiff converts any kind of colours, bits and planes.
class RgbaReader {
 public:
  explicit RgbaReader(TIFF* tiff) {
    constexpr int kStopAtFaults = 1;
    char reason[1024] = "";
    if (!TIFFRGBAImageOK(tiff, reason) || !TIFFRGBAImageBegin(&image_, tiff, kStopAtFaults, reason))
      throw UnreadableImage("a TIFF of a kind that is not read, or damaged; convert it to PNG");
    image_.req_orientation = image_.orientation;  // rows stay in the file's order
  }
  ~RgbaReader() { TIFFRGBAImageEnd(&image_); }
  RgbaReader(const RgbaReader&) = delete;
  RgbaReader& operator=(const RgbaReader&) = delete;

  /// Fills `pixels`, which are grey, BGR or BGRA, in bands of so many rows.
  void read(std::uint32_t rows_at_once, cv::Mat& pixels) {
    cv::Mat band(int(std::min(rows_at_once, std::uint32_t(pixels.rows))), pixels.cols, CV_8UC4);
    for (int y = 0; y < pixels.rows; y += band.rows) {
      const int rows = std::min(band.rows, pixels.rows - y);
      image_.row_offset = y;
      image_.col_offset = 0;
      if (!TIFFRGBAImageGet(&image_, band.ptr<std::uint32_t>(), std::uint32_t(pixels.cols), std::uint32_t(rows)))
        throw_damaged();
      cv::Mat to = pixels.rowRange(y, y + rows);
      in_order(band.rowRange(0, rows), to);
    }
  }

 private:
  static void in_order(const cv::Mat& rgba, cv::Mat& to) {
    if (to.channels() == 1) return cv::extractChannel(rgba, to, 0);
    cv::cvtColor(rgba, to, to.channels() == 3 ? cv::COLOR_RGBA2BGR : cv::COLOR_RGBA2BGRA);
  }

  TIFFRGBAImage image_{};
};

}  // namespace

DecodedImage read_tiff(std::span<const std::uint8_t> bytes, const ReadingRules& rules) {
  MemoryFile file{bytes};
  const TiffPtr tiff = open_tiff(file, rules);
  if (!tiff) throw_damaged();
  const Layout layout = layout_of(tiff.get());
  if (layout.bits > 16) throw UnreadableImage("an image must have 8 or 16 bits a channel");
  const bool deep = rules.bits == PixelBits::as_stored && has_deep_pixels(layout);
  const bool has_alpha = layout.channels > (layout.is_grey() ? 1 : 3) && layout.photometric != PHOTOMETRIC_SEPARATED;
  const int channels = has_alpha ? 4 : layout.is_grey() ? 1 : 3;
  cv::Mat pixels =
      room_for_pixels(layout.width_px, layout.height_px, CV_MAKETYPE(deep ? CV_16U : CV_8U, channels), rules);
  check_blocks(layout, rules);
  if (deep) {
    DeepReader(tiff.get(), layout).read(pixels);
  } else {
    RgbaReader(tiff.get()).read(layout.blocks.height_px, pixels);
  }
  DecodedImage image{.pixels = pixels, .orientation = layout.orientation};
  std::uint32_t profile_bytes = 0;
  void* profile = nullptr;
  if (layout.photometric != PHOTOMETRIC_SEPARATED &&
      TIFFGetField(tiff.get(), TIFFTAG_ICCPROFILE, &profile_bytes, &profile)) {
    const auto* begin = static_cast<const std::uint8_t*>(profile);
    image.profile.assign(begin, begin + profile_bytes);
  }
  return image;
}

}  // namespace tessera
