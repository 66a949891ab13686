#include <png.h>

#include <bit>
#include <csetjmp>
#include <cstring>
#include <vector>

#include "artwork/images/formats/gamma_profile.h"
#include "artwork/images/formats/image_readers.h"
#include "artwork/images/formats/png_errors.h"

namespace tessera {
namespace {

class PngReader {
 public:
  explicit PngReader(std::span<const std::uint8_t> bytes)
      : rest_(bytes),
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, leave_png, ignore_png)) {
    if (png_) info_ = png_create_info_struct(png_);
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  /// Reads the chunks before the pixels. This function and the other bool members return false where the file is
  /// damaged.
  bool read_header() {
    if (!png_ || !info_ || setjmp(png_jmpbuf(png_))) return false;
    png_set_read_fn(png_, this, hand_out);
    png_read_info(png_, info_);
    return true;
  }

  double width_px() const { return png_get_image_width(png_, info_); }
  double height_px() const { return png_get_image_height(png_, info_); }

  /// Asks libpng for rows of grey, BGR or straight BGRA. A palette becomes colours, grey with alpha BGRA. A grey that
  /// stands for "transparent" stays grey.
  bool choose_rows(PixelBits bits) {
    if (setjmp(png_jmpbuf(png_))) return false;
    const int kind = png_get_color_type(png_, info_);
    const bool is_grey = (kind & PNG_COLOR_MASK_COLOR) == 0;
    if (bits == PixelBits::eight) png_set_strip_16(png_);
    if (std::endian::native == std::endian::little) png_set_swap(png_);
    if (kind == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(png_);
    if (kind == PNG_COLOR_TYPE_GRAY) png_set_expand_gray_1_2_4_to_8(png_);
    if (kind == PNG_COLOR_TYPE_GRAY_ALPHA) png_set_gray_to_rgb(png_);
    if (!is_grey && png_get_valid(png_, info_, PNG_INFO_tRNS)) png_set_tRNS_to_alpha(png_);
    png_set_bgr(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }

  /// The ICC profile of the rows that choose_rows() asked for; empty where the file says nothing of its colours.
  std::vector<std::uint8_t> profile() const {
    png_charp name = nullptr;
    int compression = 0;
    png_bytep data = nullptr;
    png_uint_32 size = 0;
    if (!png_get_iCCP(png_, info_, &name, &compression, &data, &size)) return profile_of_numbers();
    return {data, data + size};
  }

  /// OpenCV's type of the rows that choose_rows() asked for.
  int type() const {
    return CV_MAKETYPE(png_get_bit_depth(png_, info_) == 16 ? CV_16U : CV_8U, png_get_channels(png_, info_));
  }
  std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }

  bool read_rows(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_read_image(png_, rows);
    png_read_end(png_, info_);
    return true;
  }

  bool ended_early() const { return ended_early_; }

 private:
  /// A profile from gamma and primaries. Where the file states that it is sRGB these numbers are ignored.
  std::vector<std::uint8_t> profile_of_numbers() const {
    double gamma = 0;
    if (png_get_valid(png_, info_, PNG_INFO_sRGB) || !png_get_gAMA(png_, info_, &gamma)) return {};
    Chromaticities c = kSrgbChromaticities;
    png_get_cHRM(png_, info_, &c.white[0], &c.white[1], &c.red[0], &c.red[1], &c.green[0], &c.green[1], &c.blue[0],
                 &c.blue[1]);
    return is_about_srgb(gamma, c) ? std::vector<std::uint8_t>()
                                   : gamma_profile(gamma, c, png_get_channels(png_, info_) == 1);
  }

  static void hand_out(png_structp png, png_bytep to, std::size_t count) {
    auto* self = static_cast<PngReader*>(png_get_io_ptr(png));
    if (count > self->rest_.size()) {
      self->ended_early_ = true;
      png_error(png, "ends early");
    }
    std::memcpy(to, self->rest_.data(), count);
    self->rest_ = self->rest_.subspan(count);
  }

  std::span<const std::uint8_t> rest_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  bool ended_early_ = false;
};

}  // namespace

DecodedImage read_png(std::span<const std::uint8_t> bytes, const ReadingRules& rules) {
  PngReader reader(bytes);
  const auto check = [&](bool is_fine) {
    if (is_fine) return;
    if (reader.ended_early()) throw_ends_early();
    throw_damaged();
  };
  check(reader.read_header());
  const double width_px = reader.width_px(), height_px = reader.height_px();
  check(reader.choose_rows(rules.bits));
  DecodedImage image{.pixels = room_for_pixels(width_px, height_px, reader.type(), rules), .profile = reader.profile()};
  check(reader.row_bytes() == std::size_t(image.pixels.cols) * image.pixels.elemSize());
  std::vector<png_bytep> rows;
  for (int y = 0; y < image.pixels.rows; ++y) rows.push_back(image.pixels.ptr(y));
  check(reader.read_rows(rows.data()));
  return image;
}

}  // namespace tessera
