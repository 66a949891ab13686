#include "artwork/svg/svg_page.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "artwork/images/cairo_objects.h"
#include "artwork/svg/svg_document.h"
#include "files/gunzip.h"

namespace tessera {
namespace {

/// librsvg's layers have the size of the whole page, whatever window is drawn.
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

std::unique_ptr<ArtworkPage> open_svg_page(std::span<const std::uint8_t> bytes, const std::string& path) {
  if (is_gzip(bytes)) return std::make_unique<SvgPage>(gunzip(bytes, path, kMaxSvgBytes), path);
  return std::make_unique<SvgPage>(bytes, path);
}

}  // namespace tessera
