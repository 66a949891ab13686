#include "artwork/svg/printed_svg.h"

#include <cmath>
#include <cstdlib>

#include "artwork/images/cairo_objects.h"
#include "core/base/error.h"

namespace tessera {
namespace {

/// Resolution on paper of parts that librsvg draws as pixels: filters and masks.
constexpr double kDotsPerPoint = 300. / 72;

/// Parses without librsvg's limits, which a whole collage exceeds; the drawing process has limits of its own.
SvgDocument parsed(const std::string& svg, const std::string& path) {
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(svg.data()), svg.size());
  return SvgDocument(bytes, path, RSVG_HANDLE_FLAG_UNLIMITED);
}

DividedSvg undivided(std::span<const std::uint8_t> svg) {
  DividedSvg divided;
  divided.ground.assign(svg.begin(), svg.end());
  return divided;
}

/// Clips to a path of lines, as in collage.svg.
void clip_to(const std::string& path, cairo_t* cairo) {
  const char* at = path.c_str();
  while (*at) {
    const char command = *at++;
    if (command == 'Z') {
      cairo_close_path(cairo);
      continue;
    }
    char* end = nullptr;
    const double x = std::strtod(at, &end);
    const double y = std::strtod(end, &end);
    if ((command != 'M' && command != 'L') || end == at) throw InputError("a clip that is no path of lines");
    command == 'M' ? cairo_move_to(cairo, x, y) : cairo_line_to(cairo, x, y);
    at = end;
  }
  cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
  cairo_clip(cairo);
}

/// Records a piece by itself, and lets cairo turn it: where a piece is turned, librsvg stretches gradients and patterns
/// that follow its box. The clip is not recorded: cairo 1.16 fails where it leaves nothing of a part.
void draw_piece(const SvgDocument& pieces, const SvgPiece& piece, cv::Size2d points_per_unit, cairo_t* page) {
  const cairo_matrix_t& m = piece.document_from_piece;
  const double dots = std::hypot(m.xx, m.yx) * points_per_unit.width * kDotsPerPoint;
  const CairoSurface recorded(cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, nullptr));
  {
    const CairoContext cairo(cairo_create(recorded.get()));
    cairo_scale(cairo.get(), dots, dots);
    pieces.draw_element(cairo.get(), piece.id, piece.page);
  }
  cairo_save(page);
  cairo_scale(page, points_per_unit.width, points_per_unit.height);
  cairo_transform(page, &m);
  if (!piece.clip.empty()) clip_to(piece.clip, page);
  cairo_scale(page, 1 / dots, 1 / dots);
  cairo_set_source_surface(page, recorded.get(), 0, 0);
  cairo_paint(page);
  cairo_restore(page);
}

}  // namespace

PrintedSvg::PrintedSvg(std::span<const std::uint8_t> svg, const std::string& path, bool pieces_apart)
    : divided_(pieces_apart ? divided_svg(svg, path) : undivided(svg)),
      ground_(parsed(divided_.ground, path)) {
  if (!divided_.list.empty()) pieces_.emplace(parsed(divided_.pieces, path));
}

cv::Size2d PrintedSvg::piece_scale(double width_pt) const {
  const double x = width_pt / divided_.size.width;
  const double y = width_pt * size().height / size().width / divided_.size.height;
  constexpr double kSeen = 1e-6;
  return {x, std::abs(y - x) > kSeen * x ? y : x};  // both differ on a page that is stretched
}

void PrintedSvg::draw(cairo_t* cairo, double width_pt) const {
  cairo_save(cairo);
  ground_.draw(cairo, width_pt / size().width);
  cairo_restore(cairo);
  const cv::Size2d points_per_unit = piece_scale(width_pt);
  for (const SvgPiece& piece : divided_.list) draw_piece(*pieces_, piece, points_per_unit, cairo);
}

}  // namespace tessera
