#include "artwork/images/png_encoder.h"

#include <png.h>
#include <zlib.h>

#include <bit>
#include <cmath>
#include <csetjmp>
#include <string>

#include "artwork/images/formats/png_errors.h"
#include "core/base/error.h"

namespace tessera {
namespace {

struct Packing {
  int filter;
  int level;
  int strategy;
};

Packing packing_of(PngPacking packing) {
  // For drawings each single filter gives smaller files than libpng's choice, and Paeth's filter the smallest.
  if (packing == PngPacking::small) return {PNG_FILTER_PAETH, 6, Z_FILTERED};
  if (packing == PngPacking::labels) return {PNG_FILTER_UP, 6, Z_FILTERED};
  return {PNG_FILTER_SUB, Z_BEST_SPEED, Z_RLE};
}

int colour_type(int channels) {
  if (channels == 1) return PNG_COLOR_TYPE_GRAY;
  return channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB;
}

/// Calls the sink; exceptions must not pass through libpng.
bool takes(const PngEncoder::Sink& sink, std::span<const std::uint8_t> bytes) noexcept {
  try {
    return sink(bytes);
  } catch (...) {
    return false;
  }
}

void pass_on(png_structp png, png_bytep bytes, std::size_t count) {
  const auto* sink = static_cast<const PngEncoder::Sink*>(png_get_io_ptr(png));
  if (!takes(*sink, {bytes, count})) png_error(png, "not taken");
}

void flush_nothing(png_structp) {}

}  // namespace

struct PngEncoder::State {
  explicit State(Sink to)
      : sink(std::move(to)),
        png(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, leave_png, ignore_png)) {
    if (png) info = png_create_info_struct(png);
  }
  ~State() { png_destroy_write_struct(&png, &info); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  Sink sink;
  png_structp png = nullptr;
  png_infop info = nullptr;
};

PngEncoder::PngEncoder(Sink sink) : state_(std::make_unique<State>(std::move(sink))) {}
PngEncoder::~PngEncoder() = default;

bool PngEncoder::begin(const PngFormat& format) {
  const png_structp png = state_->png;
  const png_infop info = state_->info;
  if (!png || !info || setjmp(png_jmpbuf(png))) return false;
  png_set_write_fn(png, &state_->sink, pass_on, flush_nothing);
  png_set_IHDR(png, info, png_uint_32(format.size.width), png_uint_32(format.size.height),
               CV_MAT_DEPTH(format.type) == CV_16U ? 16 : 8, colour_type(CV_MAT_CN(format.type)), PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (format.size_mm.width > 0) {
    const auto per_metre = [](int px, double mm) { return png_uint_32(std::lround(px * 1000 / mm)); };
    png_set_pHYs(png, info, per_metre(format.size.width, format.size_mm.width),
                 per_metre(format.size.height, format.size_mm.height), PNG_RESOLUTION_METER);
  }
  const Packing packing = packing_of(format.packing);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, packing.filter);
  png_set_compression_level(png, packing.level);
  png_set_compression_strategy(png, packing.strategy);
  png_write_info(png, info);
  png_set_bgr(png);
  if (std::endian::native == std::endian::little) png_set_swap(png);
  return true;
}

bool PngEncoder::write(const cv::Mat& rows) {
  if (setjmp(png_jmpbuf(state_->png))) return false;
  for (int y = 0; y < rows.rows; ++y) png_write_row(state_->png, rows.ptr(y));
  return true;
}

bool PngEncoder::end() {
  if (setjmp(png_jmpbuf(state_->png))) return false;
  png_write_end(state_->png, state_->info);
  return true;
}

std::vector<std::uint8_t> png_of(const cv::Mat& image) {
  std::vector<std::uint8_t> png;
  PngEncoder encoder([&](std::span<const std::uint8_t> bytes) {
    png.insert(png.end(), bytes.begin(), bytes.end());
    return true;
  });
  if (!encoder.begin({.size = image.size(), .type = image.type()}) || !encoder.write(image) || !encoder.end()) {
    throw EnvironmentError("cannot make a PNG of " + std::to_string(image.cols) + " x " + std::to_string(image.rows) +
                           " px");
  }
  png.shrink_to_fit();  // thousands of cut-outs of a photo may be in memory
  return png;
}

}  // namespace tessera
