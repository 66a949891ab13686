#include "render/png_stream.h"

#include <png.h>

#include <bit>
#include <cerrno>
#include <cmath>
#include <csetjmp>
#include <system_error>

#include "core/base/error.h"
#include "job/picture_size.h"

namespace tessera {
namespace {

// Of drawings each filter alone gives smaller files than the choice by libpng's rule, and Paeth's the smallest.
constexpr int kFilter = PNG_FILTER_PAETH;
constexpr int kLabelFilter = PNG_FILTER_UP;  // of areas of one value
constexpr int kCompression = 6;

int colour_type(const PictureFormat& format) {
  if (format.grey_bits > 0) return PNG_COLOR_TYPE_GRAY;
  return format.alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB;
}

/// libpng leaves by longjmp: between setjmp and here stands nothing that needs a destructor.
[[noreturn]] void leave(png_structp png, png_const_charp) { std::longjmp(png_jmpbuf(png), 1); }
void ignore(png_structp, png_const_charp) {}

}  // namespace

struct PngStream::Encoder {
  Encoder() : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, ignore)) {
    if (png) info = png_create_info_struct(png);
  }
  ~Encoder() { png_destroy_write_struct(&png, &info); }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  bool begin(std::FILE* file, const PictureFormat& format) {
    if (!png || !info || setjmp(png_jmpbuf(png))) return false;
    png_init_io(png, file);
    png_set_IHDR(png, info, png_uint_32(format.size.width), png_uint_32(format.size.height),
                 format.grey_bits == 16 ? 16 : 8, colour_type(format), PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (format.size_mm.width > 0) {
      const auto per_metre = [](int px, double mm) { return png_uint_32(std::lround(px * 1000 / mm)); };
      png_set_pHYs(png, info, per_metre(format.size.width, format.size_mm.width),
                   per_metre(format.size.height, format.size_mm.height), PNG_RESOLUTION_METER);
    }
    png_set_filter(png, PNG_FILTER_TYPE_BASE, format.grey_bits > 0 ? kLabelFilter : kFilter);
    png_set_compression_level(png, kCompression);
    png_write_info(png, info);
    png_set_bgr(png);
    if (std::endian::native == std::endian::little) png_set_swap(png);
    return true;
  }

  bool write(const cv::Mat& rows) {
    if (setjmp(png_jmpbuf(png))) return false;
    for (int y = 0; y < rows.rows; ++y) png_write_row(png, rows.ptr(y));
    return true;
  }

  bool end() {
    if (setjmp(png_jmpbuf(png))) return false;
    png_write_end(png, info);
    return true;
  }

  png_structp png = nullptr;
  png_infop info = nullptr;
};

/// Null with errno where that cannot be.
PngStream::Stream PngStream::open_stream(const TemporaryFile& file) {
  FileDescriptor own = file.duplicate();
  Stream stream(::fdopen(own.number(), "wb"));
  if (stream) own.release();
  return stream;
}

PngStream::PngStream(const std::string& path, const PictureFormat& format)
    : path_(path),
      file_(path),
      stream_(open_stream(file_)),
      encoder_(std::make_unique<Encoder>()) {
  errno = stream_ ? 0 : errno;
  if (!stream_ || !encoder_->begin(stream_.get(), format)) fail(errno);
}

PngStream::~PngStream() = default;

void PngStream::write(const cv::Mat& rows) {
  errno = 0;
  if (!encoder_->write(rows)) fail(errno);
}

void PngStream::finish() {
  errno = 0;
  if (!encoder_->end() || std::fclose(stream_.release()) != 0) fail(errno);
  file_.commit();
}

void PngStream::fail(int reason) const {
  throw EnvironmentError("cannot write " + path_ + ": " + std::generic_category().message(reason ? reason : EIO));
}

}  // namespace tessera
