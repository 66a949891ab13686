#include "io/artwork/svg_page.h"

#include <cairo.h>
#include <librsvg/rsvg.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "io/artwork/gunzip.h"

namespace tessera::io {
namespace {

/// Layers of librsvg have the size of the whole page, whatever is cut out of it.
constexpr int kFinestSvgSide_px = 2048;
/// CSS's px; librsvg's own default is 90.
constexpr double kPixelsPerInch = 96;

struct Unref {
  void operator()(void* object) const { g_object_unref(object); }
};
template <class T>
using GObjectPtr = std::unique_ptr<T, Unref>;

struct DestroyCairo {
  void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
  void operator()(cairo_t* c) const { cairo_destroy(c); }
};

/// Takes the error over and throws it as one line.
[[noreturn]] void throw_input_error(const std::string& path, const std::string& what, GError* error) {
  std::string message = path + ": " + what;
  if (error) message += std::string(": ") + error->message;
  g_clear_error(&error);
  std::replace(message.begin(), message.end(), '\n', ' ');
  throw InputError(message);
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

class SvgPage : public ArtworkPage {
 public:
  SvgPage(std::span<const std::uint8_t> svg, const std::string& path) : path_(path) {
    GError* error = nullptr;
    handle_.reset(rsvg_handle_new_from_data(svg.data(), svg.size(), &error));
    if (!handle_) throw_input_error(path, "not a readable SVG file", error);
    rsvg_handle_set_dpi(handle_.get(), kPixelsPerInch);
    const std::optional<cv::Size2d> size = size_of_page(handle_.get());
    sized_ = size.has_value();
    size_ = size ? *size : reach_of_drawing(handle_.get());
    const bool has_area =
        std::isfinite(size_.width) && std::isfinite(size_.height) && size_.width > 0 && size_.height > 0;
    if (!has_area) throw InputError(path + ": the page has no area");
  }

  cv::Size2d natural_size() const override { return size_; }
  int finest_side_px() const override { return kFinestSvgSide_px; }
  float source_px(int) const override { return 0; }

  cv::Mat draw(int longest_side_px, const cv::Rect& window) const override {
    const double scale = longest_side_px / std::max(size_.width, size_.height);
    // librsvg fits a page that has a size into the viewport; without one it draws in px.
    const double viewport_scale = sized_ ? scale : 1;
    const RsvgRectangle viewport{0, 0, size_.width * viewport_scale, size_.height * viewport_scale};
    cv::Mat image(window.height, window.width, CV_8UC4, cv::Scalar::all(0));
    const std::unique_ptr<cairo_surface_t, DestroyCairo> surface(cairo_image_surface_create_for_data(
        image.data, CAIRO_FORMAT_ARGB32, image.cols, image.rows, int(image.step)));  // BGRA in memory
    const std::unique_ptr<cairo_t, DestroyCairo> cairo(cairo_create(surface.get()));
    cairo_translate(cairo.get(), -window.x, -window.y);
    cairo_scale(cairo.get(), scale / viewport_scale, scale / viewport_scale);
    GError* error = nullptr;
    if (!rsvg_handle_render_document(handle_.get(), cairo.get(), &viewport, &error)) {
      throw_input_error(path_, "cannot be drawn", error);
    }
    cairo_surface_flush(surface.get());
    return image;
  }

 private:
  std::string path_;
  GObjectPtr<RsvgHandle> handle_;
  bool sized_ = false;  // by the file
  cv::Size2d size_;
};

}  // namespace

bool looks_like_svg(std::span<const std::uint8_t> bytes) {
  if (is_gzip(bytes)) return true;
  const auto first = std::find_if(bytes.begin(), bytes.end(), [](std::uint8_t c) { return !std::isspace(c); });
  const auto rest = bytes.subspan(std::size_t(first - bytes.begin()));
  const auto starts_with = [&](std::initializer_list<std::uint8_t> mark) {
    return rest.size() >= mark.size() && std::equal(mark.begin(), mark.end(), rest.begin());
  };
  // "<", or a byte order mark of UTF-8 or UTF-16.
  return starts_with({'<'}) || starts_with({0xef, 0xbb, 0xbf}) || starts_with({0xff, 0xfe}) ||
         starts_with({0xfe, 0xff});
}

std::unique_ptr<ArtworkPage> open_svg_page(std::span<const std::uint8_t> bytes, const std::string& path) {
  if (is_gzip(bytes)) return std::make_unique<SvgPage>(gunzip(bytes, path, kMaxSvgBytes), path);
  return std::make_unique<SvgPage>(bytes, path);
}

}  // namespace tessera::io
