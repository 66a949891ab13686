#include "artwork/svg/flattened_svg.h"

#include <cairo-svg.h>

#include <algorithm>
#include <vector>

#include "artwork/images/cairo_objects.h"
#include "artwork/images/looks_like_svg.h"
#include "artwork/svg/svg_document.h"
#include "artwork/svg/svg_page.h"
#include "core/base/error.h"
#include "files/gunzip.h"

namespace tessera {
namespace {

/// Largest flattened text: a drawer has 512 MiB, for the text and its tree.
constexpr std::size_t kMostBytes = std::size_t(64) << 20;
/// A unit of the flattened drawing is a point for cairo. Parts that cairo can only draw as pixels have one px a unit.
constexpr double kPointsPerInch = 72;

cairo_status_t append(void* closure, const unsigned char* from, unsigned count) {
  auto& text = *static_cast<std::string*>(closure);
  if (text.size() + count > kMostBytes) return CAIRO_STATUS_WRITE_ERROR;
  text.append(reinterpret_cast<const char*>(from), count);
  return CAIRO_STATUS_SUCCESS;
}

std::vector<std::uint8_t> unpacked(std::span<const std::uint8_t> bytes, const std::string& path) {
  if (is_gzip(bytes)) return gunzip(bytes, path, kMaxSvgBytes);
  return {bytes.begin(), bytes.end()};
}

}  // namespace

FlattenedSvg flattened_svg(std::span<const std::uint8_t> bytes, const std::string& path) {
  if (!looks_like_svg(bytes)) throw InputError(path + ": not an SVG file");
  const std::vector<std::uint8_t> svg = unpacked(bytes, path);
  const SvgDocument document(svg, path, RSVG_HANDLE_FLAGS_NONE);
  FlattenedSvg flattened{.text = {}, .page = document.size(), .page_from_unit = 1};
  flattened.page_from_unit = std::max(flattened.page.width, flattened.page.height) / kFlattenedSide;
  const cv::Size2d size = flattened.page / flattened.page_from_unit;
  const CairoSurface surface(cairo_svg_surface_create_for_stream(append, &flattened.text, size.width, size.height));
  // SVG 1.2 only adds the blending of layers; without it layers and everything beneath would become pixels.
  cairo_svg_surface_restrict_to_version(surface.get(), CAIRO_SVG_VERSION_1_2);
  cairo_surface_set_fallback_resolution(surface.get(), kPointsPerInch, kPointsPerInch);
  {
    const CairoContext cairo(cairo_create(surface.get()));
    document.draw(cairo.get(), 1 / flattened.page_from_unit);
  }
  cairo_surface_finish(surface.get());
  const cairo_status_t status = cairo_surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS) {
    throw InputError(path + ": cannot be taken apart: " + cairo_status_to_string(status));
  }
  return flattened;
}

}  // namespace tessera
