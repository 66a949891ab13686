#include "library/sheet_cell.h"

#include <algorithm>
#include <filesystem>
#include <opencv2/core.hpp>
#include <span>

#include "artwork/images/alpha.h"
#include "core/base/count_text.h"
#include "core/base/error.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr int kMaxThumbnailSide_px = 1024;

/// Checks the size that the PNG states at a fixed place.
bool has_sane_size(std::span<const std::uint8_t> png) {
  if (png.size() < 24) return false;
  const auto side = [&](std::size_t at) {
    return std::uint32_t(png[at]) << 24 | std::uint32_t(png[at + 1]) << 16 | std::uint32_t(png[at + 2]) << 8 |
           png[at + 3];
  };
  return std::min(side(16), side(20)) >= 1 && std::max(side(16), side(20)) <= kMaxThumbnailSide_px;
}

/// The thumbnail in premultiplied BGRA, which is cairo's ARGB32. Empty where it is damaged: the cell then shows only the
/// outline.
cv::Mat decoded(Drawers& drawers, std::span<const std::uint8_t> png) {
  if (!has_sane_size(png)) return {};
  try {
    return premultiplied(drawers.decode_png(png, "thumbnail", kMaxThumbnailSide_px));
  } catch (const InputError&) {
    return {};
  }
}

void trace(cairo_t* cairo, const Outline& outline) {
  cairo_new_path(cairo);
  for (const std::vector<Vec2>& curve : outline.curves) {
    cairo_new_sub_path(cairo);
    for (const Vec2 p : curve) cairo_line_to(cairo, p.x, p.y);
    cairo_close_path(cairo);
  }
}

struct CellBox {
  Vec2 least;
  Vec2 most;

  explicit CellBox(const std::vector<Vec2>& points) : least(points.front()), most(points.front()) {
    for (const Vec2 p : points) {
      least = {std::min(least.x, p.x), std::min(least.y, p.y)};
      most = {std::max(most.x, p.x), std::max(most.y, p.y)};
    }
  }
  Vec2 centre() const { return (least + most) * 0.5f; }
  double side() const { return std::max(most.x - least.x, most.y - least.y); }
};

/// Draws the thumbnail, placed by the artwork frame and cut to the cell, because pages often hold more than the shape.
void draw_thumbnail(cairo_t* cairo, const Artwork& artwork, cv::Mat bgra) {
  if (bgra.empty()) return;
  const CairoSurface image(
      cairo_image_surface_create_for_data(bgra.data, CAIRO_FORMAT_ARGB32, bgra.cols, bgra.rows, int(bgra.step)));
  const double enlarged = double(std::max(artwork.width_px, artwork.height_px)) / std::max(bgra.cols, bgra.rows);
  cairo_save(cairo);
  cairo_scale(cairo, enlarged, enlarged);
  cairo_set_source_surface(cairo, image.get(), 0, 0);
  cairo_paint(cairo);
  cairo_restore(cairo);  // lets go of the surface
}

}  // namespace

void draw_on_sheet(cairo_t* cairo, Drawers& drawers, const Shape& shape, const SheetCell& cell) {
  const Artwork& artwork = shape.artwork;
  const cv::Mat thumbnail = decoded(drawers, artwork.thumbnail_png);
  const CellBox box(shape.outline.curves.front());
  const double cell_px_per_unit = cell.side_px / std::max(box.side(), 1e-3);
  cairo_save(cairo);
  cairo_rectangle(cairo, cell.x_px - 1, cell.y_px - 1, cell.side_px + 2, cell.side_px + 2);
  cairo_clip(cairo);
  cairo_translate(cairo, cell.x_px + 0.5 * cell.side_px, cell.y_px + 0.5 * cell.side_px);
  cairo_scale(cairo, cell_px_per_unit, cell_px_per_unit);
  cairo_translate(cairo, -box.centre().x, -box.centre().y);  // now in the shape frame
  cairo_save(cairo);
  cairo_scale(cairo, 1 / artwork.unit_px, 1 / artwork.unit_px);
  cairo_translate(cairo, -artwork.centroid_px.x, -artwork.centroid_px.y);
  draw_thumbnail(cairo, artwork, thumbnail);
  cairo_restore(cairo);
  if (cell.outlined || thumbnail.empty()) {
    trace(cairo, shape.outline);
    cairo_set_source_rgba(cairo, 0.85, 0.15, 0.1, 0.8);
    cairo_set_line_width(cairo, 0.8 / cell_px_per_unit);
    cairo_stroke(cairo);
  }
  cairo_restore(cairo);
}

std::string sheet_title(const LibraryFile& library, std::size_t shown) {
  std::string title = printable_utf8(std::filesystem::path(library.path()).filename()) + "  ·  ";
  title += count_text(library.size(), "shape");
  if (shown < library.size()) title += ", " + std::to_string(shown) + " shown";
  return title;
}

Shape shape_for_sheet(const LibraryFile& library, std::size_t index) {
  const LibraryParts parts{.outline = true, .field = false, .levels = 0, .artwork = true, .original = false};
  return std::move(library.read(index, index + 1, parts).front());
}

}  // namespace tessera
