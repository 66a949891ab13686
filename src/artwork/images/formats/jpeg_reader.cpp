// clang-format off
#include <cstdio>  // jpeglib.h needs it
#include <jpeglib.h>
#include <jerror.h>
// clang-format on

#include <algorithm>
#include <csetjmp>
#include <cstdlib>
#include <vector>

#include "artwork/images/formats/image_readers.h"

namespace tessera {
namespace {

constexpr int kProfileMarker = JPEG_APP0 + 2;
constexpr int kCmykChannels = 4;

/// libjpeg leaves by longjmp: between setjmp and the failing call there must be nothing that needs a destructor.
class JpegReader {
 public:
  JpegReader() {
    info_.err = jpeg_std_error(&errors_);
    errors_.error_exit = leave;
    errors_.emit_message = note;
    errors_.output_message = [](j_common_ptr) {};
    info_.client_data = this;
  }
  ~JpegReader() { jpeg_destroy_decompress(&info_); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;

  /// Reads everything before the pixels. This function and the other bool members return false where the file is
  /// damaged.
  bool read_header(std::span<const std::uint8_t> bytes) {
    if (setjmp(leave_)) return false;
    jpeg_create_decompress(&info_);
    jpeg_mem_src(&info_, bytes.data(), static_cast<unsigned long>(bytes.size()));
    jpeg_save_markers(&info_, kProfileMarker, 0xffff);
    jpeg_read_header(&info_, TRUE);
    return true;
  }

  /// Reads the colour profile; to be called after read_header(). It stays empty where the file has no whole profile.
  bool read_profile(std::vector<std::uint8_t>& profile) {
    JOCTET* data = nullptr;
    unsigned size = 0;
    if (setjmp(leave_)) return false;
    if (!jpeg_read_icc_profile(&info_, &data, &size)) return true;
    profile.assign(data, data + size);
    std::free(data);
    return true;
  }

  double width_px() const { return info_.image_width; }
  double height_px() const { return info_.image_height; }
  bool is_grey() const { return info_.num_components == 1; }
  bool is_cmyk() const { return info_.num_components == kCmykChannels; }

  bool start() {
    if (setjmp(leave_)) return false;
    info_.out_color_space = is_grey() ? JCS_GRAYSCALE : is_cmyk() ? JCS_CMYK : JCS_EXT_BGR;
    jpeg_start_decompress(&info_);
    return true;
  }

  bool read_row(std::uint8_t* row) {
    if (setjmp(leave_)) return false;
    return jpeg_read_scanlines(&info_, &row, 1) == 1;
  }

  /// Whether pixels were invented for missing or damaged data. Where all data come in one scan, a missing mark at the
  /// end of the file is no loss.
  bool lost_pixels() { return lost_data_ || (ended_early_ && (jpeg_has_multiple_scans(&info_) || info_.arith_code)); }
  bool ended_early() const { return ended_early_; }

 private:
  static JpegReader& of(j_common_ptr info) { return *static_cast<JpegReader*>(info->client_data); }

  [[noreturn]] static void leave(j_common_ptr info) { std::longjmp(of(info).leave_, 1); }

  static void note(j_common_ptr info, int level) {
    if (level >= 0) return;  // no warning
    constexpr int kLosses[] = {JWRN_HIT_MARKER, JWRN_HUFF_BAD_CODE, JWRN_MUST_RESYNC, JWRN_ARITH_BAD_CODE};
    const int code = info->err->msg_code;
    JpegReader& reader = of(info);
    reader.ended_early_ = reader.ended_early_ || code == JWRN_JPEG_EOF;
    reader.lost_data_ = reader.lost_data_ || std::ranges::find(kLosses, code) != std::end(kLosses);
  }

  jpeg_decompress_struct info_{};
  jpeg_error_mgr errors_{};
  std::jmp_buf leave_;
  bool ended_early_ = false;
  bool lost_data_ = false;
};

void bgr_of_inverted_cmyk(const std::vector<std::uint8_t>& cmyk, std::uint8_t* bgr) {
  for (std::size_t i = 0; i < cmyk.size(); i += kCmykChannels, bgr += 3) {
    const int black = cmyk[i + 3];
    const auto channel = [&](std::size_t c) { return std::uint8_t(black - ((255 - cmyk[i + c]) * black >> 8)); };
    bgr[2] = channel(0);
    bgr[1] = channel(1);
    bgr[0] = channel(2);
  }
}

}  // namespace

DecodedImage read_jpeg(std::span<const std::uint8_t> bytes, const ReadingRules& rules) {
  JpegReader reader;
  const auto check = [&](bool is_fine) {
    if (is_fine) return;
    if (reader.ended_early()) throw_ends_early();
    throw_damaged();
  };
  check(reader.read_header(bytes));
  const int type = reader.is_grey() ? CV_8UC1 : CV_8UC3;
  DecodedImage image{.pixels = room_for_pixels(reader.width_px(), reader.height_px(), type, rules)};
  if (!reader.is_cmyk()) check(reader.read_profile(image.profile));
  check(reader.start());
  std::vector<std::uint8_t> cmyk(reader.is_cmyk() ? std::size_t(image.pixels.cols) * kCmykChannels : 0);
  for (int y = 0; y < image.pixels.rows; ++y) {
    check(reader.read_row(cmyk.empty() ? image.pixels.ptr(y) : cmyk.data()));
    if (!cmyk.empty()) bgr_of_inverted_cmyk(cmyk, image.pixels.ptr(y));
  }
  check(!reader.lost_pixels());
  return image;
}

}  // namespace tessera
