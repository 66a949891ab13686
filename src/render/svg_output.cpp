#include "render/svg_output.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "artwork/images/png_uri.h"
#include "core/base/rank_pool.h"
#include "core/geometry/rasterise.h"
#include "job/picture_size.h"
#include "layers/affine.h"
#include "render/pieces/artwork_original.h"
#include "render/pieces/drawn_pieces.h"
#include "render/pieces/svg_path.h"
#include "render/shown_picture.h"
#include "render/svg_layers.h"
#include "text/number_text.h"
#include "text/utf8_text.h"
#include "text/xml_writer.h"

namespace tessera {
namespace {

std::string symbol_id(std::size_t slot) { return "a" + std::to_string(slot); }
std::string clip_id(std::size_t slot) { return "c" + std::to_string(slot); }
std::string patch_clip_id(std::size_t slot) { return "p" + std::to_string(slot); }
std::string outline_id(std::size_t slot) { return "o" + std::to_string(slot); }

bool has_shadow(const OutputSpec& output) { return output.shadow_strength > 0; }
bool has_outlines(const OutputSpec& output) { return output.outline_px > 0 || has_shadow(output); }

std::vector<SvgSymbol> make_symbols(const CollageReport& report, ShapeArtworks& artworks, const DoneCount& done) {
  std::vector<SvgSymbol> symbols(report.shapes.size());
  parallel_for(symbols.size(), [&](std::size_t slot) {
    if (report.shapes.slot_of_drawing(slot) == slot) symbols[slot] = artworks.symbol(slot, symbol_id(slot));
    done();
  });
  return symbols;
}

/// The drawing of a piece's shape, and the part of the document that holds it.
struct Drawing {
  std::size_t slot;
  double artwork_px_per_unit;
};

Drawing drawing_of(const CollageReport& report, const std::vector<SvgSymbol>& symbols, const Placement& placement) {
  const std::size_t slot = report.shapes.slot_of_drawing(report.shapes.slot_of(placement.shape));
  return {slot, symbols[slot].artwork_px_per_unit};
}

void start_layer(const SvgLayer& layer, XmlWriter& svg) {
  svg.start("g").attribute("id", layer.id);
  svg.attribute("inkscape:groupmode", "layer").attribute("inkscape:label", layer.label);
}

const SvgLayer kCanvasLayer{.id = "layer-canvas", .label = "Canvas", .pieces = {}};
const SvgLayer kKeepOutLayer{.id = "layer-keep-out", .label = "Keep out", .pieces = {}};
constexpr const char* kKeepOutClipId = "clip-keep-out";  // ids of the drawing begin with keep-out
const SvgLayer kShadowLayer{.id = "layer-shadow", .label = "Shadow", .pieces = {}};

void write_rectangle(const std::string& colour, XmlWriter& svg) {
  svg.start("rect").attribute("width", "100%").attribute("height", "100%").attribute("fill", colour).end();
}

const SvgLayer kOverlayLayer{.id = "layer-overlay", .label = "Overlay", .pieces = {}};
constexpr const char* kGroundId = "ground";
constexpr const char* kOverlayId = "overlay";

/// The fill of the canvas.
std::string canvas_fill(const CollageReport& report) {
  return report.ground.svg.empty() ? flat_background(report.output) : std::string("url(#") + kGroundId + ")";
}

/// Writes the ground's tiles as a pattern, on the background.
void write_pattern(const GroundTile& ground, const char* id, const std::string& background, XmlWriter& svg) {
  if (ground.svg.empty()) return;
  const std::string width = fixed(ground.size_px.width, 7), height = fixed(ground.size_px.height, 7);
  svg.raw("\n").start("pattern").attribute("id", id).attribute("patternUnits", "userSpaceOnUse");
  svg.attribute("width", width).attribute("height", height);
  if (background != kNoColour) {
    svg.start("rect").attribute("width", width).attribute("height", height).attribute("fill", background).end();
  }
  svg.start("g").attribute("transform", "scale(" + fixed(ground.size_px.width / ground.svg_size.width, 9) + " " +
                                            fixed(ground.size_px.height / ground.svg_size.height, 9) + ")");
  svg.raw(ground.svg).end().end();
}

/// Writes the grounds, cut off at the canvas' edge. They reach beyond it, because only one of two edges may blur there.
void write_grounds(const CanvasEdge& edge, const std::string& fill, XmlWriter& svg) {
  svg.start("clipPath").attribute("id", "canvas").start("path").attribute("clip-rule", "evenodd");
  svg.attribute("d", svg_path(edge.curves, {1, 0, 0, 0})).end().end();
  svg.start("g").attribute("clip-path", "url(#canvas)").attribute("fill-rule", "evenodd");
  write_rectangle(fill, svg);
  for (const Ground& ground : edge.grounds) {
    svg.start("path").attribute("fill", ground.colour.empty() ? fill : ground.colour);
    svg.attribute("d", svg_path(ground.curves, {1, 0, 0, 0})).end();
  }
  svg.end();
}

void write_canvas_shape(const CanvasEdge& edge, const std::string& fill, XmlWriter& svg) {
  if (edge.curves.empty()) return write_rectangle(fill, svg);
  svg.start("path").attribute("fill", fill).attribute("fill-rule", "evenodd");
  svg.attribute("d", svg_path(edge.curves, {1, 0, 0, 0})).end();
}

void write_canvas(const CollageReport& report, XmlWriter& svg) {
  const std::string fill = canvas_fill(report);
  const CanvasEdge& edge = report.canvas_edge;
  if (fill == kNoColour) return;
  const bool opaque = report.output.background != kNoColour;
  start_layer(kCanvasLayer, svg);
  if (opaque) write_rectangle("#ffffff", svg);
  if (edge.curves.empty() || edge.grounds.empty() || !opaque) {
    write_canvas_shape(edge, fill, svg);
  } else {
    write_grounds(edge, fill, svg);
  }
  svg.end();
}

/// Writes the overlay as a layer, whose opacity programs show and change.
void write_overlay(const CollageReport& report, XmlWriter& svg) {
  if (report.overlay.svg.empty()) return;
  svg.raw("\n");
  start_layer(kOverlayLayer, svg);
  svg.attribute("opacity", fixed(report.overlay_opacity, 4));
  write_canvas_shape(report.canvas_edge, std::string("url(#") + kOverlayId + ")", svg);
  svg.end();
}

void write_keep_out_clip(const KeepOutDrawing& keep_out, XmlWriter& svg) {
  if (keep_out.clip.empty()) return;
  svg.raw("\n").start("clipPath").attribute("id", kKeepOutClipId);
  svg.start("path").attribute("clip-rule", "evenodd").attribute("d", svg_path(keep_out.clip, {1, 0, 0, 0})).end();
  svg.end();
}

void write_keep_out(const KeepOutDrawing& keep_out, XmlWriter& svg) {
  if (keep_out.svg.empty()) return;
  svg.raw("\n");
  start_layer(kKeepOutLayer, svg);
  svg.start("g");
  if (!keep_out.clip.empty()) svg.attribute("clip-path", std::string("url(#") + kKeepOutClipId + ")");
  const std::string unit_px = fixed(keep_out.place_px.width / keep_out.svg_width, 7);
  svg.start("g").attribute("transform", "matrix(" + unit_px + " 0 0 " + unit_px + " " + fixed(keep_out.place_px.x, 3) +
                                            " " + fixed(keep_out.place_px.y, 3) + ")");
  svg.raw(keep_out.svg).end().end().end();
}

/// Maps the symbol's units to canvas px.
cv::Matx23d canvas_from_symbol(const Placement& placement, const Artwork& artwork, double artwork_px_per_unit) {
  const Similarity& t = placement.canvas_from_shape;
  const double unit = 1. / double(artwork.unit_px);
  const double a = t.a * unit;
  const double b = t.b * unit;
  const double side = artwork.mirrored ? -1 : 1;  // direction of x, seen from the centroid
  const double x = t.tx - (side * a * artwork.centroid_px.x - b * artwork.centroid_px.y);
  const double y = t.ty - (side * b * artwork.centroid_px.x + a * artwork.centroid_px.y);
  const double ak = a * artwork_px_per_unit;
  const double bk = b * artwork_px_per_unit;
  return {side * ak, -bk, x, side * bk, ak, y};
}

std::string matrix_text(const cv::Matx23d& m) {
  std::string text = "matrix(";
  for (const double v : {m(0, 0), m(1, 0), m(0, 1), m(1, 1)}) text += fixed(v, 7) + " ";
  text += fixed(m(0, 2), 3) + " " + fixed(m(1, 2), 3) + ")";
  return text;
}

Similarity symbol_from_shape(const Shape& shape, const SvgSymbol& symbol) {
  return scaled(artwork_from_shape(shape.artwork), float(1 / symbol.artwork_px_per_unit));
}

/// Writes a clip path in the units of the shape's symbol.
void write_clip(const std::string& id, const Shape& shape, const SvgSymbol& symbol, const Outline& clip,
                XmlWriter& svg) {
  svg.raw("\n").start("clipPath").attribute("id", id);
  svg.start("path").attribute("clip-rule", "evenodd");
  svg.attribute("d", svg_path(as_drawn(shape.artwork, clip.curves), symbol_from_shape(shape, symbol))).end();
  svg.end();
}

std::string turn_id(int turn_deg) { return "turn_" + std::to_string(turn_deg); }
std::string patch_id(std::size_t piece) { return "tone_" + std::to_string(piece); }

bool has_patch(const CollageReport& report, std::size_t piece) {
  return !report.tones.empty() && !report.tones[piece].patch.empty();
}

bool has_patches(const CollageReport& report) {
  return std::any_of(report.tones.begin(), report.tones.end(), [](const Tone& tone) { return !tone.patch.empty(); });
}

/// Writes one filter for all pieces with the same turn: the matrix of hue_turns.h.
void write_turn_filters(const CollageReport& report, XmlWriter& svg) {
  std::set<int> turns;
  for (const Tone& tone : report.tones) turns.insert(tone.turn_deg);
  turns.erase(0);
  for (const int turn_deg : turns) {
    svg.raw("\n").start("filter").attribute("id", turn_id(turn_deg)).attribute("color-interpolation-filters", "sRGB");
    svg.start("feColorMatrix").attribute("type", "hueRotate").attribute("values", std::to_string(turn_deg)).end();
    svg.end();
  }
}

/// Writes the patch over a piece, in the units of its symbol.
void write_patch(const CollageReport& report, const std::vector<SvgSymbol>& symbols, std::size_t piece,
                 XmlWriter& svg) {
  const Placement& placement = report.placements[piece];
  const Drawing drawing = drawing_of(report, symbols, placement);
  const TonePatch& patch = report.tones[piece].patch;
  const cv::Matx23d symbol_from_patch =
      joined(inverse(canvas_from_symbol(placement, report.shape(placement.shape).artwork, drawing.artwork_px_per_unit)),
             canvas_from_patch_picture(patch));
  svg.raw("\n").start("image").attribute("id", patch_id(piece));
  const cv::Mat picture = patch_picture(patch);
  svg.attribute("width", std::to_string(picture.cols)).attribute("height", std::to_string(picture.rows));
  svg.attribute("transform", matrix_text(symbol_from_patch)).attribute("xlink:href", png_uri(picture)).end();
}

void write_patches(const CollageReport& report, const std::vector<SvgSymbol>& symbols, XmlWriter& svg) {
  for (std::size_t piece = 0; piece < report.tones.size(); ++piece) {
    if (has_patch(report, piece)) write_patch(report, symbols, piece, svg);
  }
}

/// Writes the shadow's filter for the canvas and as much around it as darkens the canvas.
void write_shadow_filter(const CollageReport& report, XmlWriter& svg) {
  const OutputSpec& output = report.output;
  const double around_px = 3 * output.shadow_blur_px;
  svg.raw("\n").start("filter").attribute("id", "shadow").attribute("filterUnits", "userSpaceOnUse");
  svg.attribute("x", fixed(-around_px, 3)).attribute("y", fixed(-around_px, 3));
  svg.attribute("width", fixed(report.canvas->width_px + 2 * around_px, 3));
  svg.attribute("height", fixed(report.canvas->height_px + 2 * around_px, 3));
  svg.start("feGaussianBlur").attribute("stdDeviation", fixed(output.shadow_blur_px, 3)).end();
  svg.end();
}

/// Writes the shape's outline in the same units, without a colour of its own.
void write_outline(const Shape& shape, const SvgSymbol& symbol, std::size_t slot, XmlWriter& svg) {
  svg.raw("\n").start("path").attribute("id", outline_id(slot));
  svg.attribute("d", svg_path(as_drawn(shape.artwork, shape.outline.curves), symbol_from_shape(shape, symbol))).end();
}

void write_definitions(const CollageReport& report, const ShapeArtworks& artworks,
                       const std::vector<SvgSymbol>& symbols, XmlWriter& svg) {
  const OutputSpec& output = report.output;
  const bool patches = has_patches(report);
  svg.raw("\n").start("defs");
  for (std::size_t slot = 0; slot < symbols.size(); ++slot) {
    if (report.shapes.slot_of_drawing(slot) == slot) svg.raw("\n").raw(symbols[slot].xml);
  }
  for (std::size_t slot = 0; slot < symbols.size(); ++slot) {
    if (report.shapes.slot_of_drawing(slot) != slot) continue;
    const Shape& shape = report.shapes[slot];
    if (output.clip != kNoClip) write_clip(clip_id(slot), shape, symbols[slot], artworks.clip(slot), svg);
    // A patch must be clipped, because it does not know what is transparent beside the outline.
    if (patches) write_clip(patch_clip_id(slot), shape, symbols[slot], shape.outline, svg);
    if (has_outlines(output)) write_outline(shape, symbols[slot], slot, svg);
  }
  if (has_shadow(output)) write_shadow_filter(report, svg);
  write_turn_filters(report, svg);
  write_patches(report, symbols, svg);
  write_keep_out_clip(report.keep_out, svg);
  write_pattern(report.ground, kGroundId, flat_background(output), svg);
  write_pattern(report.overlay, kOverlayId, kNoColour, svg);
  svg.end().raw("\n");
}

/// Writes all shadows together, so that two shadows that meet are no darker.
void write_shadow(const CollageReport& report, const std::vector<DrawnPiece>& drawn,
                  const std::vector<SvgSymbol>& symbols, XmlWriter& svg) {
  const OutputSpec& output = report.output;
  if (!has_shadow(output)) return;
  start_layer(kShadowLayer, svg);
  svg.start("g").attribute("filter", "url(#shadow)").attribute("opacity", fixed(output.shadow_strength, 3));
  svg.start("g").attribute("fill-rule", "evenodd");
  svg.attribute("transform",
                "translate(" + fixed(output.shadow_offset_px[0], 3) + " " + fixed(output.shadow_offset_px[1], 3) + ")");
  for (const auto& [placement, piece] : drawn) {
    const Drawing drawing = drawing_of(report, symbols, placement);
    svg.raw("\n").start("use").attribute("xlink:href", "#" + outline_id(drawing.slot));
    svg.attribute("transform", matrix_text(canvas_from_symbol(placement, report.shape(placement.shape).artwork,
                                                              drawing.artwork_px_per_unit)));
    svg.end();
  }
  svg.end().end().end();
}

/// Writes the line along the piece's outline, in the units of its symbol.
void write_line(const CollageReport& report, const Placement& placement, const Drawing& drawing, XmlWriter& svg) {
  const OutputSpec& output = report.output;
  const Artwork& artwork = report.shapes[drawing.slot].artwork;
  const double canvas_px =
      // of one unit
      double(placement.canvas_from_shape.scale()) / double(artwork.unit_px) * drawing.artwork_px_per_unit;
  svg.start("use").attribute("xlink:href", "#" + outline_id(drawing.slot)).attribute("fill", "none");
  svg.attribute("stroke", output.outline_colour).attribute("stroke-width", fixed(output.outline_px / canvas_px, 4));
  svg.attribute("stroke-linejoin", "round").end();
}

/// Writes a piece as a group, so that all its parts move together. `again`: another image of a piece that is there already.
void write_piece(const CollageReport& report, const std::vector<SvgSymbol>& symbols, const DrawnPiece& drawn,
                 bool again, XmlWriter& svg) {
  const Placement& placement = drawn.placement;
  const Shape& shape = report.shape(placement.shape);
  const Drawing drawing = drawing_of(report, symbols, placement);
  const std::string title = printable_utf8(shape.name);
  svg.raw("\n").start("g");
  if (!again) svg.attribute("id", svg_piece_id(drawn.piece, shape.name));
  svg.attribute("inkscape:label", title);
  svg.attribute("transform", matrix_text(canvas_from_symbol(placement, shape.artwork, drawing.artwork_px_per_unit)));
  svg.start("title").text(title).end();
  svg.start("use").attribute("xlink:href", "#" + symbol_id(drawing.slot));
  const OutputSpec& output = report.output;
  const auto turn_hues = [&] {
    const int turn_deg = report.tones.empty() ? 0 : report.tones[drawn.piece].turn_deg;
    if (turn_deg != 0) svg.attribute("filter", "url(#" + turn_id(turn_deg) + ")");
  };
  if (output.clip != kNoClip) svg.attribute("clip-path", "url(#" + clip_id(drawing.slot) + ")");
  if (!report.colours.empty()) svg.attribute("fill", report.colours[drawn.piece]);
  turn_hues();
  svg.end();
  if (has_patch(report, drawn.piece)) {
    svg.start("use").attribute("xlink:href", "#" + patch_id(drawn.piece));
    svg.attribute("clip-path", "url(#" + patch_clip_id(drawing.slot) + ")");
    turn_hues();
    svg.end();
  }
  if (output.outline_px > 0) write_line(report, placement, drawing, svg);
  svg.end();
}

/// Writes pieces layer by layer, in the order of their first pieces; within a layer in order of placement.
void write_pieces(const CollageReport& report, const std::vector<DrawnPiece>& drawn,
                  const std::vector<SvgSymbol>& symbols, XmlWriter& svg) {
  const auto by_piece = [](const DrawnPiece& a, std::size_t piece) { return a.piece < piece; };
  for (const SvgLayer& layer : piece_layers(report)) {
    svg.raw("\n");
    start_layer(layer, svg);
    for (const std::size_t piece : layer.pieces) {
      const auto first = std::lower_bound(drawn.begin(), drawn.end(), piece, by_piece);
      for (auto image = first; image != drawn.end() && image->piece == piece; ++image) {
        write_piece(report, symbols, *image, image != first, svg);
      }
    }
    svg.end();
  }
}

/// The number without zeros at the end.
std::string px_text(double px) {
  std::string text = fixed(px, 3);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

void write_view_box(const cv::Size2d& page_px, XmlWriter& svg) {
  svg.attribute("viewBox", "0 0 " + px_text(page_px.width) + " " + px_text(page_px.height));
}

void write_size_on_paper(const CollageReport& report, XmlWriter& svg) {
  const cv::Size2d page_px = page_size_px(report.box, *report.canvas);
  const cv::Size2d page_mm = page_size_mm(report.output, report.box, *report.canvas);
  svg.attribute("width", fixed(page_mm.width, 3) + "mm").attribute("height", fixed(page_mm.height, 3) + "mm");
  write_view_box(page_px, svg);
  // Copies of a canvas that repeats must meet: its px fill the page, although the page has its aspect only to a px.
  constexpr double kSeen = 1e-6;
  const double stretched = page_mm.height * page_px.width / (page_mm.width * page_px.height);
  if (std::abs(stretched - 1) > kSeen) svg.attribute("preserveAspectRatio", "none");
}

void write_size(const CollageReport& report, XmlWriter& svg) {
  const OutputSpec& output = report.output;
  if (output.width_mm > 0) return write_size_on_paper(report, svg);
  const cv::Size size = picture_size_px(output, *report.canvas);
  svg.attribute("width", std::to_string(size.width)).attribute("height", std::to_string(size.height));
  write_view_box(cv::Size2d(report.canvas->width_px, report.canvas->height_px), svg);
}

}  // namespace

std::string collage_svg(const CollageReport& report, ShapeArtworks& artworks, const DoneCount& done) {
  const std::vector<SvgSymbol> symbols = make_symbols(report, artworks, done);
  XmlWriter svg;
  svg.raw("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n").start("svg").attribute("xmlns", "http://www.w3.org/2000/svg");
  svg.attribute("xmlns:xlink", "http://www.w3.org/1999/xlink").attribute("version", "1.1");
  svg.attribute("xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape");
  write_size(report, svg);
  write_definitions(report, artworks, symbols, svg);
  write_canvas(report, svg);
  write_keep_out(report.keep_out, svg);
  const std::vector<DrawnPiece> drawn = drawn_pieces(report, artworks);
  write_shadow(report, drawn, symbols, svg);
  write_pieces(report, drawn, symbols, svg);
  write_overlay(report, svg);
  return svg.raw("\n").finish();
}

}  // namespace tessera
