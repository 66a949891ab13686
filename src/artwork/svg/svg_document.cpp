#include "artwork/svg/svg_document.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "artwork/css/css_variables.h"
#include "artwork/svg/fonts.h"
#include "core/base/error.h"
#include "files/write_all.h"

namespace tessera {
namespace {

/// Frees the error and throws it as one line.
[[noreturn]] void throw_input_error(const std::string& path, const std::string& what, GError* error) {
  std::string message = path + ": " + what;
  if (error) message += std::string(": ") + error->message;
  g_clear_error(&error);
  std::replace(message.begin(), message.end(), '\n', ' ');
  throw InputError(message);
}

/// The size of the page as the file states it.
struct Dimensions {
  gboolean has_width = FALSE, has_height = FALSE, has_view_box = FALSE;
  RsvgLength width{}, height{};
  RsvgRectangle view_box{};
};

Dimensions dimensions_of(RsvgHandle* handle) {
  Dimensions page;
  rsvg_handle_get_intrinsic_dimensions(handle, &page.has_width, &page.width, &page.has_height, &page.height,
                                       &page.has_view_box, &page.view_box);
  return page;
}

bool is_length(const RsvgLength& length) {
  return length.unit == RSVG_UNIT_CM || length.unit == RSVG_UNIT_MM || length.unit == RSVG_UNIT_IN ||
         length.unit == RSVG_UNIT_PT || length.unit == RSVG_UNIT_PC;
}

/// The length in px; nullopt for percentages and for lengths in units of the font.
std::optional<double> in_px(bool given, const RsvgLength& length, double px_per_inch) {
  if (!given) return std::nullopt;
  switch (length.unit) {
    case RSVG_UNIT_PX: return length.length;
    case RSVG_UNIT_IN: return length.length * px_per_inch;
    case RSVG_UNIT_CM: return length.length * px_per_inch / 2.54;
    case RSVG_UNIT_MM: return length.length * px_per_inch / 25.4;
    case RSVG_UNIT_PT: return length.length * px_per_inch / 72;
    case RSVG_UNIT_PC: return length.length * px_per_inch / 6;
    default: return std::nullopt;
  }
}

/// The size from width and height; from one of them and the viewBox's aspect ratio, as a browser does; else from the
/// viewBox.
std::optional<cv::Size2d> size_of_page(RsvgHandle* handle, double px_per_inch) {
  double width = 0, height = 0;
  if (rsvg_handle_get_intrinsic_size_in_pixels(handle, &width, &height)) return cv::Size2d(width, height);
  const Dimensions page = dimensions_of(handle);
  if (!page.has_view_box) return std::nullopt;
  const cv::Size2d view_box(page.view_box.width, page.view_box.height);
  const auto width_px = in_px(page.has_width, page.width, px_per_inch);
  const auto height_px = in_px(page.has_height, page.height, px_per_inch);
  if (width_px) return view_box * (*width_px / view_box.width);
  if (height_px) return view_box * (*height_px / view_box.height);
  return view_box;
}

/// The size from the origin to the end of the drawing.
cv::Size2d reach_of_drawing(RsvgHandle* handle) {
  const RsvgRectangle viewport{0, 0, 1, 1};
  RsvgRectangle ink{};
  rsvg_handle_get_geometry_for_layer(handle, nullptr, &viewport, &ink, nullptr, nullptr);
  return {ink.x + ink.width, ink.y + ink.height};
}

}  // namespace

SvgDocument::SvgDocument(std::span<const std::uint8_t> svg, const std::string& path, RsvgHandleFlags flags,
                         double px_per_inch)
    : path_(path) {
  const std::optional<std::string> resolved = with_css_variables(svg, path);
  if (resolved) svg = bytes_of(*resolved);
  GError* error = nullptr;
  const GObjectPtr<GInputStream> stream(g_memory_input_stream_new_from_data(svg.data(), gssize(svg.size()), nullptr));
  handle_.reset(rsvg_handle_new_from_stream_sync(stream.get(), nullptr, flags, nullptr, &error));
  if (!handle_) throw_input_error(path, "not a readable SVG file", error);
  rsvg_handle_set_dpi(handle_.get(), px_per_inch);
  loses_text_ = tessera::loses_text(svg);
  if (!has_fonts()) set_style("text{display:none!important}");
  const std::optional<cv::Size2d> size = size_of_page(handle_.get(), px_per_inch);
  sized_ = size.has_value();
  size_ = size ? *size : reach_of_drawing(handle_.get());
  if (!size && !(size_.width > 0 && size_.height > 0)) size_ = {1, 1};  // nothing is drawn on the page
  const bool has_area =
      std::isfinite(size_.width) && std::isfinite(size_.height) && size_.width > 0 && size_.height > 0;
  if (!has_area) throw InputError(path + ": the page has no area");
}

bool SvgDocument::says_unit() const {
  const Dimensions page = dimensions_of(handle_.get());
  return (page.has_width && is_length(page.width)) || (page.has_height && is_length(page.height));
}

bool SvgDocument::depends_on_px() const { return !says_unit() || !dimensions_of(handle_.get()).has_view_box; }

void SvgDocument::set_style(const std::string& css) {
  rsvg_handle_set_stylesheet(handle_.get(), reinterpret_cast<const guint8*>(css.data()), css.size(), nullptr);
}

bool SvgDocument::draws_element(const std::string& id) const {
  const RsvgRectangle viewport{0, 0, size_.width, size_.height};
  RsvgRectangle ink{};
  return rsvg_handle_get_geometry_for_layer(handle_.get(), ("#" + id).c_str(), &viewport, &ink, nullptr, nullptr) &&
         ink.width > 0 && ink.height > 0;
}

void SvgDocument::draw(cairo_t* cairo, double scale) const {
  // librsvg fits a page that has a size into the viewport; without a size it draws in px.
  const double viewport_scale = sized_ ? scale : 1;
  const RsvgRectangle viewport{0, 0, size_.width * viewport_scale, size_.height * viewport_scale};
  cairo_scale(cairo, scale / viewport_scale, scale / viewport_scale);
  GError* error = nullptr;
  if (!rsvg_handle_render_document(handle_.get(), cairo, &viewport, &error)) {
    throw_input_error(path_, "cannot be drawn", error);
  }
}

void SvgDocument::draw_element(cairo_t* cairo, const std::string& id, const cv::Size2d& page) const {
  const RsvgRectangle viewport{0, 0, page.width, page.height};
  GError* error = nullptr;
  if (!rsvg_handle_render_layer(handle_.get(), cairo, ("#" + id).c_str(), &viewport, &error)) {
    throw_input_error(path_, id + " cannot be drawn", error);
  }
}

}  // namespace tessera
