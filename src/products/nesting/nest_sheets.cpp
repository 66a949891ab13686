#include "products/nesting/nest_sheets.h"

#include <algorithm>
#include <cmath>

#include "artwork/images/cairo_objects.h"
#include "core/base/error.h"
#include "text/number_text.h"
#include "text/xml_writer.h"

namespace tessera {
namespace {

constexpr int kDecimals = 6;  // of mm
constexpr int kPictureSide_px = 2000;

/// An id that XML allows, made of number and name.
std::string id_of(std::size_t number, const std::string& name) {
  std::string id = "piece-" + std::to_string(number) + "-";
  for (const char c : name) {
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    id += plain ? c : '_';
  }
  return id;
}

std::string path_data(const PathSteps& curve) {
  std::string d;
  for (const PathStep& step : curve) {
    d += step.command;
    for (int k = 0; k < points_of(step); ++k) {
      const cv::Point2d p = step.points[std::size_t(k)];
      d += (k > 0 ? " " : "") + fixed(p.x, kDecimals) + "," + fixed(p.y, kDecimals);
    }
  }
  return d;
}

std::string path_data(const NestCut& cut) {
  std::string d;
  for (std::size_t contour = 0; contour < cut.contours.size(); ++contour) {
    if (!cut.curves[contour].empty()) {
      d += path_data(cut.curves[contour]);
      continue;
    }
    const NestRing& ring = cut.contours[contour];
    for (std::size_t i = 0; i < ring.size(); ++i)
      d += (i == 0 ? "M" : "L") + fixed(ring[i].x, kDecimals) + "," + fixed(ring[i].y, kDecimals);
    d += "Z";
  }
  return d;
}

std::string pair(int code, const std::string& value) { return std::to_string(code) + "\n" + value + "\n"; }

std::string polyline(const NestRing& ring, double height_mm, const std::string& layer) {
  std::string text = pair(0, "POLYLINE") + pair(8, layer) + pair(66, "1") + pair(10, "0.0") + pair(20, "0.0") +
                     pair(30, "0.0") + pair(70, "1");
  for (const NestPoint p : ring) {
    text += pair(0, "VERTEX") + pair(8, layer) + pair(10, fixed(p.x, kDecimals)) +
            pair(20, fixed(height_mm - p.y, kDecimals)) + pair(30, "0.0");
  }
  return text + pair(0, "SEQEND") + pair(8, layer);
}

/// Pale colours that differ for neighbouring numbers: steps of the golden angle round the colour wheel.
void set_colour(cairo_t* cairo, int source) {
  const double hue = std::fmod(source * 0.618034, 1.0) * 6;
  const auto channel = [&](double centre) {
    const double off = std::abs(std::fmod(hue - centre + 9, 6) - 3);
    return 0.55 + 0.37 * (1 - std::clamp(off - 1, 0.0, 1.0));
  };
  cairo_set_source_rgb(cairo, channel(0), channel(2), channel(4));
}

void add_path(cairo_t* cairo, const NestRing& contour) {
  cairo_new_sub_path(cairo);
  for (const NestPoint p : contour) cairo_line_to(cairo, p.x, p.y);
  cairo_close_path(cairo);
}

/// Draws lines one contour after the other, because cairo is very slow with the lines of thousands at once.
void draw(cairo_t* cairo, const NestCut& cut, double line_mm) {
  for (const NestRing& contour : cut.contours) add_path(cairo, contour);
  set_colour(cairo, cut.source);
  cairo_fill(cairo);
  cairo_set_source_rgb(cairo, 0.15, 0.15, 0.2);
  cairo_set_line_width(cairo, line_mm);
  for (const NestRing& contour : cut.contours) {
    add_path(cairo, contour);
    cairo_stroke(cairo);
  }
}

cairo_status_t append(void* to, const unsigned char* bytes, unsigned count) {
  static_cast<std::vector<std::uint8_t>*>(to)->insert(static_cast<std::vector<std::uint8_t>*>(to)->end(), bytes,
                                                      bytes + count);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

NestSheet nest_sheet(const NestRun& run, int sheet) {
  NestSheet out;
  out.height_mm = run.problem.height;
  out.width_mm = std::isfinite(run.problem.length) ? run.problem.length : run.layout.used_length;
  for (std::size_t i = 0; i < run.layout.pieces.size(); ++i) {
    const NestedPiece& piece = run.layout.pieces[i];
    if (piece.sheet != sheet) continue;
    const NestDrawing& drawing = run.input.sources[std::size_t(piece.item)].drawing;
    const NestTurn turn = turn_of(run.problem.items[std::size_t(piece.item)].angles_deg[std::size_t(piece.angle)]);
    NestCut& cut = out.cuts.emplace_back();
    cut.source = piece.item;
    cut.id = id_of(i + 1, drawing.name);
    const auto add = [&](const NestRing& ring) {
      PathSteps curve = drawing.curve(cut.contours.size());
      for (PathStep& step : curve) {
        for (cv::Point2d& p : step.points) {
          const NestPoint there = placed(turn, piece, {p.x, p.y});
          p = {there.x, there.y};
        }
      }
      cut.curves.push_back(std::move(curve));
      NestRing& contour = cut.contours.emplace_back();
      for (const NestPoint p : ring) contour.push_back(placed(turn, piece, p));
    };
    add(drawing.outline);
    for (const NestRing& hole : drawing.holes) add(hole);
  }
  return out;
}

std::string sheet_svg(const NestSheet& sheet) {
  const std::string width = fixed(sheet.width_mm, kDecimals), height = fixed(sheet.height_mm, kDecimals);
  XmlWriter svg;
  svg.start("svg")
      .attribute("xmlns", "http://www.w3.org/2000/svg")
      .attribute("width", width + "mm")
      .attribute("height", height + "mm")
      .attribute("viewBox", "0 0 " + width + " " + height);
  svg.start("g").attribute("fill", "none").attribute("stroke", "#000").attribute("stroke-width", "0.1");
  for (const NestCut& cut : sheet.cuts) svg.start("path").attribute("id", cut.id).attribute("d", path_data(cut)).end();
  return svg.finish();
}

std::string sheet_dxf(const NestSheet& sheet) {
  constexpr std::size_t kPointBytes = 64;
  std::string text = pair(0, "SECTION") + pair(2, "HEADER") + pair(9, "$ACADVER") + pair(1, "AC1009") +
                     pair(9, "$INSUNITS") + pair(70, "4") + pair(0, "ENDSEC") + pair(0, "SECTION") +
                     pair(2, "ENTITIES");
  std::size_t points = 0;
  for (const NestCut& cut : sheet.cuts) {
    for (const NestRing& contour : cut.contours) points += contour.size();
  }
  text.reserve(text.size() + kPointBytes * points);
  for (const NestCut& cut : sheet.cuts) {
    for (std::size_t i = 0; i < cut.contours.size(); ++i)
      text += polyline(cut.contours[i], sheet.height_mm, i == 0 ? "OUTLINES" : "HOLES");
  }
  text += pair(0, "ENDSEC") + pair(0, "EOF");
  return text;
}

std::vector<std::uint8_t> sheet_png(const NestSheet& sheet) {
  const double scale = kPictureSide_px / std::max(sheet.width_mm, sheet.height_mm);
  const int width = std::max(1, int(std::ceil(sheet.width_mm * scale))),
            height = std::max(1, int(std::ceil(sheet.height_mm * scale)));
  const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
  const CairoContext cairo(cairo_create(surface.get()));
  cairo_set_source_rgb(cairo.get(), 1, 1, 1);
  cairo_paint(cairo.get());
  cairo_scale(cairo.get(), scale, scale);
  cairo_set_fill_rule(cairo.get(), CAIRO_FILL_RULE_EVEN_ODD);
  for (const NestCut& cut : sheet.cuts) draw(cairo.get(), cut, 1.5 / scale);
  std::vector<std::uint8_t> png;
  if (cairo_surface_write_to_png_stream(surface.get(), append, &png) != CAIRO_STATUS_SUCCESS)
    throw EnvironmentError("cairo cannot draw the layout");
  return png;
}

}  // namespace tessera
