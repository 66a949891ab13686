#include "library/sheet.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr int kGap_px = 14;
constexpr int kMargin_px = 28;
constexpr int kTitle_px = 44;
constexpr int kLeastWidth_px = 480;  // room for the title
constexpr int kCaptionLine_px = 15;
constexpr int kFirstCaptionLine_px = 14;  // baseline below the picture
constexpr double kFontSize_px = 11;
constexpr double kTitleSize_px = 20;

cairo_status_t append_bytes(void* closure, const unsigned char* from, unsigned count) {
  auto& to = *static_cast<std::vector<std::uint8_t>*>(closure);
  to.insert(to.end(), from, from + count);
  return CAIRO_STATUS_SUCCESS;
}

double text_width(cairo_t* cairo, const std::string& text) {
  cairo_text_extents_t extents{};
  cairo_text_extents(cairo, text.c_str(), &extents);
  return extents.x_advance;
}

/// The longest beginning of a UTF-8 text that fits, with an ellipsis where something was cut.
std::string fitted(cairo_t* cairo, std::string text, double width_px) {
  if (text_width(cairo, text) <= width_px) return text;
  while (!text.empty() && text_width(cairo, text + "…") > width_px) {
    text = cut_utf8(text, text.size() - 1);
  }
  return text + "…";
}

void draw_title(cairo_t* cairo, const std::string& title) {
  cairo_set_source_rgb(cairo, 0.985, 0.98, 0.97);
  cairo_paint(cairo);
  cairo_select_font_face(cairo, "sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_BOLD);
  cairo_set_font_size(cairo, kTitleSize_px);
  cairo_set_source_rgb(cairo, 0.2, 0.18, 0.16);
  cairo_move_to(cairo, kMargin_px, kMargin_px + 18);
  cairo_show_text(cairo, title.c_str());
  cairo_select_font_face(cairo, "sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
}

}  // namespace

int SheetLayout::width_px() const {
  return std::max(kLeastWidth_px, 2 * kMargin_px + columns * (cell_width_px + kGap_px) - kGap_px);
}

int SheetLayout::height_px() const {
  return 2 * kMargin_px + kTitle_px + rows * (cell_height_px + caption_px + kGap_px) - kGap_px;
}

int SheetLayout::x_px(std::size_t cell) const {
  return kMargin_px + int(cell % std::size_t(columns)) * (cell_width_px + kGap_px);
}

int SheetLayout::y_px(std::size_t cell) const {
  return kMargin_px + kTitle_px + int(cell / std::size_t(columns)) * (cell_height_px + caption_px + kGap_px);
}

SheetLayout make_sheet_layout(std::size_t pictures, int cell_width_px, int cell_height_px, int caption_px,
                              int max_columns) {
  const int columns = std::clamp(int(std::ceil(std::sqrt(1.2 * double(pictures)))), 1, max_columns);
  const int rows = int((pictures + std::size_t(columns) - 1) / std::size_t(columns));
  return {cell_width_px, cell_height_px, caption_px, columns, rows};
}

Sheet::Sheet(const SheetLayout& layout, const std::string& title)
    : layout_(layout),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, layout.width_px(), layout.height_px())),
      cairo_(cairo_create(surface_.get())) {
  draw_title(cairo(), title);
}

void Sheet::caption(std::size_t cell, int line, const std::string& text) const {
  cairo_set_font_size(cairo(), kFontSize_px);
  cairo_set_source_rgb(cairo(), 0.35, 0.33, 0.31);
  const std::string shown = fitted(cairo(), text, layout_.cell_width_px);
  cairo_move_to(cairo(), layout_.x_px(cell) + 0.5 * (layout_.cell_width_px - text_width(cairo(), shown)),
                layout_.y_px(cell) + layout_.cell_height_px + kFirstCaptionLine_px + line * kCaptionLine_px);
  cairo_show_text(cairo(), shown.c_str());
}

std::vector<std::uint8_t> Sheet::png(const std::string& path) const {
  std::vector<std::uint8_t> bytes;
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface_.get(), append_bytes, &bytes);
  if (status != CAIRO_STATUS_SUCCESS) {
    throw EnvironmentError("cannot draw " + path + ": " + cairo_status_to_string(status));
  }
  return bytes;
}

}  // namespace tessera
