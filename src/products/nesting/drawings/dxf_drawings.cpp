#include "products/nesting/drawings/dxf_drawings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/count_text.h"
#include "core/base/error.h"
#include "products/nesting/drawings/contour_chains.h"
#include "products/nesting/drawings/dxf_blocks.h"
#include "products/nesting/drawings/dxf_reader.h"
#include "text/number_text.h"

namespace tessera {
namespace {

constexpr std::size_t kMostLines = 20'000;

/// A place as a text, in the units of the file, y up.
std::string place_text(NestPoint p_mm, double mm) {
  constexpr int kDigits = 10;
  return "(" + significant(p_mm.x / mm, kDigits) + ", " + significant(p_mm.y == 0 ? 0 : -p_mm.y / mm, kDigits) + ")";
}

/// The lower left corner; y points down.
NestPoint lower_left(const NestBox& box) { return {box.low.x, box.high.y}; }

NestPoint centre_of(const NestBox& box) { return (box.low + box.high) * 0.5; }

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The lower left corner of most contours. A contour far from all others, such as a stray one at the origin, does not
/// count. There must be one box at least.
NestPoint corner_of_most(const std::vector<NestBox>& boxes) {
  std::vector<double> x, y;
  for (const NestBox& box : boxes) {
    x.push_back(centre_of(box).x);
    y.push_back(centre_of(box).y);
  }
  const NestPoint middle{median(std::move(x)), median(std::move(y))};
  NestPoint corner = middle;
  for (const NestBox& box : boxes) {
    const NestPoint off = centre_of(box) - middle, at = lower_left(box);
    if (std::max(std::abs(off.x), std::abs(off.y)) > kFarthest_mm / 2) continue;
    corner = {std::min(corner.x, at.x), std::max(corner.y, at.y)};
  }
  return corner;
}

bool is_far(const NestBox& box) { return std::max({-box.low.x, -box.low.y, box.high.x, box.high.y}) > kFarthest_mm; }

/// Names each contour by its number and its first point, because the outlines of a DXF have no names.
std::vector<NamedContour> named_contours(std::vector<JoinedContour> contours, const std::string& name, double mm,
                                         std::vector<std::string>& notes) {
  std::vector<NamedContour> named;
  std::vector<NestBox> boxes;
  for (const JoinedContour& contour : contours) boxes.push_back(box_of(contour.ring));
  NestPoint moved{};
  if (std::any_of(boxes.begin(), boxes.end(), is_far)) {
    moved = corner_of_most(boxes);
    notes.push_back("the drawing begins at " + place_text(moved, mm) + ": moved to the origin");
  }
  for (JoinedContour& joined : contours) {
    NestRing& contour = joined.ring;
    const std::string place = place_text(lower_left(boxes[named.size()]), mm);
    for (NestPoint& p : contour) p = p - moved;
    std::string fault = contour_fault(contour);
    if (!fault.empty()) fault = "contour " + std::to_string(named.size() + 1) + " at " + place + ": " + fault;
    named.push_back({name, std::move(contour), std::move(fault)});
  }
  return named;
}

void note_of(const DxfDocument& document, const DxfLines& lines, std::vector<std::string>& notes) {
  note_left_out(lines.hidden.count(), "entity on a layer that is off or frozen",
                "entities on layers that are off or frozen", lines.hidden.names(), notes);
  note_left_out(lines.invisible, "invisible entity", "invisible entities", "", notes);
  note_left_out(lines.unread.count(), "entity of a kind that is not read", "entities of kinds that are not read",
                lines.unread.names(), notes);
  note_left_out(lines.missing.count(), "reference to a block that the file does not hold",
                "references to blocks that the file does not hold", lines.missing.names(), notes);
  note_left_out(document.in_paper, "entity of a layout on paper", "entities of layouts on paper", "", notes);
}

}  // namespace

DxfDrawings dxf_drawings(std::string_view text, const std::string& path, const std::string& name) {
  const DxfDocument document = dxf_document(text, path);
  DxfLines lines = dxf_lines(document, path);
  DxfDrawings found;
  found.says_unit = document.says_unit;
  found.measures_in_inches = document.measures_in_inches;
  note_of(document, lines, found.notes);
  if (lines.lines.size() > kMostLines)
    throw InputError(path + ": found " + std::to_string(lines.lines.size()) +
                     " lines and arcs, allowed: " + std::to_string(kMostLines));
  int open = 0;
  std::vector<JoinedContour> contours = joined_contours(lines.lines, kFlatness_mm, open);
  note_left_out(open, "chain of lines that does not close", "chains of lines that do not close", "", found.notes);
  if (contours.size() > kMostDrawings) {
    throw InputError(path + ": found " + std::to_string(contours.size()) +
                     " contours, allowed: " + std::to_string(kMostDrawings) + " in a file");
  }
  std::vector<NamedContour> named = named_contours(std::move(contours), name, document.mm, found.notes);
  if (std::string faults = faults_text(named, path); !faults.empty()) found.notes.push_back(std::move(faults));
  found.drawings = drawings_of(std::move(named));
  return found;
}

}  // namespace tessera
