#include "render/png_stream.h"

#include <cerrno>
#include <system_error>

#include "core/base/error.h"

namespace tessera {
namespace {

int row_type(const PictureFormat& format) {
  if (format.grey_bits > 0) return format.grey_bits == 16 ? CV_16UC1 : CV_8UC1;
  return format.alpha ? CV_8UC4 : CV_8UC3;
}

PngFormat png_format(const PictureFormat& format) {
  return {.size = format.size,
          .type = row_type(format),
          .size_mm = format.size_mm,
          .packing = format.grey_bits > 0 ? PngPacking::labels : PngPacking::small};
}

}  // namespace

/// Opens a stream; null, with errno set, where that fails.
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
      encoder_([this](std::span<const std::uint8_t> bytes) {
        return std::fwrite(bytes.data(), 1, bytes.size(), stream_.get()) == bytes.size();
      }) {
  errno = stream_ ? 0 : errno;
  if (!stream_ || !encoder_.begin(png_format(format))) fail(errno);
}

void PngStream::write(const cv::Mat& rows) {
  errno = 0;
  if (!encoder_.write(rows)) fail(errno);
}

void PngStream::finish() {
  errno = 0;
  if (!encoder_.end() || std::fclose(stream_.release()) != 0) fail(errno);
  file_.commit();
}

void PngStream::fail(int reason) const {
  throw EnvironmentError("cannot write " + path_ + ": " + std::generic_category().message(reason ? reason : EIO));
}

}  // namespace tessera
