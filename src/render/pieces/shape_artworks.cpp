#include "render/pieces/shape_artworks.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "artwork/artwork_render.h"
#include "artwork/images/alpha.h"
#include "artwork/images/colour_conversion.h"
#include "artwork/images/image_header.h"
#include "artwork/images/looks_like_svg.h"
#include "artwork/silhouette.h"
#include "core/base/error.h"
#include "job/picture_size.h"
#include "layers/embedded_drawing.h"
#include "layers/svg_image.h"
#include "render/pieces/artwork_clip.h"
#include "render/pieces/artwork_original.h"
#include "render/pieces/svg_path.h"
#include "render/pieces/warped_artwork.h"
#include "text/number_text.h"
#include "text/xml_writer.h"

namespace tessera {
namespace {

/// Longest side of a warped drawing in pixels in an SVG, which holds one for each piece.
constexpr int kMostWarped_px = 512;

int longest_side(const Artwork& artwork) { return std::max(artwork.width_px, artwork.height_px); }

SvgSymbol bitmap_symbol(const cv::Mat& bgra, const std::string& id, const Artwork& artwork) {
  return {svg_image(bgra, id), double(longest_side(artwork)) / std::max(bgra.cols, bgra.rows)};
}

/// The reason without the path of the file, which is private and must not be in the card.
std::string reason_of(const InputError& error, const std::string& path) {
  const std::string text = error.what();
  return text.starts_with(path) ? text.substr(std::min(text.size(), path.size() + 2)) : text;
}

/// The drawing as one group with this id, moved to the right and down.
std::string shifted_group(const std::string& drawing, const std::string& id, double by) {
  XmlWriter writer;
  writer.start("g").attribute("id", id).attribute("transform", "translate(" + fixed(by, 4) + " " + fixed(by, 4) + ")");
  writer.raw(drawing).end();
  return writer.finish();
}

/// A silhouette that takes the colour of the element that uses it.
SvgSymbol plain_symbol(const Shape& shape, const std::string& id) {
  XmlWriter writer;
  writer.start("path").attribute("id", id).attribute("fill-rule", "evenodd");
  writer.attribute("d", svg_path(as_drawn(shape.artwork, shape.outline.curves), artwork_from_shape(shape.artwork)));
  return {writer.finish(), 1};
}

SvgSymbol silhouette_symbol(const Shape& shape, const std::string& id) {
  XmlWriter writer;
  writer.start("path").attribute("id", id).attribute("fill", hex_of(mean_bgr(shape))).attribute("fill-rule", "evenodd");
  writer.attribute("d", svg_path(as_drawn(shape.artwork, shape.outline.curves), artwork_from_shape(shape.artwork)));
  return {writer.finish(), 1};
}

/// The longest side of an image in its own pixels; the largest number for a drawing that has none. An image is enlarged
/// only once, when the piece is drawn (draw_rows), as each enlargement blurs.
int own_side_px(std::span<const std::uint8_t> bytes) {
  const std::optional<cv::Size2d> size = image_size_from_header(bytes);
  return size ? int(std::clamp(std::max(size->width, size->height), 1., double(kMaxArtworkSide_px)))
              : std::numeric_limits<int>::max();
}

}  // namespace

ShapeArtworks::ShapeArtworks(const CollageReport& report, Drawers& drawers, const StopWatcher& stop)
    : report_(report),
      drawers_(drawers),
      stop_(stop) {
  for (std::size_t slot = 0; slot < report.shapes.size(); ++slot) {
    stop.check();
    clips_.push_back(clip_of(slot));
  }
}

std::size_t ShapeArtworks::original_slot(std::size_t slot) const {
  if (!report_.deformed) return slot;
  const PlacedShapes& originals = report_.deformed->originals;
  return originals.slot_of_drawing(originals.slot_of(report_.deformed->shapes[slot]));
}

const Shape& ShapeArtworks::original(std::size_t slot) const {
  if (!report_.deformed) return report_.shapes[slot];
  return report_.deformed->originals[report_.deformed->originals.slot_of(report_.deformed->shapes[slot])];
}

Outline ShapeArtworks::original_clip(std::size_t slot) const {
  const Shape& shape = original(slot);
  return report_.output.clip == kNoClip ? artwork_page_outline(shape) : artwork_clip(shape);
}

Outline ShapeArtworks::clip_of(std::size_t slot) const {
  Outline clip = original_clip(slot);
  return report_.deformed ? warped_outline(clip, report_.deformed->warps[slot]) : clip;
}

Sprite ShapeArtworks::sprite(std::size_t slot, int side_px) {
  stop_.check();
  const Shape& shape = report_.shapes[slot];
  if (!report_.colours.empty()) return sprite_of_silhouette(shape, side_px);
  const Shape& drawn_shape = original(slot);
  const double part = double(longest_side(drawn_shape.artwork)) / longest_side(shape.artwork);  // of a wider page
  const cv::Mat bgra = drawn(slot, source_of(slot), std::max(1, int(side_px * part)));
  if (bgra.empty()) return sprite_of_silhouette(shape, side_px);
  if (!report_.deformed) return sprite_of_drawing(bgra, shape, clips_[slot]);
  const Sprite undeformed = sprite_of_drawing(bgra, drawn_shape, original_clip(slot));
  return warped_sprite(undeformed, drawn_shape.artwork, report_.deformed->warps[slot],
                       report_.deformed->margin_px[slot]);
}

SvgSymbol ShapeArtworks::symbol(std::size_t slot, const std::string& id) {
  stop_.check();
  const Shape& shape = report_.shapes[slot];
  if (!report_.colours.empty()) return plain_symbol(shape, id);
  const Source source = source_of(slot);
  try {
    if (source.bytes.empty()) return silhouette_symbol(shape, id);
    return report_.deformed ? warped_symbol(slot, source, id) : drawing_symbol(slot, source, id);
  } catch (const InputError& error) {
    note(slot, DrawnFrom::silhouette, reason_of(error, original(slot).artwork.path));
    return silhouette_symbol(shape, id);
  }
}

SvgSymbol ShapeArtworks::drawing_symbol(std::size_t slot, const Source& source, const std::string& id) {
  const Shape& shape = report_.shapes[slot];
  const Artwork& artwork = shape.artwork;
  if (source.thumbnail) {
    const cv::Mat bgra = drawn(slot, source, kThumbnailSide_px);
    return bgra.empty() ? silhouette_symbol(shape, id) : bitmap_symbol(bgra, id, artwork);
  }
  EmbeddedDrawing drawing = embedded_drawing(source.bytes, artwork.path, id, drawers_);
  return {std::move(drawing.svg), longest_side(artwork) / std::max(drawing.size.width, drawing.size.height)};
}

bool ShapeArtworks::may_be_paths(std::size_t slot, const Source& source) const {
  const std::lock_guard lock(mutex_);
  return !source.thumbnail && looks_like_svg(source.bytes) && !not_as_paths_.contains(original_slot(slot));
}

/// The longest side of the page in px, twice as fine as the pictures show it, within bounds.
int ShapeArtworks::pixels_of_piece(std::size_t slot) const {
  const Artwork& artwork = report_.shapes[slot].artwork;
  const double picture_px = double(picture_size_px(report_.output, *report_.canvas).width) / report_.canvas->width_px;
  const double size_px = double(report_.placements[slot].canvas_from_shape.scale()) * picture_px;
  return int(std::clamp(2 * size_px * longest_side(artwork) / double(artwork.unit_px), 16., double(kMostWarped_px)));
}

/// The symbol of a deformed piece. Vectors stay vectors on their own page; pixels are warped onto the wider page.
SvgSymbol ShapeArtworks::warped_symbol(std::size_t slot, const Source& source, const std::string& id) {
  const Artwork& artwork = original(slot).artwork;
  if (may_be_paths(slot, source)) {
    try {
      const cv::Size2d size = drawers_.natural_size(source.bytes, artwork.path);
      const double px_per_unit = longest_side(artwork) / std::max(size.width, size.height);
      const Warp page_warp = warp_of_page(artwork, report_.deformed->warps[slot], 1 / px_per_unit);
      const std::string drawing = drawers_.warped_svg(source.bytes, artwork.path, id + "-drawing", page_warp);
      return {shifted_group(drawing, id, double(report_.deformed->margin_px[slot]) / px_per_unit), px_per_unit};
    } catch (const InputError&) {  // too much for paths: this and its other pieces use pixels
      const std::lock_guard lock(mutex_);
      not_as_paths_.insert(original_slot(slot));
    }
  }
  const Sprite pixels = sprite(slot, pixels_of_piece(slot));
  return {svg_image(straightened(pixels.bgra), id), 1 / pixels.px_per_artwork_px};
}

DrawingNotes ShapeArtworks::notes() const {
  std::map<std::size_t, std::size_t> uses;  // of drawings, by slot
  for (const Placement& placement : report_.placements) {
    const std::size_t slot = report_.shapes.slot_of(placement.shape);
    ++uses[report_.deformed ? original_slot(slot) : report_.shapes.slot_of_drawing(slot)];
  }
  const PlacedShapes& drawings = report_.deformed ? report_.deformed->originals : report_.shapes;
  DrawingNotes result;
  result.pieces = report_.placements.size();
  const std::lock_guard lock(mutex_);
  for (const auto& [slot, note] : notes_) {
    result.notes.push_back({drawings[slot].name, note.first, note.second, uses[slot]});
  }
  return result;
}

ShapeArtworks::Source ShapeArtworks::source_of(std::size_t slot) {
  const Artwork& artwork = original(slot).artwork;
  ArtworkOriginal file = artwork_original(artwork);
  if (!file.bytes.empty()) return {std::move(file.bytes), false};
  if (artwork.thumbnail_png.empty()) {
    note(slot, DrawnFrom::silhouette, file.reason + ", and no thumbnail");
    return {};
  }
  note(slot, DrawnFrom::thumbnail, file.reason);
  return {artwork.thumbnail_png, true};
}

/// Draws the source in pixels. Empty where it cannot be drawn.
cv::Mat ShapeArtworks::drawn(std::size_t slot, const Source& source, int side_px) {
  if (source.bytes.empty()) return {};
  {
    const std::lock_guard lock(mutex_);
    if (bad_.contains({original_slot(slot), side_px})) return {};
  }
  const std::string& path = original(slot).artwork.path;
  try {
    return source.thumbnail ? drawers_.decode_png(source.bytes, path + " (thumbnail)", kThumbnailSide_px)
                            : drawers_.render(source.bytes, path, std::min(side_px, own_side_px(source.bytes)));
  } catch (const InputError& error) {
    note(slot, DrawnFrom::silhouette, reason_of(error, path));
    const std::lock_guard lock(mutex_);
    bad_.insert({original_slot(slot), side_px});
    return {};
  }
}

/// Keeps the worse of two notes (a silhouette is worse than a thumbnail); of equal ones the first.
void ShapeArtworks::note(std::size_t slot, DrawnFrom from, const std::string& reason) {
  const std::lock_guard lock(mutex_);
  const auto [found, is_new] = notes_.try_emplace(original_slot(slot), from, reason);
  if (!is_new && found->second.first < from) found->second = {from, reason};
}

}  // namespace tessera
