#include "render/picture_drawing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "artwork/images/alpha.h"
#include "artwork/images/colour_conversion.h"
#include "core/base/rank_pool.h"
#include "job/picture_size.h"
#include "render/ground_strips.h"
#include "render/hue_turns.h"
#include "render/keep_out_strips.h"
#include "render/pieces/cairo_paint.h"
#include "render/pieces/drawn_pieces.h"
#include "render/pieces/piece_drawing.h"
#include "render/pieces/shadow.h"
#include "render/pieces/sprite_cache.h"
#include "render/shown_picture.h"

namespace tessera {
namespace {

/// Gives all drawn pixels of premultiplied BGRA this colour.
void tint(cv::Mat& bgra, cv::Vec3b colour) {
  for (int y = 0; y < bgra.rows; ++y) {
    cv::Vec4b* row = bgra.ptr<cv::Vec4b>(y);
    for (int x = 0; x < bgra.cols; ++x) {
      for (int c = 0; c < 3; ++c) row[x][c] = std::uint8_t((colour[c] * row[x][3] + 127) / 255);
    }
  }
}

/// Lays the colours `bgr_at(x, y)` over the picture, by the coverage.
template <class BgrAt>
void blend(const BgrAt& bgr_at, const cv::Mat& coverage, cv::Mat& bgr) {
  for (int y = 0; y < bgr.rows; ++y) {
    cv::Vec3b* row = bgr.ptr<cv::Vec3b>(y);
    const std::uint8_t* covered = coverage.ptr(y);
    for (int x = 0; x < bgr.cols; ++x) {
      const cv::Vec3b above = bgr_at(x, y);
      for (int c = 0; c < 3; ++c) {
        row[x][c] = std::uint8_t((row[x][c] * (255 - covered[x]) + above[c] * covered[x] + 127) / 255);
      }
    }
  }
}

void blend(const cv::Vec3b& colour, const cv::Mat& coverage, cv::Mat& bgr) {
  blend([&](int, int) { return colour; }, coverage, bgr);
}

/// A drawn part of a piece: rows of its box from `top` on.
struct Tile {
  int top = 0;
  cv::Mat bgra;

  int bottom() const { return top + bgra.rows; }
  std::size_t bytes() const { return bgra.total() * bgra.elemSize(); }
};

/// Draws a picture from top to bottom.
class PictureBands {
 public:
  PictureBands(const CollageReport& report, ShapeArtworks& artworks, const PictureLimits& limits)
      : report_(report),
        artworks_(artworks),
        limits_(limits),
        size_(picture_size_px(report.output, *report.canvas)),
        picture_px_(double(size_.width) / report.canvas->width_px),
        opaque_(report.output.background != kNoColour),
        background_(opaque_ ? bgr_of(flat_background(report.output)) : cv::Vec3b()),
        line_colour_(bgr_of(report.output.outline_colour)),
        ground_(report.ground, picture_px_, size_),
        overlay_(report.overlay, picture_px_, size_),
        keep_out_(report.keep_out, picture_px_, size_),
        shadow_(report, size_),
        sprites_(limits.sprite_bytes, [&](std::size_t slot, int side_px) { return artworks.sprite(slot, side_px); }) {
    for (const auto& [placement, piece] : drawn_pieces(report, artworks)) {
      artworks.check_stop();
      if (!report.colours.empty()) tints_.push_back(bgr_of(report.colours[piece]));
      if (!report.tones.empty()) tones_.push_back(report.tones[piece]);
      const std::size_t slot = report.shapes.slot_of(placement.shape);
      pieces_.push_back(make_piece_drawing(placement, report.shapes.slot_of_drawing(slot), report.shapes[slot],
                                           artworks.clip(slot), line_px(), picture_px_, size_));
    }
    tiles_.resize(pieces_.size());
  }

  int rows() const { return size_.height; }
  int rows_in_band() const {
    const std::size_t strip_bytes = std::size_t(kStripRows) * std::size_t(size_.width) * (opaque_ ? 3 : 4);
    return std::clamp(int(limits_.band_bytes / strip_bytes) * kStripRows, kStripRows, limits_.band_rows);
  }

  cv::Mat band(int top) {
    const int bottom = std::min(top + rows_in_band(), size_.height);
    const std::vector<std::size_t> reaching = pieces_between(top, bottom);
    draw_tiles(reaching, top, bottom);
    cv::Mat picture(bottom - top, size_.width, opaque_ ? CV_8UC3 : CV_8UC4);
    const int strips = (picture.rows + kStripRows - 1) / kStripRows;
    parallel_for(std::size_t(strips), [&](std::size_t strip) {
      artworks_.check_stop();
      const int begin = int(strip) * kStripRows;
      draw_strip(reaching, top + begin, picture.rowRange(begin, std::min(begin + kStripRows, picture.rows)));
    });
    for (const std::size_t i : reaching) {
      if (tiles_[i].bottom() <= bottom) forget(tiles_[i]);
    }
    return picture;
  }

 private:
  /// Width of the line along the outlines, px of the picture.
  double line_px() const { return report_.output.outline_px * picture_px_; }

  std::vector<std::size_t> pieces_between(int top, int bottom) const {
    std::vector<std::size_t> reaching;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const cv::Rect& box = pieces_[i].box;
      if (!box.empty() && box.y < bottom && box.br().y > top) reaching.push_back(i);
    }
    return reaching;
  }

  /// Draws the pieces' parts in this band. A piece is drawn to its end if there is room to keep the part for later bands,
  /// otherwise only to the end of this band.
  void draw_tiles(const std::vector<std::size_t>& reaching, int top, int bottom) {
    std::vector<std::size_t> missing;
    std::vector<int> ends;
    for (const std::size_t i : reaching) {
      if (!tiles_[i].bgra.empty()) continue;
      const cv::Rect& box = pieces_[i].box;
      const int begin = std::max(box.y, top);
      const std::size_t whole_bytes = std::size_t(box.width) * std::size_t(box.br().y - begin) * 4;
      const bool fits = tile_bytes_ + whole_bytes <= limits_.tile_bytes;
      tiles_[i].top = begin;
      if (fits) tile_bytes_ += whole_bytes;
      missing.push_back(i);
      ends.push_back(fits ? box.br().y : std::min(box.br().y, bottom));
      tiles_[i].kept = fits;
    }
    parallel_for(missing.size(), [&](std::size_t k) {
      artworks_.check_stop();
      KeptTile& tile = tiles_[missing[k]];
      const PieceDrawing& piece = pieces_[missing[k]];
      const auto sprite = sprites_.get(piece.slot, piece.sprite_side_px);
      tile.bgra = draw_rows(piece, *sprite, tile.top, ends[k]);
      if (!tints_.empty()) tint(tile.bgra, tints_[missing[k]]);
      if (!tones_.empty()) {
        lay_patch(tones_[missing[k]].patch, {piece.box.x, tile.top}, picture_px_, tile.bgra);
        turn_hues(tile.bgra, tones_[missing[k]].turn_deg);
      }
      if (line_px() > 0) draw_line(piece.outline, line_px(), line_colour_, {piece.box.x, tile.top}, tile.bgra);
    });
  }

  void draw_strip(const std::vector<std::size_t>& reaching, int top, cv::Mat strip) const {
    opaque_ ? draw_canvas(top, strip) : draw_ground_alone(top, strip);
    keep_out_.draw(top, strip);
    shadow_.draw(top, strip);
    for (const std::size_t i : reaching) {
      const Tile& tile = tiles_[i];
      const int begin = std::max(top, tile.top), end = std::min(top + strip.rows, tile.bottom());
      if (begin >= end) continue;
      const cv::Rect& box = pieces_[i].box;
      lay_over(tile.bgra.rowRange(begin - tile.top, end - tile.top),
               strip(cv::Rect(box.x, begin - top, box.width, end - begin)));
    }
    lay_within_canvas(overlay_, top, strip);
    if (!opaque_) straighten(strip);
  }

  /// Draws the colours beneath the pieces. They fade over one pixel of the picture at the canvas' edge.
  void draw_canvas(int top, cv::Mat& strip) const {
    const CanvasEdge& edge = report_.canvas_edge;
    strip.setTo(cv::Scalar(background_[0], background_[1], background_[2]));
    if (!ground_.empty()) lay_over(ground_.rows(top, strip.rows), strip);
    const cv::Mat own = edge.grounds.empty() ? cv::Mat() : strip.clone();
    for (const Ground& ground : edge.grounds) {
      const cv::Mat coverage = coverage_of(ground.curves, top, strip);
      if (ground.colour.empty()) {
        blend([&](int x, int y) { return own.at<cv::Vec3b>(y, x); }, coverage, strip);
      } else {
        blend(bgr_of(ground.colour), coverage, strip);
      }
    }
    if (edge.curves.empty()) return;
    cv::Mat outside;
    cv::bitwise_not(coverage_of(edge.curves, top, strip), outside);
    blend({255, 255, 255}, outside, strip);
  }

  /// Draws only the ground: transparent outside the canvas and where there is no ground.
  void draw_ground_alone(int top, cv::Mat& strip) const {
    strip.setTo(cv::Scalar::all(0));
    lay_within_canvas(ground_, top, strip);
  }

  void lay_within_canvas(const GroundStrips& picture, int top, cv::Mat& strip) const {
    if (picture.empty()) return;
    cv::Mat rows = picture.rows(top, strip.rows);
    const Curves& edge = report_.canvas_edge.curves;
    if (!edge.empty()) cut_to(coverage_of(edge, top, strip), rows);
    lay_over(rows, strip);
  }

  /// The coverage of each pixel of a strip that begins at row `top`, CV_8U.
  cv::Mat coverage_of(const Curves& curves, int top, const cv::Mat& strip) const {
    return filled_coverage(curves, {float(picture_px_), 0, 0, 0}, {0, top, strip.cols, strip.rows});
  }

  struct KeptTile : Tile {
    bool kept = false;  // counts in tile_bytes_
  };

  void forget(KeptTile& tile) {
    if (tile.kept) tile_bytes_ -= tile.bytes();
    tile = {};
  }

  const CollageReport& report_;
  const ShapeArtworks& artworks_;
  const PictureLimits limits_;
  const cv::Size size_;
  const double picture_px_;  // picture px of a canvas px
  const bool opaque_;
  const cv::Vec3b background_;
  const cv::Vec3b line_colour_;
  const GroundStrips ground_;
  const GroundStrips overlay_;
  const KeepOutStrips keep_out_;
  const Shadow shadow_;
  SpriteCache sprites_;
  std::vector<PieceDrawing> pieces_;
  std::vector<Tone> tones_;       // of the pieces; empty: none
  std::vector<cv::Vec3b> tints_;  // of the pieces; empty: their own colours
  std::vector<KeptTile> tiles_;   // of the pieces
  std::size_t tile_bytes_ = 0;
};

}  // namespace

void draw_picture(const CollageReport& report, ShapeArtworks& artworks, const PictureLimits& limits,
                  const std::function<void(const cv::Mat& rows)>& take) {
  PictureBands bands(report, artworks, limits);
  cv::Mat before;  // the band that is handed out while the next one is drawn
  for (int top = 0; top < bands.rows(); top += bands.rows_in_band()) {
    cv::Mat band;
    run_both([&] { band = bands.band(top); },
             [&] {
               if (!before.empty()) take(before);
             });
    before = std::move(band);
  }
  if (!before.empty()) take(before);
}

PictureFormat picture_format(const CollageReport& report) {
  const OutputSpec& output = report.output;
  return {.size = picture_size_px(output, *report.canvas),
          .alpha = output.background == kNoColour,
          .size_mm = page_size_mm(output, report.box, *report.canvas)};
}

void write_picture(const CollageReport& report, ShapeArtworks& artworks, const std::vector<PictureFile*>& files,
                   const StopWatcher& stop, const std::function<void(std::size_t rows)>& progressed) {
  std::size_t written = 0;
  draw_picture(report, artworks, {}, [&](const cv::Mat& rows) {
    for (int y = 0; y < rows.rows; y += kStripRows) {
      stop.check();
      for (PictureFile* file : files) file->write(rows.rowRange(y, std::min(y + kStripRows, rows.rows)));
    }
    progressed(written += std::size_t(rows.rows));
  });
  stop.check();
  for (PictureFile* file : files) file->finish();
}

}  // namespace tessera
