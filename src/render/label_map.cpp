#include "render/label_map.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/rank_pool.h"
#include "core/geometry/rasterise.h"
#include "job/picture_size.h"
#include "render/pieces/drawn_pieces.h"
#include "render/pieces/piece_drawing.h"

namespace tessera {
namespace {

constexpr int kBandRows = 512;  // a multiple of kStripRows
constexpr std::size_t kMostPieces = std::numeric_limits<std::uint16_t>::max();

struct LabelledPiece {
  const Outline* outline = nullptr;
  Similarity picture_from_shape;
  int label = 0;
  Window reach;
};

std::vector<LabelledPiece> labelled_pieces(const CollageReport& report, const ShapeArtworks& artworks,
                                           double picture_px) {
  std::vector<LabelledPiece> pieces;
  for (const auto& [placement, piece] : drawn_pieces(report, artworks)) {
    const Outline& outline = report.shape(placement.shape).outline;
    const Similarity picture_from_shape = scaled(placement.canvas_from_shape, float(picture_px));
    pieces.push_back({&outline, picture_from_shape, int(piece) + 1, bounding_window(outline, picture_from_shape)});
  }
  return pieces;
}

/// Fills one strip. `top`: its first row in the picture.
template <class Label>
void fill_strip(const std::vector<LabelledPiece>& pieces, int top, cv::Mat strip) {
  const Window window{0, top, strip.cols, top + strip.rows};
  for (const LabelledPiece& piece : pieces) {
    if (piece.reach.y0 >= window.y1 || piece.reach.y1 <= window.y0) continue;
    for (const Span& span : fill_spans(*piece.outline, piece.picture_from_shape, window)) {
      Label* row = strip.ptr<Label>(span.y - top);
      std::fill(row + span.x0, row + span.x1, Label(piece.label));
    }
  }
}

}  // namespace

PictureFormat label_format(const CollageReport& report) {
  const std::size_t count = report.placements.size();
  if (count > kMostPieces) {
    throw InputError("output.labels: found " + std::to_string(count) +
                     " pieces, allowed: " + std::to_string(kMostPieces) + ", as many as 16 bits have numbers for");
  }
  return {.size = picture_size_px(report.output, *report.canvas),
          .grey_bits = count <= std::numeric_limits<std::uint8_t>::max() ? 8 : 16};
}

void draw_labels(const CollageReport& report, const ShapeArtworks& artworks,
                 const std::function<void(const cv::Mat& rows)>& take) {
  const PictureFormat format = label_format(report);
  const std::vector<LabelledPiece> pieces =
      labelled_pieces(report, artworks, double(format.size.width) / report.canvas->width_px);
  for (int top = 0; top < format.size.height; top += kBandRows) {
    const int rows = std::min(kBandRows, format.size.height - top);
    cv::Mat band(rows, format.size.width, format.grey_bits == 8 ? CV_8UC1 : CV_16UC1, cv::Scalar(0));
    parallel_for(std::size_t((rows + kStripRows - 1) / kStripRows), [&](std::size_t strip) {
      const int begin = int(strip) * kStripRows;
      const cv::Mat part = band.rowRange(begin, std::min(begin + kStripRows, rows));
      format.grey_bits == 8 ? fill_strip<std::uint8_t>(pieces, top + begin, part)
                            : fill_strip<std::uint16_t>(pieces, top + begin, part);
    });
    take(band);
  }
}

void write_labels(const CollageReport& report, const ShapeArtworks& artworks, PictureFile& file,
                  const StopWatcher& stop, const std::function<void(std::size_t rows)>& progressed) {
  std::size_t written = 0;
  draw_labels(report, artworks, [&](const cv::Mat& rows) {
    stop.check();
    file.write(rows);
    progressed(written += std::size_t(rows.rows));
  });
  stop.check();
  file.finish();
}

}  // namespace tessera
