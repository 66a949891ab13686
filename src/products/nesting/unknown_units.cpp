#include "products/nesting/unknown_units.h"

#include <algorithm>
#include <optional>

#include "text/number_text.h"

namespace tessera {
namespace {

/// The length with one decimal, or with three digits where one decimal is too coarse.
std::string length_text(double mm) { return mm >= 10 ? fixed(mm, 1) : significant(mm, 3); }

std::string size_text(double width_mm, double height_mm) {
  return length_text(width_mm) + " x " + length_text(height_mm) + " mm";
}

/// The bounding box of the drawings in their file; empty without a drawing.
std::optional<NestBox> extent_of(const std::vector<NestDrawing>& drawings) {
  if (drawings.empty()) return std::nullopt;
  NestBox all = box_of(drawings.front().outline);
  for (const NestDrawing& drawing : drawings) {
    const NestBox box = box_of(drawing.outline);
    all.low = {std::min(all.low.x, box.low.x), std::min(all.low.y, box.low.y)};
    all.high = {std::max(all.high.x, box.high.x), std::max(all.high.y, box.high.y)};
  }
  return all;
}

std::string extent_text(const std::optional<NestBox>& extent) {
  return extent ? "its shapes take " + size_text(extent->width(), extent->height()) : "it has no shape";
}

/// A note that the program which wrote the file has px of another size; empty where it uses CSS's px, or px do not matter.
std::string own_px_text(const SvgOutlines& outlines, const std::optional<NestBox>& extent) {
  if (!(outlines.program_px_per_inch > 0) || !extent) return "";
  const double larger = kCssPxPerInch / outlines.program_px_per_inch;
  const std::string px = fixed(outlines.program_px_per_inch, 0);
  return "written by " + outlines.program + ", which had " + px + " px an inch: its shapes take " +
         size_text(larger * extent->width(), larger * extent->height()) + " then, and " +
         size_text(extent->width(), extent->height()) + " at CSS's 96, as they are read here; --dpi " + px +
         " or --dpi 96 chooses one";
}

}  // namespace

void UnknownUnits::add_svg(const std::string& path, const SvgOutlines& outlines,
                           const std::vector<NestDrawing>& drawings) {
  const std::optional<NestBox> extent = extent_of(drawings);
  if (const std::string text = own_px_text(outlines, extent); !text.empty()) own_px_.push_back(path + ": " + text);
  if (outlines.says_unit || svgs_.count++ > 0) return;
  svgs_.first = path;
  svgs_.size_mm = outlines.page_mm.empty()
                      ? extent_text(extent)
                      : "its page is " + size_text(outlines.page_mm.width, outlines.page_mm.height);
}

void UnknownUnits::add_dxf(const std::string& path, const DxfDrawings& found) {
  if (dxfs_.count++ > 0) return;
  dxfs_.first = path;
  constexpr double kInch_mm = 25.4;
  const std::optional<NestBox> extent = extent_of(found.drawings);
  dxfs_.size_mm = extent_text(extent);
  if (extent && found.measures_in_inches) {
    dxfs_.size_mm +=
        "; $MEASUREMENT = 0 hints at inches: " + size_text(kInch_mm * extent->width(), kInch_mm * extent->height());
  }
}

void UnknownUnits::report(const std::string& path, NestInput& input) const {
  const auto tell_of = [&](const Files& files, const std::string& unit, const std::string& what_sets_it) {
    if (files.count == 0) return;
    const std::string who = files.count == 1
                                ? files.first + " says no unit"
                                : path + ": " + std::to_string(files.count) + " files say no unit, as " + files.first;
    input.notes.push_back(who + ": 1 unit is taken as " + unit + ", " + files.size_mm + "; " + what_sets_it);
    input.unit += (input.unit.empty() ? "" : ", or ") + unit;
  };
  input.notes.insert(input.notes.end(), own_px_.begin(), own_px_.end());
  tell_of(svgs_, "1/96 inch", "width and height in mm in the SVG set it, --dpi says how many px an inch has");
  tell_of(dxfs_, "1 mm", "$INSUNITS in the DXF sets it");
}

}  // namespace tessera
