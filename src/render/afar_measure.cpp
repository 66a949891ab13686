#include "render/afar_measure.h"

#include "core/base/error.h"
#include "job/canvas/overlays.h"
#include "job/picture_size.h"
#include "render/pieces/tones.h"

namespace tessera {
namespace {

// The picture's path is left out, because cards may be passed on.
constexpr const char* kUnreadable = "colour.image cannot be read any more";
constexpr const char* kAnother = "colour.image has changed since the collage";
constexpr const char* kUnknownSizes = "the pieces that the collage began from cannot be read any more";
constexpr const char* kTransparent = "colour.image is transparent here";

/// Whether the picture gives the covered colours in the report, so that it is the one by which pieces were chosen.
bool is_of_collage(const ColourImage& image, const CollageReport& report) {
  return report.covered.empty() || covered_colours(report.placements, report.shapes, *image.target) == report.covered;
}

}  // namespace

AfarMeasure::AfarMeasure(const CollageReport& report, const std::string& image, std::optional<float> smallest_px,
                         Drawers& drawers)
    : canvas_(*report.canvas),
      pieces_(report.placements.size()),
      mosaic_(picture_size_px(report.output, *report.canvas)) {
  if (!smallest_px) {
    not_measured_ = kUnknownSizes;
    return;
  }
  try {
    const ColourImage shown = read_colour_image(*report.canvas, image, *smallest_px, drawers);
    if (!is_of_collage(shown, report)) {
      not_measured_ = kAnother;
      return;
    }
    const cv::Size size_px = picture_size_px(report.output, *report.canvas);
    picture_ = cells_of_picture(shown.bgra, comparison_cells(size_px));
  } catch (const InputError&) {
    not_measured_ = kUnreadable;
  }
}

AfarNote AfarMeasure::note() const {
  if (!not_measured_.empty()) return {{}, not_measured_};
  const PicturePair pair = picture_pair(mosaic_.cells(), picture_, &canvas_);
  AfarNote note{seen_from_afar(pair, width_in_pieces(canvas_, pieces_)), {}};
  if (!note.seen) note.not_measured = kTransparent;
  return note;
}

}  // namespace tessera
