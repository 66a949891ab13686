#include "artwork/svg/svg_document.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "artwork/svg/fonts.h"
#include "core/base/error.h"

namespace tessera {
namespace {

/// CSS's px; librsvg's own default is 90.
constexpr double kPixelsPerInch = 96;

/// Takes the error over and throws it as one line.
[[noreturn]] void throw_input_error(const std::string& path, const std::string& what, GError* error) {
  std::string message = path + ": " + what;
  if (error) message += std::string(": ") + error->message;
  g_clear_error(&error);
  std::replace(message.begin(), message.end(), '\n', ' ');
  throw InputError(message);
}

void hide_text(RsvgHandle* handle) {
  constexpr std::string_view kStyle = "text{display:none!important}";
  rsvg_handle_set_stylesheet(handle, reinterpret_cast<const guint8*>(kStyle.data()), kStyle.size(), nullptr);
}

/// From width and height, else from the viewBox.
std::optional<cv::Size2d> size_of_page(RsvgHandle* handle) {
  double width = 0, height = 0;
  if (rsvg_handle_get_intrinsic_size_in_pixels(handle, &width, &height)) return cv::Size2d(width, height);
  gboolean has_width, has_height, has_view_box;
  RsvgLength ignored_width, ignored_height;
  RsvgRectangle view_box;
  rsvg_handle_get_intrinsic_dimensions(handle, &has_width, &ignored_width, &has_height, &ignored_height, &has_view_box,
                                       &view_box);
  if (has_view_box) return cv::Size2d(view_box.width, view_box.height);
  return std::nullopt;
}

/// From the origin to where the drawing ends.
cv::Size2d reach_of_drawing(RsvgHandle* handle) {
  const RsvgRectangle viewport{0, 0, 1, 1};
  RsvgRectangle ink{};
  rsvg_handle_get_geometry_for_layer(handle, nullptr, &viewport, &ink, nullptr, nullptr);
  return {ink.x + ink.width, ink.y + ink.height};
}

}  // namespace

SvgDocument::SvgDocument(std::span<const std::uint8_t> svg, const std::string& path, RsvgHandleFlags flags)
    : path_(path) {
  GError* error = nullptr;
  const GObjectPtr<GInputStream> stream(g_memory_input_stream_new_from_data(svg.data(), gssize(svg.size()), nullptr));
  handle_.reset(rsvg_handle_new_from_stream_sync(stream.get(), nullptr, flags, nullptr, &error));
  if (!handle_) throw_input_error(path, "not a readable SVG file", error);
  rsvg_handle_set_dpi(handle_.get(), kPixelsPerInch);
  loses_text_ = tessera::loses_text(svg);
  if (!has_fonts()) hide_text(handle_.get());
  const std::optional<cv::Size2d> size = size_of_page(handle_.get());
  sized_ = size.has_value();
  size_ = size ? *size : reach_of_drawing(handle_.get());
  const bool has_area =
      std::isfinite(size_.width) && std::isfinite(size_.height) && size_.width > 0 && size_.height > 0;
  if (!has_area) throw InputError(path + ": the page has no area");
}

void SvgDocument::draw(cairo_t* cairo, double scale) const {
  // librsvg fits a page that has a size into the viewport; without one it draws in px.
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
