#include "artwork/svg/svg_pdf.h"

#include <cairo-pdf.h>

#include "artwork/images/cairo_objects.h"
#include "artwork/svg/printed_svg.h"
#include "core/base/error.h"

namespace tessera {
namespace {

cairo_status_t append_bytes(void* closure, const unsigned char* from, unsigned count) {
  auto& to = *static_cast<std::vector<std::uint8_t>*>(closure);
  to.insert(to.end(), from, from + count);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::vector<std::uint8_t> pdf_of_svg(std::span<const std::uint8_t> svg, const std::string& path, double width_pt,
                                     bool pieces_apart) {
  const PrintedSvg document(svg, path, pieces_apart);
  const double height_pt = width_pt * document.size().height / document.size().width;
  std::vector<std::uint8_t> bytes;
  const CairoSurface surface(cairo_pdf_surface_create_for_stream(append_bytes, &bytes, width_pt, height_pt));
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
  const CairoContext cairo(cairo_create(surface.get()));
  document.draw(cairo.get(), width_pt);
  cairo_surface_finish(surface.get());
  const cairo_status_t status = cairo_surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS) throw InputError(path + ": cannot be drawn: " + cairo_status_to_string(status));
  return bytes;
}

}  // namespace tessera
