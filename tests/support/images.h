// Pictures for tests: encoded in every format that the program reads, and decoded by the program's own readers.
#pragma once

// clang-format off
#include <cstdio>  // jpeglib.h needs it
#include <jpeglib.h>
// clang-format on
#include <tiffio.h>
#include <webp/encode.h>
#include <zlib.h>

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
  Bytes profile = {};
};

/// `image`: grey, BGR, or CMYK of four channels.
inline Bytes jpeg_of(const cv::Mat& image, const JpegKind& kind = {}) {
  jpeg_compress_struct info{};
  jpeg_error_mgr errors;
  info.err = jpeg_std_error(&errors);  // ends the program at an error
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
  if (!kind.profile.empty()) jpeg_write_icc_profile(&info, kind.profile.data(), unsigned(kind.profile.size()));
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

/// `image`: grey (stored as BGR), BGR or straight BGRA. Lossless unless `quality` is given.
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
  Bytes profile = {};
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

inline void write_tiff_page(TIFF* tiff, const cv::Mat& image, const TiffKind& kind) {
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
  if (!kind.profile.empty())
    TIFFSetField(tiff, TIFFTAG_ICCPROFILE, std::uint32_t(kind.profile.size()), kind.profile.data());
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
  TIFFWriteDirectory(tiff);
}

inline Bytes tiff_of_pages(const std::vector<cv::Mat>& pages, const TiffKind& kind = {}) {
  TiffMemory memory;
  TIFF* tiff = memory.open();
  for (const cv::Mat& page : pages) write_tiff_page(tiff, page, kind);
  TIFFClose(tiff);
  return memory.bytes();
}

/// `image`: 8 or 16 bits; grey, BGR or BGRA. The file does not say what the fourth channel means.
inline Bytes tiff_of(const cv::Mat& image, const TiffKind& kind = {}) { return tiff_of_pages({image}, kind); }

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

/// `extension`: ".png", ".jpg", ".webp" (lossless), ".tiff" or ".bmp"; JPEG and BMP have no alpha.
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

/// Writes the picture in the format of the path's extension.
inline bool write_image(const std::string& path, const cv::Mat& image) {
  const Bytes bytes = encoded(image, std::filesystem::path(path).extension());
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  return bool(file.flush());
}

/// EXIF data with an orientation and nothing else.
inline Bytes exif_with_orientation(std::uint8_t orientation) {
  return {'M', 'M', 0, 42, 0, 0, 0, 8, 0, 1, 1, 0x12, 0, 3, 0, 0, 0, 1, 0, orientation, 0, 0, 0, 0, 0, 0};
}

/// The JPEG with these EXIF data.
inline Bytes jpeg_with_exif(Bytes jpeg, const Bytes& exif) {
  Bytes segment = {0xff, 0xe1, 0, std::uint8_t(8 + exif.size()), 'E', 'x', 'i', 'f', 0, 0};
  segment.insert(segment.end(), exif.begin(), exif.end());
  jpeg.insert(jpeg.begin() + 2, segment.begin(), segment.end());
  return jpeg;
}

/// Inserts one chunk after the PNG's first chunk.
inline Bytes png_with_chunk(Bytes png, const std::string& name, const Bytes& data) {
  constexpr std::size_t kFirstChunkEnds = 8 + 12 + 13;
  const auto append = [](Bytes& to, std::uint32_t number) {
    for (const int shift : {24, 16, 8, 0}) to.push_back(std::uint8_t(number >> shift));
  };
  Bytes chunk;
  append(chunk, std::uint32_t(data.size()));
  chunk.insert(chunk.end(), name.begin(), name.end());
  chunk.insert(chunk.end(), data.begin(), data.end());
  append(chunk, std::uint32_t(crc32(0, chunk.data() + 4, uInt(chunk.size() - 4))));
  png.insert(png.begin() + kFirstChunkEnds, chunk.begin(), chunk.end());
  return png;
}

inline Bytes png_with_profile(const Bytes& png, const Bytes& profile) {
  Bytes packed(compressBound(uLong(profile.size())));
  uLongf size = uLongf(packed.size());
  compress(packed.data(), &size, profile.data(), uLong(profile.size()));
  Bytes data = {'a', 0, 0};  // the profile's name and the kind of compression
  data.insert(data.end(), packed.begin(), packed.begin() + std::ptrdiff_t(size));
  return png_with_chunk(png, "iCCP", data);
}

inline Bytes low_byte_first(std::size_t value, int bytes) {
  Bytes number;
  for (int i = 0; i < bytes; ++i) number.push_back(std::uint8_t(value >> 8 * i));
  return number;
}

inline Bytes joined(const std::vector<Bytes>& parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

inline Bytes riff_chunk(const std::string& name, const Bytes& data) {
  return joined({Bytes(name.begin(), name.end()), low_byte_first(data.size(), 4), data, Bytes(data.size() % 2, 0)});
}

/// A WebP in the extended format. `flags`: the contents that its header announces.
inline Bytes extended_webp(std::uint8_t flags, const cv::Size& size, const std::vector<Bytes>& chunks) {
  const Bytes head = joined({{flags, 0, 0, 0},
                             low_byte_first(std::size_t(size.width - 1), 3),
                             low_byte_first(std::size_t(size.height - 1), 3)});
  return riff_chunk("RIFF", joined({{'W', 'E', 'B', 'P'}, riff_chunk("VP8X", head), joined(chunks)}));
}

/// The pixel chunk of a WebP that has no other chunk.
inline Bytes pixels_of_webp(const Bytes& webp) { return Bytes(webp.begin() + 12, webp.end()); }

/// An animation of pictures of one size.
inline Bytes animated_webp(const std::vector<cv::Mat>& pictures) {
  constexpr std::uint8_t kAnimation = 2;
  std::vector<Bytes> chunks = {riff_chunk("ANIM", Bytes(6, 0))};
  for (const cv::Mat& picture : pictures) {
    chunks.push_back(riff_chunk("ANMF", joined({Bytes(6, 0),
                                                low_byte_first(std::size_t(picture.cols - 1), 3),
                                                low_byte_first(std::size_t(picture.rows - 1), 3),
                                                {100, 0, 0, 0},
                                                pixels_of_webp(webp_of(picture))})));
  }
  return extended_webp(kAnimation, pictures.front().size(), chunks);
}

/// The encoded picture, with its pixels stored as a camera in this orientation stores them.
inline Bytes encoded_with_orientation(const cv::Mat& image, const std::string& extension, std::uint8_t orientation) {
  const Bytes exif = exif_with_orientation(orientation);
  if (extension == ".jpg") return jpeg_with_exif(encoded(image, extension), exif);
  if (extension == ".png") return png_with_chunk(encoded(image, extension), "eXIf", exif);
  if (extension == ".webp") {
    constexpr std::uint8_t kExif = 8;
    return extended_webp(kExif, image.size(), {pixels_of_webp(encoded(image, extension)), riff_chunk("EXIF", exif)});
  }
  return tiff_of(image, {.orientation = orientation});
}

/// The encoded picture with a colour profile.
inline Bytes encoded_with_profile(const cv::Mat& image, const std::string& extension, const Bytes& profile) {
  if (extension == ".jpg") return jpeg_of(image, {.quality = 95, .profile = profile});
  if (extension == ".png") return png_with_profile(encoded(image, extension), profile);
  if (extension == ".webp") {
    constexpr std::uint8_t kProfile = 0x20;
    return extended_webp(kProfile, image.size(),
                         {riff_chunk("ICCP", profile), pixels_of_webp(encoded(image, extension))});
  }
  return tiff_of(image, {.profile = profile});
}

/// Decodes without a change of bit depth.
inline cv::Mat decoded(const Bytes& bytes) { return decode_image(bytes, "picture", PixelBits::as_stored).pixels; }

/// Empty if there is no readable picture.
inline cv::Mat read_image(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  try {
    return decoded(Bytes(std::istreambuf_iterator<char>(file), {}));
  } catch (const InputError&) {
    return {};
  }
}

/// Converts to BGR with 8 bits a channel.
inline cv::Mat bgr_of_image(const cv::Mat& image) {
  cv::Mat bgr = image;  // may be empty
  if (image.channels() == 1) cv::cvtColor(image, bgr, cv::COLOR_GRAY2BGR);
  if (image.channels() == 4) cv::cvtColor(image, bgr, cv::COLOR_BGRA2BGR);
  return bgr;
}

}  // namespace tessera::test
