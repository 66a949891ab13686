#include "io/result/svg_output.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/rasterise.h"
#include "io/job/picture_size.h"
#include "io/number_text.h"
#include "io/parallel_for.h"
#include "io/result/artwork_original.h"
#include "io/result/svg_layers.h"
#include "io/result/svg_path.h"
#include "io/utf8_text.h"
#include "io/xml_writer.h"

namespace tessera::io {
namespace {

std::string symbol_id(std::size_t slot) { return "a" + std::to_string(slot); }
std::string clip_id(std::size_t slot) { return "c" + std::to_string(slot); }

std::vector<SvgSymbol> make_symbols(const CollageReport& report, ShapeArtworks& artworks, const DoneCount& done) {
  std::vector<SvgSymbol> symbols(report.shapes.size());
  parallel_for(symbols.size(), [&](std::size_t slot) {
    symbols[slot] = artworks.symbol(slot, symbol_id(slot));
    done();
  });
  return symbols;
}

void start_layer(const SvgLayer& layer, XmlWriter& svg) {
  svg.start("g").attribute("id", layer.id);
  svg.attribute("inkscape:groupmode", "layer").attribute("inkscape:label", layer.label);
}

const SvgLayer kCanvasLayer{.id = "layer-canvas", .label = "Canvas", .pieces = {}};

void write_canvas(const CollageReport& report, XmlWriter& svg) {
  const std::string& background = report.job->output.background;
  if (background == kNoColour) return;
  start_layer(kCanvasLayer, svg);
  svg.start("rect").attribute("width", "100%").attribute("height", "100%").attribute("fill", "#ffffff").end();
  if (report.canvas_edge.empty()) {
    svg.start("rect").attribute("width", "100%").attribute("height", "100%").attribute("fill", background).end();
  } else {
    svg.start("path").attribute("fill", background).attribute("fill-rule", "evenodd");
    svg.attribute("d", svg_path(report.canvas_edge, {1, 0, 0, 0})).end();
  }
  svg.end();
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
void write_clip(const Shape& shape, const SvgSymbol& symbol, const Outline& clip, std::size_t slot, XmlWriter& svg) {
  const Similarity symbol_from_shape = scaled(artwork_from_shape(shape.artwork), float(1 / symbol.artwork_px_per_unit));
  svg.raw("\n").start("clipPath").attribute("id", clip_id(slot));
  svg.start("path").attribute("clip-rule", "evenodd");
  svg.attribute("d", svg_path(clip.curves, symbol_from_shape)).end();
  svg.end();
}

/// A group of its own, so that what belongs to a piece moves with it.
void write_piece(const CollageReport& report, const std::vector<SvgSymbol>& symbols, std::size_t piece, XmlWriter& svg) {
  const Placement& placement = report.placements[piece];
  const std::size_t slot = report.slot_of(placement.shape);
  const Shape& shape = report.shapes[slot];
  const std::string title = printable_utf8(shape.name);
  svg.raw("\n").start("g").attribute("id", svg_piece_id(piece, shape.name)).attribute("inkscape:label", title);
  svg.attribute("transform", matrix_text(placement, shape.artwork, symbols[slot].artwork_px_per_unit));
  svg.start("title").text(title).end();
  svg.start("use").attribute("xlink:href", "#" + symbol_id(slot));
  svg.attribute("clip-path", "url(#" + clip_id(slot) + ")").end();
  svg.end();
}

/// Layer by layer, in the order of their first pieces; within a layer in order of placement.
void write_pieces(const CollageReport& report, const std::vector<SvgSymbol>& symbols, XmlWriter& svg) {
  for (const SvgLayer& layer : piece_layers(report.placements)) {
    svg.raw("\n");
    start_layer(layer, svg);
    for (const std::size_t piece : layer.pieces) write_piece(report, symbols, piece, svg);
    svg.end();
  }
}

void write_size(const CollageReport& report, XmlWriter& svg) {
  const OutputSpec& output = report.job->output;
  if (output.width_mm == 0) {
    const cv::Size size = picture_size_px(output, *report.canvas);
    svg.attribute("width", std::to_string(size.width)).attribute("height", std::to_string(size.height));
  } else {
    const double height_mm = output.width_mm * report.canvas->height_px / report.canvas->width_px;
    svg.attribute("width", fixed(output.width_mm, 3) + "mm").attribute("height", fixed(height_mm, 3) + "mm");
  }
}

}  // namespace

std::string collage_svg(const CollageReport& report, ShapeArtworks& artworks, const DoneCount& done) {
  const std::vector<SvgSymbol> symbols = make_symbols(report, artworks, done);
  const std::string size = std::to_string(report.canvas->width_px) + " " + std::to_string(report.canvas->height_px);
  XmlWriter svg;
  svg.raw("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n").start("svg").attribute("xmlns", "http://www.w3.org/2000/svg");
  svg.attribute("xmlns:xlink", "http://www.w3.org/1999/xlink").attribute("version", "1.1");
  svg.attribute("xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape");
  write_size(report, svg);
  svg.attribute("viewBox", "0 0 " + size);
  svg.raw("\n").start("defs");
  for (const SvgSymbol& symbol : symbols) svg.raw("\n").raw(symbol.xml);
  for (std::size_t slot = 0; slot < symbols.size(); ++slot) {
    write_clip(report.shapes[slot], symbols[slot], artworks.clip(slot), slot, svg);
  }
  svg.end().raw("\n");
  write_canvas(report, svg);
  write_pieces(report, symbols, svg);
  return svg.raw("\n").finish();
}

}  // namespace tessera::io
