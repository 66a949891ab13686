#include "products/nesting/drawings/nest_contours.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/count_text.h"
#include "core/base/error.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

bool is_near(const NestRing& ring) {
  return std::all_of(ring.begin(), ring.end(),
                     [](NestPoint p) { return std::abs(p.x) <= kFarthest_mm && std::abs(p.y) <= kFarthest_mm; });
}

}  // namespace

std::string contour_fault(const NestRing& contour) {
  if (contour.size() < 3) return "found a contour of " + count_text(contour.size(), "point") + ", allowed: 3 or more";
  if (contour.size() > kMostContourPoints) {
    return "found a contour of " + std::to_string(contour.size()) +
           " points, allowed: " + std::to_string(kMostContourPoints) + " or fewer";
  }
  if (!is_near(contour)) return "found a coordinate that is no number or too large, allowed: 1e6 mm either way";
  if (crosses_itself(contour)) return "found a contour that crosses itself";
  const NestBox box = box_of(contour);
  const double longest = std::max(box.width(), box.height());
  if (!(std::abs(signed_area(contour)) > 1e-9 * longest * longest && longest > 1e-6))
    return "found a contour that encloses nothing";
  return {};
}

void check_contour(const NestRing& contour, const std::string& what) {
  if (const std::string fault = contour_fault(contour); !fault.empty()) throw InputError(what + ": " + fault);
}

std::string faults_text(const std::vector<NamedContour>& contours, const std::string& path) {
  constexpr std::size_t kMostBytes = 300;
  std::size_t count = 0;
  std::string faults;
  for (const NamedContour& contour : contours) {
    if (contour.fault.empty()) continue;
    if (++count == 1 || faults.size() < kMostBytes) faults += (count > 1 ? "; " : "") + contour.fault;
  }
  if (count == 0) return {};
  if (count == contours.size()) {
    const std::string all = count > 1 ? "none of " + std::to_string(count) + " contours is of use: " : "";
    throw InputError(path + ": " + all + cut_utf8(faults, kMostBytes));
  }
  return "left out " + (count > 1 ? count_text(count, "contour") + ": " : "") + cut_utf8(faults, kMostBytes);
}

const PathSteps& NestDrawing::curve(std::size_t contour) const {
  static const PathSteps kNone;
  return contour < curves.size() ? curves[contour] : kNone;
}

std::size_t points_of(const NestDrawing& drawing) {
  std::size_t points = drawing.outline.size();
  for (const NestRing& hole : drawing.holes) points += hole.size();
  return points;
}

void check_name(const std::string& name, const std::string& what) {
  if (name.size() <= kMostNameBytes) return;
  throw InputError(what + ": found a name of " + std::to_string(name.size()) + " bytes, \"" +
                   printable_utf8(cut_utf8(name, 20)) + "...\", allowed: " + std::to_string(kMostNameBytes));
}

void note_left_out(int count, const char* one, const char* several, const std::string& names,
                   std::vector<std::string>& notes) {
  if (count > 0)
    notes.push_back("left out " + count_text(std::size_t(count), one, several) + (names.empty() ? "" : ": " + names));
}

bool lies_in(const NestRing& inner, const RingRows& outer) {
  constexpr std::size_t kLooks = 5;
  std::size_t inside = 0;
  for (std::size_t i = 0; i < kLooks; ++i) inside += outer.contains(inner[i * inner.size() / kLooks]) ? 1 : 0;
  return 2 * inside > kLooks;
}

namespace {

/// The steps, within bounds; `least` for NaN, whose points contour_fault() finds.
double whole_steps(double wanted, double least, double most) {
  return wanted > least ? std::min(std::ceil(wanted), most) : least;
}

/// The largest contour around each contour; -1: none.
std::vector<int> outermost(const std::vector<NamedContour>& contours) {
  std::vector<double> areas;
  std::vector<RingRows> rows;
  std::vector<std::size_t> largest_first;
  for (const NamedContour& contour : contours) {
    largest_first.push_back(areas.size());
    // A contour that crosses itself may enclose nothing, like a bow with equal halves. Its bounding box counts then.
    const NestBox box = box_of(contour.ring);
    areas.push_back(contour.fault.empty() ? std::abs(signed_area(contour.ring)) : box.width() * box.height());
    rows.emplace_back(contour.ring);
  }
  std::stable_sort(largest_first.begin(), largest_first.end(),
                   [&](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });
  std::vector<int> outer(contours.size(), -1);
  for (std::size_t i = 0; i < contours.size(); ++i) {
    for (const std::size_t j : largest_first) {
      if (!(areas[j] > areas[i])) break;
      if (!holds(rows[j].box(), rows[i].box()) || !lies_in(contours[i].ring, rows[j])) continue;
      outer[i] = int(j);
      break;
    }
  }
  return outer;
}

}  // namespace

std::vector<NestDrawing> drawings_of(std::vector<NamedContour> contours) {
  // A contour with fewer than three points, or far away, tells nothing, not even what lies in it.
  std::erase_if(contours,
                [](const NamedContour& contour) { return contour.ring.size() < 3 || !is_near(contour.ring); });
  const std::vector<int> outer = outermost(contours);
  const auto is_piece = [&](std::size_t i) { return outer[i] < 0 && contours[i].fault.empty(); };
  std::map<std::string, int> outlines, named;
  for (std::size_t i = 0; i < contours.size(); ++i) outlines[contours[i].name] += is_piece(i) ? 1 : 0;
  std::vector<NestDrawing> drawings;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (!is_piece(i)) continue;
    const std::string& name = contours[i].name;
    NestDrawing& drawing = drawings.emplace_back();
    drawing.name = printable_utf8(outlines[name] > 1 ? name + "-" + std::to_string(++named[name]) : name);
    drawing.curves.push_back(contours[i].curve);
    for (std::size_t j = 0; j < contours.size(); ++j) {
      if (outer[j] != int(i) || !contours[j].fault.empty()) continue;
      drawing.holes.push_back(contours[j].ring);
      drawing.curves.push_back(contours[j].curve);
    }
  }
  std::size_t next = 0;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (is_piece(i)) drawings[next++].outline = std::move(contours[i].ring);
  }
  return drawings;
}

void add_arc(NestPoint centre, NestPoint u, NestPoint v, double first, double last, NestRing& ring) {
  constexpr double kMostSteps = 2'000;
  const double radius = std::max(norm(u), norm(v));
  const double step = 2 * std::acos(std::max(0.0, 1 - kFlatness_mm / std::max(radius, kFlatness_mm)));
  const double steps = whole_steps(std::abs(last - first) / step, 8, kMostSteps);
  for (int i = 1; i <= int(steps); ++i) {
    const double t = first + (last - first) * (i / steps);
    ring.push_back(centre + u * std::cos(t) + v * std::sin(t));
  }
}

}  // namespace tessera
