#include "io/artwork/svg_page.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "io/artwork/gunzip.h"
#include "io/artwork/svg_document.h"
#include "io/cairo_objects.h"

namespace tessera::io {
namespace {

/// Layers of librsvg have the size of the whole page, whatever is cut out of it.
constexpr int kFinestSvgSide_px = 2048;
class SvgPage : public ArtworkPage {
 public:
  SvgPage(std::span<const std::uint8_t> svg, const std::string& path) : document_(svg, path, RSVG_HANDLE_FLAGS_NONE) {}

  cv::Size2d natural_size() const override { return document_.size(); }
  int finest_side_px() const override { return kFinestSvgSide_px; }
  float source_px(int) const override { return 0; }
  bool loses_text() const override { return document_.loses_text(); }

  cv::Mat draw(int longest_side_px, const cv::Rect& window) const override {
    cv::Mat image(window.height, window.width, CV_8UC4, cv::Scalar::all(0));
    const CairoSurface surface(cairo_image_surface_create_for_data(image.data, CAIRO_FORMAT_ARGB32, image.cols,
                                                                   image.rows, int(image.step)));  // BGRA in memory
    const CairoContext cairo(cairo_create(surface.get()));
    cairo_translate(cairo.get(), -window.x, -window.y);
    document_.draw(cairo.get(), longest_side_px / std::max(natural_size().width, natural_size().height));
    cairo_surface_flush(surface.get());
    return image;
  }

 private:
  SvgDocument document_;
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
