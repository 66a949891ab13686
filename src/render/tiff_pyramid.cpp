#include "render/tiff_pyramid.h"

#include <fcntl.h>
#include <tiffio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <opencv2/imgproc.hpp>
#include <system_error>
#include <utility>

#include "artwork/images/alpha.h"
#include "core/base/error.h"
#include "job/picture_size.h"

namespace tessera {
namespace {

constexpr int kTile_px = 256;
constexpr double kMostClassicBytes = 3.5e9;  // of 2^32, before compression, so that there is room for the tables

int silent(TIFF*, void*, const char*, const char*, va_list) { return 1; }

struct CloseTiff {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using TiffPtr = std::unique_ptr<TIFF, CloseTiff>;

/// Opens a TIFF with a descriptor of its own. Null, with errno set, where that fails.
TiffPtr open_tiff(const FileDescriptor& file, const char* mode) {
  FileDescriptor own(fcntl(file.number(), F_DUPFD_CLOEXEC, 0));
  if (!own.is_open()) return nullptr;
  TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options, silent, nullptr);
  TIFFOpenOptionsSetWarningHandlerExtR(options, silent, nullptr);
  TiffPtr tiff(TIFFFdOpenExt(own.number(), "", mode, options));
  TIFFOpenOptionsFree(options);
  if (tiff) own.release();  // TIFFClose closes it
  return tiff;
}

/// The rows at half the size: means of 2 x 2 px; an odd edge counts twice.
cv::Mat halved(const cv::Mat& rows) {
  cv::Mat even;
  cv::copyMakeBorder(rows, even, 0, rows.rows % 2, 0, rows.cols % 2, cv::BORDER_REPLICATE);
  if (even.channels() == 4) even = premultiplied(even);
  cv::Mat half;
  cv::resize(even, half, even.size() / 2, 0, 0, cv::INTER_AREA);
  if (half.channels() == 4) straighten(half);
  return half;
}

[[noreturn]] void fail(const std::string& path, int reason) {
  throw EnvironmentError("cannot write " + path + ": " + std::generic_category().message(reason ? reason : EIO));
}

void set_tags(TIFF* tiff, const PictureFormat& format, bool is_reduced) {
  TIFFSetField(tiff, TIFFTAG_SUBFILETYPE, is_reduced ? FILETYPE_REDUCEDIMAGE : 0);
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, std::uint32_t(format.size.width));
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, std::uint32_t(format.size.height));
  TIFFSetField(tiff, TIFFTAG_TILEWIDTH, kTile_px);
  TIFFSetField(tiff, TIFFTAG_TILELENGTH, kTile_px);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, format.alpha ? 4 : 3);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
  TIFFSetField(tiff, TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
  if (format.alpha) {
    const std::uint16_t straight = EXTRASAMPLE_UNASSALPHA;
    TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &straight);
  }
  if (format.size_mm.width > 0) {
    TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
    TIFFSetField(tiff, TIFFTAG_XRESOLUTION, format.size.width * kMmPerInch / format.size_mm.width);
    TIFFSetField(tiff, TIFFTAG_YRESOLUTION, format.size.height * kMmPerInch / format.size_mm.height);
  }
}

}  // namespace

/// One picture of the pyramid. All but the first wait in files without names until they can be appended: a TIFF is written
/// one directory after the other.
class TiffPyramid::Level {
 public:
  /// `path` names the pyramid's file in messages.
  Level(const std::string& path, FileDescriptor file, const PictureFormat& format, bool is_reduced, const char* mode)
      : path_(path),
        format_(format),
        file_(std::move(file)),
        tiff_(open_tiff(file_, mode)) {
    if (!tiff_) fail(path_, errno);
    set_tags(tiff_.get(), format, is_reduced);
  }

  const PictureFormat& format() const { return format_; }
  /// The number of rows that the present row of tiles lacks.
  int room() const { return kTile_px - waiting_.rows; }
  TIFF* tiff() { return tiff_.get(); }

  /// Adds at most room() rows. Returns the rows of a complete row of tiles when it was written, otherwise nothing.
  cv::Mat add(const cv::Mat& rows) {
    waiting_.push_back(rows);
    const bool is_last = written_rows_ + waiting_.rows == format_.size.height;
    if (waiting_.rows < kTile_px && !is_last) return {};
    write_tiles();
    written_rows_ += waiting_.rows;
    return std::exchange(waiting_, {});
  }

  /// Finishes the picture, after all rows are written.
  void finish() {
    errno = 0;
    if (TIFFFlush(tiff_.get()) == 0) fail(path_, errno);
    tiff_.reset();
  }

  /// Opens the written picture for reading.
  TiffPtr reopened() {
    finish();
    if (lseek(file_.number(), 0, SEEK_SET) != 0) fail(path_, errno);
    TiffPtr tiff = open_tiff(file_, "r");
    if (!tiff) fail(path_, errno);
    return tiff;
  }

 private:
  void write_tiles() {
    cv::Mat tile(kTile_px, kTile_px, waiting_.type());
    for (int x = 0; x < waiting_.cols; x += kTile_px) {
      const int width = std::min(kTile_px, waiting_.cols - x);
      tile.setTo(cv::Scalar::all(0));
      cv::Mat part = tile(cv::Rect(0, 0, width, waiting_.rows));
      cv::cvtColor(waiting_.colRange(x, x + width), part, format_.alpha ? cv::COLOR_BGRA2RGBA : cv::COLOR_BGR2RGB);
      const auto number = TIFFComputeTile(tiff_.get(), std::uint32_t(x), std::uint32_t(written_rows_), 0, 0);
      errno = 0;
      if (TIFFWriteEncodedTile(tiff_.get(), number, tile.data, tmsize_t(tile.total() * tile.elemSize())) < 0) {
        fail(path_, errno);
      }
    }
  }

  const std::string path_;
  const PictureFormat format_;
  FileDescriptor file_;
  TiffPtr tiff_;
  cv::Mat waiting_;  // rows that do not fill a row of tiles yet
  int written_rows_ = 0;
};

TiffPyramid::TiffPyramid(const std::string& path, const PictureFormat& format) : path_(path), file_(path) {
  const double bytes = double(format.size.width) * format.size.height * (format.alpha ? 4 : 3) * 4 / 3;
  const char* mode = bytes > kMostClassicBytes ? "w8" : "w";
  PictureFormat level = format;
  levels_.push_back(std::make_unique<Level>(path, file_.duplicate(), level, false, mode));
  while (std::max(level.size.width, level.size.height) > kTile_px) {
    level.size = {(level.size.width + 1) / 2, (level.size.height + 1) / 2};
    levels_.push_back(std::make_unique<Level>(path, create_unnamed_file(path, ".level"), level, true, mode));
  }
}

TiffPyramid::~TiffPyramid() = default;

void TiffPyramid::write(const cv::Mat& rows) { add_rows(0, rows); }

void TiffPyramid::add_rows(std::size_t level, const cv::Mat& rows) {
  for (int begin = 0, end = 0; begin < rows.rows; begin = end) {
    end = std::min(rows.rows, begin + levels_[level]->room());
    const cv::Mat done = levels_[level]->add(rows.rowRange(begin, end));
    if (!done.empty() && level + 1 < levels_.size()) add_rows(level + 1, halved(done));
  }
}

void TiffPyramid::finish() {
  for (std::size_t level = 1; level < levels_.size(); ++level) append(*levels_[level]);
  levels_[0]->finish();
  levels_.clear();
  file_.commit();
}

/// Appends the picture as the next directory of the file, without unpacking its tiles.
void TiffPyramid::append(Level& level) {
  const TiffPtr from = level.reopened();
  TIFF* to = levels_[0]->tiff();
  errno = 0;
  if (TIFFWriteDirectory(to) == 0) fail(path_, errno);
  set_tags(to, level.format(), true);
  std::vector<std::uint8_t> bytes;
  for (std::uint32_t tile = 0; tile < TIFFNumberOfTiles(from.get()); ++tile) {
    bytes.resize(TIFFGetStrileByteCount(from.get(), tile));
    const auto size = tmsize_t(bytes.size());
    if (TIFFReadRawTile(from.get(), tile, bytes.data(), size) != size ||
        TIFFWriteRawTile(to, tile, bytes.data(), size) != size) {
      fail(path_, errno);
    }
  }
}

}  // namespace tessera
