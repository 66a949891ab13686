#include "io/result/shape_artworks.h"

#include <algorithm>

#include "core/base/error.h"
#include "io/artwork/colour_conversion.h"
#include "io/artwork/silhouette.h"
#include "io/artwork/svg_page.h"
#include "io/number_text.h"
#include "io/result/artwork_clip.h"
#include "io/result/artwork_original.h"
#include "io/result/svg_image.h"
#include "io/result/svg_path.h"
#include "io/xml_writer.h"

namespace tessera::io {
namespace {

int longest_side(const Artwork& artwork) { return std::max(artwork.width_px, artwork.height_px); }

SvgSymbol bitmap_symbol(const cv::Mat& bgra, const std::string& id, const Artwork& artwork) {
  return {svg_image(bgra, id), double(longest_side(artwork)) / std::max(bgra.cols, bgra.rows)};
}

/// Without the file's place, which is nobody's business who sees the card.
std::string reason_of(const InputError& error, const std::string& path) {
  const std::string text = error.what();
  return text.starts_with(path) ? text.substr(std::min(text.size(), path.size() + 2)) : text;
}

/// Takes the colour of what uses it.
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

}  // namespace

ShapeArtworks::ShapeArtworks(const CollageReport& report, Drawers& drawers, const StopWatcher& stop)
    : report_(report),
      drawers_(drawers),
      stop_(stop) {
  const bool whole = report.job->output.clip == kNoClip;
  for (const Shape& shape : report.shapes) {
    stop.check();
    clips_.push_back(whole ? artwork_page_outline(shape) : artwork_clip(shape));
  }
}

Sprite ShapeArtworks::sprite(std::size_t slot, int side_px) {
  stop_.check();
  const Shape& shape = report_.shapes[slot];
  if (!report_.colours.empty()) return sprite_of_silhouette(shape, side_px);
  const cv::Mat bgra = drawn(slot, source_of(slot), side_px);
  return bgra.empty() ? sprite_of_silhouette(shape, side_px) : sprite_of_drawing(bgra, shape, clips_[slot]);
}

SvgSymbol ShapeArtworks::symbol(std::size_t slot, const std::string& id) {
  stop_.check();
  const Shape& shape = report_.shapes[slot];
  const Artwork& artwork = shape.artwork;
  if (!report_.colours.empty()) return plain_symbol(shape, id);
  const Source source = source_of(slot);
  try {
    if (source.bytes.empty()) return silhouette_symbol(shape, id);
    if (source.thumbnail) {
      const cv::Mat bgra = drawn(slot, source, kThumbnailSide_px);
      return bgra.empty() ? silhouette_symbol(shape, id) : bitmap_symbol(bgra, id, artwork);
    }
    const cv::Size2d size = drawers_.natural_size(source.bytes, artwork.path);
    const double side = std::max(size.width, size.height);
    if (looks_like_svg(source.bytes)) {
      return {drawers_.import_svg(source.bytes, artwork.path, id), longest_side(artwork) / side};
    }
    const int side_px = int(std::clamp(side, 1., double(kMaxBitmapSide_px)));
    return bitmap_symbol(drawers_.render(source.bytes, artwork.path, side_px), id, artwork);
  } catch (const InputError& error) {
    note(slot, DrawnFrom::silhouette, reason_of(error, artwork.path));
    return silhouette_symbol(shape, id);
  }
}

DrawingNotes ShapeArtworks::notes() const {
  std::map<std::size_t, std::size_t> uses;  // of drawings, by slot
  for (const Placement& placement : report_.placements)
    ++uses[report_.shapes.slot_of_drawing(report_.shapes.slot_of(placement.shape))];
  DrawingNotes result;
  result.pieces = report_.placements.size();
  const std::lock_guard lock(mutex_);
  for (const auto& [slot, note] : notes_) {
    result.notes.push_back({report_.shapes[slot].name, note.first, note.second, uses[slot]});
  }
  return result;
}

ShapeArtworks::Source ShapeArtworks::source_of(std::size_t slot) {
  const Artwork& artwork = report_.shapes[slot].artwork;
  ArtworkOriginal original = artwork_original(artwork);
  if (!original.bytes.empty()) return {std::move(original.bytes), false};
  if (artwork.thumbnail_png.empty()) {
    note(slot, DrawnFrom::silhouette, original.reason + ", and no thumbnail");
    return {};
  }
  note(slot, DrawnFrom::thumbnail, original.reason);
  return {artwork.thumbnail_png, true};
}

/// Empty where it cannot be drawn.
cv::Mat ShapeArtworks::drawn(std::size_t slot, const Source& source, int side_px) {
  if (source.bytes.empty()) return {};
  {
    const std::lock_guard lock(mutex_);
    if (bad_.contains({slot, side_px})) return {};
  }
  const std::string& path = report_.shapes[slot].artwork.path;
  try {
    return source.thumbnail ? drawers_.decode_png(source.bytes, path + " (thumbnail)", kThumbnailSide_px)
                            : drawers_.render(source.bytes, path, side_px);
  } catch (const InputError& error) {
    note(slot, DrawnFrom::silhouette, reason_of(error, path));
    const std::lock_guard lock(mutex_);
    bad_.insert({slot, side_px});
    return {};
  }
}

/// A silhouette is worse than a thumbnail; of equals the first counts.
void ShapeArtworks::note(std::size_t slot, DrawnFrom from, const std::string& reason) {
  const std::lock_guard lock(mutex_);
  const auto [found, is_new] = notes_.try_emplace(slot, from, reason);
  if (!is_new && found->second.first < from) found->second = {from, reason};
}

}  // namespace tessera::io
