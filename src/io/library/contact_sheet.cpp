#include "io/library/contact_sheet.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>
#include <span>

#include "core/error.h"
#include "io/atomic_file.h"
#include "io/library/library_names.h"

namespace tessera::io {
namespace {

constexpr int kCell_px = 140;  // of the drawing; the name stands below it
constexpr int kName_px = 18;
constexpr int kGap_px = 14;
constexpr int kMargin_px = 28;
constexpr int kTitle_px = 44;
constexpr int kMaxColumns = 20;
constexpr double kFontSize_px = 11;
constexpr int kMaxThumbnailSide_px = 1024;

struct DestroyCairo {
  void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
  void operator()(cairo_t* c) const { cairo_destroy(c); }
};
using Surface = std::unique_ptr<cairo_surface_t, DestroyCairo>;
using Context = std::unique_ptr<cairo_t, DestroyCairo>;

struct SheetLayout {
  int columns;
  int rows;

  static SheetLayout of(std::size_t shapes) {
    const int columns = std::clamp(int(std::ceil(std::sqrt(1.2 * double(shapes)))), 1, kMaxColumns);
    return {columns, int((shapes + columns - 1) / columns)};
  }
  int width_px() const { return std::max(480, 2 * kMargin_px + columns * (kCell_px + kGap_px) - kGap_px); }
  int height_px() const { return 2 * kMargin_px + kTitle_px + rows * (kCell_px + kName_px + kGap_px) - kGap_px; }
  int x_px(std::size_t k) const { return kMargin_px + int(k % columns) * (kCell_px + kGap_px); }
  int y_px(std::size_t k) const { return kMargin_px + kTitle_px + int(k / columns) * (kCell_px + kName_px + kGap_px); }
};

/// A PNG says its size at a fixed place; cairo would allocate for any.
bool has_sane_size(std::span<const std::uint8_t> png) {
  if (png.size() < 24) return false;
  const auto side = [&](std::size_t at) {
    return std::uint32_t(png[at]) << 24 | std::uint32_t(png[at + 1]) << 16 | std::uint32_t(png[at + 2]) << 8 |
           png[at + 3];
  };
  return std::min(side(16), side(20)) >= 1 && std::max(side(16), side(20)) <= kMaxThumbnailSide_px;
}

cairo_status_t read_bytes(void* closure, unsigned char* to, unsigned count) {
  auto& from = *static_cast<std::span<const std::uint8_t>*>(closure);
  if (count > from.size()) return CAIRO_STATUS_READ_ERROR;
  std::memcpy(to, from.data(), count);
  from = from.subspan(count);
  return CAIRO_STATUS_SUCCESS;
}

cairo_status_t append_bytes(void* closure, const unsigned char* from, unsigned count) {
  auto& to = *static_cast<std::vector<std::uint8_t>*>(closure);
  to.insert(to.end(), from, from + count);
  return CAIRO_STATUS_SUCCESS;
}

/// Null where the thumbnail is damaged: the cell then shows the outline only.
Surface decoded(std::span<const std::uint8_t> png) {
  if (!has_sane_size(png)) return nullptr;
  Surface image(cairo_image_surface_create_from_png_stream(read_bytes, &png));
  return cairo_surface_status(image.get()) == CAIRO_STATUS_SUCCESS ? std::move(image) : nullptr;
}

void trace(cairo_t* cairo, const Outline& outline) {
  cairo_new_path(cairo);
  for (const std::vector<Vec2>& curve : outline.curves) {
    cairo_new_sub_path(cairo);
    for (const Vec2 p : curve) cairo_line_to(cairo, p.x, p.y);
    cairo_close_path(cairo);
  }
}

struct Box {
  Vec2 least;
  Vec2 most;

  explicit Box(const std::vector<Vec2>& points) : least(points.front()), most(points.front()) {
    for (const Vec2 p : points) {
      least = {std::min(least.x, p.x), std::min(least.y, p.y)};
      most = {std::max(most.x, p.x), std::max(most.y, p.y)};
    }
  }
  Vec2 centre() const { return (least + most) * 0.5f; }
  double side() const { return std::max(most.x - least.x, most.y - least.y); }
};

/// In the artwork frame, cut to the cell around it: pages often hold more than the shape.
void draw_thumbnail(cairo_t* cairo, const Artwork& artwork) {
  const Surface image = decoded(artwork.thumbnail_png);
  if (!image) return;
  const int side_px = std::max(cairo_image_surface_get_width(image.get()), cairo_image_surface_get_height(image.get()));
  const double enlarged = double(std::max(artwork.width_px, artwork.height_px)) / side_px;
  cairo_save(cairo);
  cairo_scale(cairo, enlarged, enlarged);
  cairo_set_source_surface(cairo, image.get(), 0, 0);
  cairo_paint(cairo);
  cairo_restore(cairo);
}

/// The thumbnail, and over it the outline as the library has it: where they disagree, the tracing went wrong.
void draw_shape(cairo_t* cairo, const Shape& shape, int x_px, int y_px) {
  const Artwork& artwork = shape.artwork;
  const Box box(shape.outline.curves.front());
  const double cell_px_per_unit = kCell_px / std::max(box.side(), 1e-3);
  cairo_save(cairo);
  cairo_rectangle(cairo, x_px - 1, y_px - 1, kCell_px + 2, kCell_px + 2);
  cairo_clip(cairo);
  cairo_translate(cairo, x_px + 0.5 * kCell_px, y_px + 0.5 * kCell_px);
  cairo_scale(cairo, cell_px_per_unit, cell_px_per_unit);
  cairo_translate(cairo, -box.centre().x, -box.centre().y);  // now in the shape frame
  cairo_save(cairo);
  cairo_scale(cairo, 1 / artwork.unit_px, 1 / artwork.unit_px);
  cairo_translate(cairo, -artwork.centroid_px.x, -artwork.centroid_px.y);
  draw_thumbnail(cairo, artwork);
  cairo_restore(cairo);
  trace(cairo, shape.outline);
  cairo_set_source_rgba(cairo, 0.85, 0.15, 0.1, 0.8);
  cairo_set_line_width(cairo, 0.8 / cell_px_per_unit);
  cairo_stroke(cairo);
  cairo_restore(cairo);
}

double text_width(cairo_t* cairo, const std::string& text) {
  cairo_text_extents_t extents{};
  cairo_text_extents(cairo, text.c_str(), &extents);
  return extents.x_advance;
}

/// The longest beginning of a UTF-8 text that fits, with an ellipsis where something is missing.
std::string fitted(cairo_t* cairo, std::string text, double width_px) {
  if (text_width(cairo, text) <= width_px) return text;
  while (!text.empty() && text_width(cairo, text + "…") > width_px) {
    while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80) text.pop_back();
    text.pop_back();
  }
  return text + "…";
}

void draw_name(cairo_t* cairo, const std::string& name, int x_px, int y_px) {
  cairo_set_font_size(cairo, kFontSize_px);
  cairo_set_source_rgb(cairo, 0.35, 0.33, 0.31);
  const std::string text = fitted(cairo, printable_utf8(name), kCell_px);
  cairo_move_to(cairo, x_px + 0.5 * (kCell_px - text_width(cairo, text)), y_px + kCell_px + kName_px - 4);
  cairo_show_text(cairo, text.c_str());
}

void draw_background(cairo_t* cairo, const LibraryFile& library, std::size_t shown) {
  cairo_set_source_rgb(cairo, 0.985, 0.98, 0.97);
  cairo_paint(cairo);
  std::string title = printable_utf8(std::filesystem::path(library.path()).filename()) + "  ·  ";
  title += std::to_string(library.size()) + " shapes";
  if (shown < library.size()) title += ", " + std::to_string(shown) + " shown";
  cairo_select_font_face(cairo, "sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_BOLD);
  cairo_set_font_size(cairo, 20);
  cairo_set_source_rgb(cairo, 0.2, 0.18, 0.16);
  cairo_move_to(cairo, kMargin_px, kMargin_px + 18);
  cairo_show_text(cairo, title.c_str());
  cairo_select_font_face(cairo, "sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
}

Shape read_one(const LibraryFile& library, std::size_t index) {
  const LibraryParts parts{.outline = true, .field = false, .levels = 0, .artwork = true, .original = false};
  return std::move(library.read(index, index + 1, parts).front());
}

std::vector<std::uint8_t> encoded(cairo_surface_t* surface, const std::string& path) {
  std::vector<std::uint8_t> png;
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface, append_bytes, &png);
  if (status != CAIRO_STATUS_SUCCESS)
    throw EnvironmentError("cannot draw " + path + ": " + cairo_status_to_string(status));
  return png;
}

}  // namespace

std::size_t write_contact_sheet(const LibraryFile& library, const std::string& path) {
  const std::size_t shown = std::min(library.size(), kMaxSheetShapes);
  const SheetLayout layout = SheetLayout::of(shown);
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, layout.width_px(), layout.height_px()));
  const Context cairo(cairo_create(surface.get()));
  draw_background(cairo.get(), library, shown);
  for (std::size_t k = 0; k < shown; ++k) {
    const Shape shape = read_one(library, k * library.size() / shown);
    draw_shape(cairo.get(), shape, layout.x_px(k), layout.y_px(k));
    draw_name(cairo.get(), shape.name, layout.x_px(k), layout.y_px(k));
  }
  write_file_atomically(path, encoded(surface.get(), path));
  return shown;
}

}  // namespace tessera::io
