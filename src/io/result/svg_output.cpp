#include "io/result/svg_output.h"

#include <glib.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "core/base/error.h"
#include "core/geometry/contour.h"
#include "core/geometry/rasterise.h"
#include "io/artwork/artwork_page.h"
#include "io/artwork/artwork_render.h"
#include "io/artwork/svg_page.h"
#include "io/number_text.h"
#include "io/parallel_for.h"
#include "io/result/artwork_clip.h"
#include "io/result/artwork_original.h"
#include "io/result/sprite.h"
#include "io/artwork/svg_import.h"
#include "io/xml_writer.h"

namespace tessera::io {
namespace {

constexpr int kMaxBitmapSide_px = 2048;  // of an embedded picture; larger ones are scaled down

/// A definition in the document and how it lies in the artwork frame.
struct Symbol {
  std::string xml;
  double artwork_px_per_unit = 1;
};

std::string symbol_id(std::size_t slot) { return "a" + std::to_string(slot); }
std::string clip_id(std::size_t slot) { return "c" + std::to_string(slot); }

int longest_side(const Artwork& artwork) { return std::max(artwork.width_px, artwork.height_px); }

std::string png_uri(const std::vector<std::uint8_t>& png) {
  gchar* base64 = g_base64_encode(png.data(), png.size());
  std::string uri = std::string("data:image/png;base64,") + base64;
  g_free(base64);
  return uri;
}

Symbol bitmap_symbol(const std::vector<std::uint8_t>& png, cv::Size size, const std::string& id, const Artwork& artwork) {
  XmlWriter writer;
  writer.start("image").attribute("id", id);
  writer.attribute("width", std::to_string(size.width)).attribute("height", std::to_string(size.height));
  writer.attribute("preserveAspectRatio", "none").attribute("xlink:href", png_uri(png));
  return {writer.finish(), double(longest_side(artwork)) / std::max(size.width, size.height)};
}

Symbol thumbnail_symbol(const Artwork& artwork, const std::string& id) {
  if (artwork.thumbnail_png.empty()) return {};
  const cv::Mat image = cv::imdecode(artwork.thumbnail_png, cv::IMREAD_UNCHANGED);
  return image.empty() ? Symbol{} : bitmap_symbol(artwork.thumbnail_png, image.size(), id, artwork);
}

/// Empty where there is no original that can be used.
Symbol original_symbol(const Artwork& artwork, const std::string& id) {
  const std::vector<std::uint8_t> bytes = artwork_original(artwork).bytes;
  if (bytes.empty()) return {};
  try {
    const cv::Size2d size = open_artwork_page(bytes, artwork.path)->natural_size();
    const double side = std::max(size.width, size.height);
    if (looks_like_svg(bytes)) return {import_svg(bytes, artwork.path, id, size), longest_side(artwork) / side};
    const cv::Mat bgra = render_artwork(bytes, artwork.path, int(std::clamp(side, 1., double(kMaxBitmapSide_px))));
    std::vector<std::uint8_t> png;
    cv::imencode(".png", bgra, png);
    return bitmap_symbol(png, bgra.size(), id, artwork);
  } catch (const InputError&) {
    return {};
  }
}

std::string path_data(const std::vector<std::vector<Vec2>>& curves, const Similarity& target_from_source) {
  std::string data;
  for (const std::vector<Vec2>& curve : curves) {
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Vec2 p = target_from_source.apply(curve[i]);
      data += i ? 'L' : 'M';
      data += fixed(p.x, 3) + " " + fixed(p.y, 3);
    }
    data += 'Z';
  }
  return data;
}

std::string hex_colour(cv::Vec3b bgr) {
  std::array<char, 8> text;
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", bgr[2], bgr[1], bgr[0]);
  return text.data();
}

Symbol outline_symbol(const Shape& shape, const std::string& id) {
  XmlWriter writer;
  writer.start("path").attribute("id", id).attribute("fill", hex_colour(mean_bgr(shape))).attribute("fill-rule", "evenodd");
  writer.attribute("d", path_data(shape.outline.curves, artwork_from_shape(shape.artwork)));
  return {writer.finish(), 1};
}

Symbol make_symbol(const Shape& shape, const std::string& id, bool quick) {
  Symbol symbol;
  if (!quick) symbol = original_symbol(shape.artwork, id);
  if (symbol.xml.empty()) symbol = thumbnail_symbol(shape.artwork, id);
  return symbol.xml.empty() ? outline_symbol(shape, id) : symbol;
}

std::vector<Symbol> make_symbols(const CollageReport& report, bool quick) {
  std::vector<Symbol> symbols(report.shapes.size());
  parallel_for(symbols.size(), [&](std::size_t slot) {
    symbols[slot] = make_symbol(report.shapes[slot], symbol_id(slot), quick);
  });
  return symbols;
}

/// The region's boundary where the distance is zero. contours() takes what lies beyond the grid as 0 and wants a
/// positive level, so everything is raised.
std::vector<std::vector<Vec2>> region_curves(const CanvasField& distance) {
  constexpr float kRaise = 100;
  Grid<float> raised = distance.value;
  for (float& v : raised.data()) v = std::max(0.f, v + kRaise);
  return contours(raised, kRaise);
}

void write_canvas(const CollageReport& report, XmlWriter& svg) {
  const std::string& background = report.job->output.background;
  svg.start("rect").attribute("width", "100%").attribute("height", "100%").attribute("fill", "#ffffff").end();
  if (report.job->canvas.file.empty()) {
    svg.start("rect").attribute("width", "100%").attribute("height", "100%").attribute("fill", background).end();
  } else {
    const CanvasField& distance = report.canvas->distance;
    const Similarity canvas_from_grid{1, 0, distance.origin.x, distance.origin.y};
    svg.start("path").attribute("fill", background).attribute("fill-rule", "evenodd");
    svg.attribute("d", path_data(region_curves(distance), canvas_from_grid)).end();
  }
}

/// Canvas px from the symbol's units.
std::string matrix_text(const Placement& placement, const Artwork& artwork, double artwork_px_per_unit) {
  const Similarity& t = placement.canvas_from_shape;
  const double unit = 1. / double(artwork.unit_px);
  const double a = t.a * unit;
  const double b = t.b * unit;
  const double x = t.tx - (a * artwork.centroid_px.x - b * artwork.centroid_px.y);
  const double y = t.ty - (b * artwork.centroid_px.x + a * artwork.centroid_px.y);
  const double ak = a * artwork_px_per_unit;
  const double bk = b * artwork_px_per_unit;
  std::string text = "matrix(";
  for (const double v : {ak, bk, -bk, ak}) text += fixed(v, 7) + " ";
  text += fixed(x, 3) + " " + fixed(y, 3) + ")";
  return text;
}

/// In the units of the shape's symbol.
void write_clip(const Shape& shape, const Symbol& symbol, std::size_t slot, XmlWriter& svg) {
  const Similarity symbol_from_shape = scaled(artwork_from_shape(shape.artwork), float(1 / symbol.artwork_px_per_unit));
  svg.raw("\n").start("clipPath").attribute("id", clip_id(slot));
  svg.start("path").attribute("clip-rule", "evenodd");
  svg.attribute("d", path_data(artwork_clip(shape).curves, symbol_from_shape)).end();
  svg.end();
}

void write_pieces(const CollageReport& report, const std::vector<Symbol>& symbols, XmlWriter& svg) {
  for (const Placement& placement : report.placements) {
    const std::size_t slot = report.slot_of(placement.shape);
    svg.raw("\n").start("use").attribute("xlink:href", "#" + symbol_id(slot));
    svg.attribute("clip-path", "url(#" + clip_id(slot) + ")");
    svg.attribute("transform",
                  matrix_text(placement, report.shapes[slot].artwork, symbols[slot].artwork_px_per_unit));
    svg.end();
  }
}

}  // namespace

std::string collage_svg(const CollageReport& report, bool quick) {
  const std::vector<Symbol> symbols = make_symbols(report, quick);
  const std::string size = std::to_string(report.canvas->width_px) + " " + std::to_string(report.canvas->height_px);
  const double picture_px = double(report.job->output.width_px) / report.canvas->width_px;
  XmlWriter svg;
  svg.raw("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n").start("svg").attribute("xmlns", "http://www.w3.org/2000/svg");
  svg.attribute("xmlns:xlink", "http://www.w3.org/1999/xlink").attribute("version", "1.1");
  svg.attribute("width", std::to_string(report.job->output.width_px));
  svg.attribute("height", std::to_string(std::lround(report.canvas->height_px * picture_px)));
  svg.attribute("viewBox", "0 0 " + size);
  svg.raw("\n").start("defs");
  for (const Symbol& symbol : symbols) svg.raw("\n").raw(symbol.xml);
  for (std::size_t slot = 0; slot < symbols.size(); ++slot) write_clip(report.shapes[slot], symbols[slot], slot, svg);
  svg.end().raw("\n");
  write_canvas(report, svg);
  write_pieces(report, symbols, svg);
  return svg.raw("\n").finish();
}

}  // namespace tessera::io
