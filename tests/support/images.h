// Pictures for tests: written in every format that the program reads, and read back by the program's own readers.
#pragma once

// clang-format off
#include <cstdio>  // jpeglib.h needs it
#include <jpeglib.h>
// clang-format on
#include <tiffio.h>
#include <webp/encode.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "artwork/images/image_decoding.h"
#include "artwork/images/png_encoder.h"
#include "core/base/error.h"

namespace tessera::test {

using Bytes = std::vector<std::uint8_t>;

struct JpegKind {
  int quality = 95;
  bool progressive = false;
  bool arithmetic = false;
};

/// `image`: grey, BGR, or CMYK of four channels.
inline Bytes jpeg_of(const cv::Mat& image, const JpegKind& kind = {}) {
  jpeg_compress_struct info{};
  jpeg_error_mgr errors;
  info.err = jpeg_std_error(&errors);  // ends the program at a mistake
  jpeg_create_compress(&info);
  unsigned char* memory = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &memory, &size);
  info.image_width = JDIMENSION(image.cols);
  info.image_height = JDIMENSION(image.rows);
  info.input_components = image.channels();
  info.in_color_space = image.channels() == 1 ? JCS_GRAYSCALE : image.channels() == 4 ? JCS_CMYK : JCS_EXT_BGR;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, kind.quality, TRUE);
  info.arith_code = kind.arithmetic ? TRUE : FALSE;
  if (kind.progressive) jpeg_simple_progression(&info);
  jpeg_start_compress(&info, TRUE);
  for (int y = 0; y < image.rows; ++y) {
    auto* row = const_cast<JSAMPLE*>(image.ptr(y));
    jpeg_write_scanlines(&info, &row, 1);
  }
  jpeg_finish_compress(&info);
  Bytes bytes(memory, memory + size);
  jpeg_destroy_compress(&info);
  std::free(memory);
  return bytes;
}

/// `image`: grey (stored as BGR), BGR or straight BGRA. Without losses unless `quality` is given.
inline Bytes webp_of(const cv::Mat& image, int quality = 0) {
  cv::Mat colours = image;
  if (image.channels() == 1) cv::cvtColor(image, colours, cv::COLOR_GRAY2BGR);
  const bool alpha = colours.channels() == 4;
  const auto lossy = alpha ? WebPEncodeBGRA : WebPEncodeBGR;
  const auto lossless = alpha ? WebPEncodeLosslessBGRA : WebPEncodeLosslessBGR;
  std::uint8_t* memory = nullptr;
  const int step = int(colours.step[0]);
  const std::size_t size = quality > 0 ? lossy(colours.data, colours.cols, colours.rows, step, float(quality), &memory)
                                       : lossless(colours.data, colours.cols, colours.rows, step, &memory);
  Bytes bytes(memory, memory + size);
  WebPFree(memory);
  return bytes;
}

struct TiffKind {
  int compression = COMPRESSION_LZW;
  int rows_per_strip = 8;
  int tile_px = 0;  // 0: strips
  int orientation = ORIENTATION_TOPLEFT;
};

/// A file that libtiff writes to.
class TiffMemory {
 public:
  TIFF* open() { return TIFFClientOpen("", "w", this, read, write, seek, close, size, nullptr, nullptr); }
  const Bytes& bytes() const { return bytes_; }

 private:
  static TiffMemory& of(thandle_t handle) { return *static_cast<TiffMemory*>(handle); }
  static tmsize_t read(thandle_t handle, void* to, tmsize_t count) {
    TiffMemory& file = of(handle);
    const std::size_t there = file.bytes_.size() - std::min(file.at_, file.bytes_.size());
    const std::size_t taken = std::min(std::size_t(count), there);
    std::copy_n(file.bytes_.data() + file.at_, taken, static_cast<std::uint8_t*>(to));
    file.at_ += taken;
    return tmsize_t(taken);
  }
  static tmsize_t write(thandle_t handle, void* from, tmsize_t count) {
    TiffMemory& file = of(handle);
    file.bytes_.resize(std::max(file.bytes_.size(), file.at_ + std::size_t(count)));
    std::copy_n(static_cast<const std::uint8_t*>(from), count, file.bytes_.data() + file.at_);
    file.at_ += std::size_t(count);
    return count;
  }
  static toff_t seek(thandle_t handle, toff_t offset, int whence) {
    TiffMemory& file = of(handle);
    const std::size_t from = whence == SEEK_CUR ? file.at_ : whence == SEEK_END ? file.bytes_.size() : 0;
    return file.at_ = from + std::size_t(offset);
  }
  static int close(thandle_t) { return 0; }
  static toff_t size(thandle_t handle) { return of(handle).bytes_.size(); }

  Bytes bytes_;
  std::size_t at_ = 0;
};

/// `image`: 8 or 16 bits; grey, BGR or BGRA, stored without saying what the fourth channel is.
inline Bytes tiff_of(const cv::Mat& image, const TiffKind& kind = {}) {
  TiffMemory memory;
  TIFF* tiff = memory.open();
  cv::Mat rgb = image;
  if (image.channels() == 3) cv::cvtColor(image, rgb, cv::COLOR_BGR2RGB);
  if (image.channels() == 4) cv::cvtColor(image, rgb, cv::COLOR_BGRA2RGBA);
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, image.cols);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, image.rows);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, int(8 * image.elemSize1()));
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, image.channels());
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, image.channels() == 1 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(tiff, TIFFTAG_ORIENTATION, kind.orientation);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, kind.compression);
  if (kind.tile_px > 0) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, kind.tile_px);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, kind.tile_px);
    for (int y = 0; y < rgb.rows; y += kind.tile_px) {
      for (int x = 0; x < rgb.cols; x += kind.tile_px) {
        cv::Mat tile = cv::Mat::zeros(kind.tile_px, kind.tile_px, rgb.type());
        const cv::Rect part = cv::Rect(x, y, kind.tile_px, kind.tile_px) & cv::Rect({0, 0}, rgb.size());
        rgb(part).copyTo(tile(cv::Rect({0, 0}, part.size())));
        TIFFWriteTile(tiff, tile.data, std::uint32_t(x), std::uint32_t(y), 0, 0);
      }
    }
  } else {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, kind.rows_per_strip);
    for (int y = 0; y < rgb.rows; ++y) TIFFWriteScanline(tiff, rgb.ptr(y), std::uint32_t(y), 0);
  }
  TIFFClose(tiff);
  return memory.bytes();
}

/// `image`: grey or BGR.
inline Bytes bmp_of(const cv::Mat& image) {
  Bytes bytes;
  const auto add = [&](std::uint32_t number, int width) {
    for (int i = 0; i < width; ++i) bytes.push_back(std::uint8_t(number >> 8 * i));
  };
  const std::size_t row_bytes = std::size_t(image.cols) * image.elemSize(), stride_bytes = (row_bytes + 3) / 4 * 4;
  const std::uint32_t colours = image.channels() == 1 ? 256 : 0, pixels_at = 54 + 4 * colours;
  const auto pixel_bytes = std::uint32_t(stride_bytes * std::size_t(image.rows));
  add('B' | 'M' << 8, 2);
  for (const std::uint32_t number : {pixels_at + pixel_bytes, 0u, pixels_at, 40u}) add(number, 4);
  add(std::uint32_t(image.cols), 4);
  add(std::uint32_t(image.rows), 4);
  add(1, 2);
  add(std::uint32_t(8 * image.channels()), 2);
  for (int i = 0; i < 6; ++i) add(0, 4);
  for (std::uint32_t grey = 0; grey < colours; ++grey) add(grey * 0x010101, 4);
  for (int y = image.rows - 1; y >= 0; --y) {
    bytes.insert(bytes.end(), image.ptr(y), image.ptr(y) + row_bytes);
    bytes.resize(bytes.size() + stride_bytes - row_bytes);
  }
  return bytes;
}

/// `extension`: ".png", ".jpg", ".webp" (without losses), ".tiff" or ".bmp"; JPEG and BMP have no alpha.
inline Bytes encoded(const cv::Mat& image, const std::string& extension) {
  if (extension == ".png") return png_of(image);
  if (extension == ".webp") return webp_of(image);
  if (extension == ".tiff") return tiff_of(image);
  cv::Mat opaque = image;
  if (image.channels() == 4) cv::cvtColor(image, opaque, cv::COLOR_BGRA2BGR);
  if (extension == ".jpg") return jpeg_of(opaque);
  if (extension == ".bmp") return bmp_of(opaque);
  throw std::invalid_argument(extension);
}

/// In the format that its name says.
inline bool write_image(const std::string& path, const cv::Mat& image) {
  const Bytes bytes = encoded(image, std::filesystem::path(path).extension());
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  return bool(file.flush());
}

/// As it is stored.
inline cv::Mat decoded(const Bytes& bytes) { return decode_image(bytes, "picture", PixelBits::as_stored).pixels; }

/// Empty where there is no readable picture.
inline cv::Mat read_image(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  try {
    return decoded(Bytes(std::istreambuf_iterator<char>(file), {}));
  } catch (const InputError&) {
    return {};
  }
}

/// BGR of 8 bits, whatever is stored.
inline cv::Mat bgr_of_image(const cv::Mat& image) {
  cv::Mat bgr = image;  // empty, too
  if (image.channels() == 1) cv::cvtColor(image, bgr, cv::COLOR_GRAY2BGR);
  if (image.channels() == 4) cv::cvtColor(image, bgr, cv::COLOR_BGRA2BGR);
  return bgr;
}

}  // namespace tessera::test
