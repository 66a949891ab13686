#include "products/nesting/drawings/svg_drawings.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "artwork/outlines/flat_path.h"
#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/base/too_many.h"
#include "products/nesting/drawings/contour_chains.h"
#include "products/nesting/drawings/fill_rule.h"
#include "text/number_text.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr std::size_t kMostContours = 4'000;
constexpr std::size_t kMostOpenPaths = 20'000;

/// Throws InputError where there are more than a file may have.
void check_count(const char* what, std::size_t count, std::size_t allowed) {
  if (count > allowed) throw InputError(too_many(allowed, what + std::string(" in a file")));
}

/// The names as a text: "a, b, c and 3 more".
std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(kMost, names.size()); ++i)
    text += (i > 0 ? ", " : "") + printable_utf8(cut_utf8(names[i], 40));
  return names.size() > kMost ? text + " and " + std::to_string(names.size() - kMost) + " more" : text;
}

NestRing ring_of(const FlatSubpath& subpath) {
  NestRing ring;
  for (const cv::Point2d p : subpath.points) ring.push_back({p.x, p.y});
  return ring;
}

/// Whether a filled path, which is closed for that, has an area.
bool has_area(const NestRing& ring) {
  if (ring.size() < 3) return false;
  const NestBox box = box_of(ring);
  const double longest = std::max(box.width(), box.height());
  return std::abs(signed_area(ring)) > 1e-6 * longest * longest;
}

bool is_curved(const PathSteps& steps) {
  return std::any_of(steps.begin(), steps.end(), [](const PathStep& step) { return step.command == 'C'; });
}

/// The open path from its other end.
PathSteps reversed(const PathSteps& steps) {
  PathSteps back = {{'M', {{steps.back().points[std::size_t(points_of(steps.back()) - 1)]}}}};
  for (std::size_t i = steps.size() - 1; i > 0; --i) {
    const PathStep& step = steps[i];
    const cv::Point2d to = steps[i - 1].points[std::size_t(points_of(steps[i - 1]) - 1)];
    if (step.command == 'C')
      back.push_back({'C', {{step.points[1], step.points[0], to}}});
    else
      back.push_back({'L', {{to}}});
  }
  return back;
}

class SvgReader {
 public:
  explicit SvgReader(const std::string& path) : path_(path) {}

  void add(const SvgOutline& outline) {
    check_name(outline.name, path_ + ": id");
    std::vector<NestRing> contours;
    std::vector<PathSteps> curves;
    for (const FlatSubpath& subpath : flat_path(outline.steps, kFlatness_mm)) {
      NestRing ring = ring_of(subpath);
      if (ring.size() < 2) continue;  // a dot
      check_count("points", points_ += ring.size(), kMostDrawingPoints);
      PathSteps steps = steps_of(subpath, outline.steps);
      if (subpath.closed || (outline.filled && has_area(ring))) {
        contours.push_back(std::move(ring));
        curves.push_back(closed(std::move(steps)));
        check_count("contours", contours.size(), kMostContours);
      } else {
        add_line(outline.name, std::move(ring), std::move(steps));
      }
    }
    const std::vector<bool> is_seen = ends_fill(contours, outline.even_odd || !outline.filled);
    for (std::size_t i = 0; i < contours.size(); ++i) {
      if (is_seen[i])
        add_contour(outline.name, std::move(contours[i]), std::move(curves[i]));
      else
        ++inside_fills_;
    }
  }

  void join_lines(std::vector<std::string>& notes) {
    int open = 0, joined = 0;
    const std::vector<JoinedContour> contours = joined_contours(lines_, kJoinedEnds_mm, open);
    for (const JoinedContour& contour : contours) {
      joined += int(contour.lines.size());
      add_contour(names_[contour.lines.front().number], contour.ring, joined_steps(contour));
    }
    if (!contours.empty()) {
      notes.push_back("joined " + count_text(std::size_t(joined), "open path") + " to " +
                      count_text(contours.size(), "contour") + ": ends less than " + significant(kJoinedEnds_mm, 2) +
                      " mm apart meet");
    }
    note_left_out(open, "chain of lines that does not close", "chains of lines that do not close",
                  some_of(names_but(contours)), notes);
  }

  std::vector<NestDrawing> take(std::vector<std::string>& notes) {
    note_left_out(twice_, "outline that is there twice", "outlines that are there twice", "", notes);
    note_left_out(inside_fills_, "contour with fill on both sides", "contours with fill on both sides", "", notes);
    if (std::string faults = faults_text(contours_, path_); !faults.empty()) notes.push_back(std::move(faults));
    std::vector<NestDrawing> drawings = drawings_of(std::move(contours_));
    if (drawings.size() > kMostDrawings)
      throw InputError(path_ + ": found " + std::to_string(drawings.size()) +
                       " shapes, allowed: " + std::to_string(kMostDrawings));
    return drawings;
  }

 private:
  /// The coordinates of the ring, the same for both directions.
  static std::vector<std::pair<double, double>> one_way(const NestRing& ring) {
    std::vector<std::pair<double, double>> there, back;
    for (const NestPoint p : ring) there.emplace_back(p.x, p.y);
    back.assign(there.rbegin(), there.rend());
    std::rotate(back.begin(), back.end() - 1, back.end());  // from the same point on
    return std::min(there, back);
  }

  static PathSteps steps_of(const FlatSubpath& subpath, const PathSteps& path) {
    const auto first = path.begin() + std::ptrdiff_t(subpath.first_step);
    PathSteps steps(first, first + std::ptrdiff_t(subpath.steps));
    // After a Z the next subpath may begin without a move.
    if (steps.front().command != 'M') steps.insert(steps.begin(), PathStep{'M', {{subpath.points.front()}}});
    return steps;
  }

  static PathSteps closed(PathSteps steps) {
    if (steps.back().command != 'Z') steps.push_back({'Z'});
    return steps;
  }

  void add_contour(const std::string& name, NestRing ring, PathSteps steps) {
    if (!seen_.insert(one_way(ring)).second) {
      ++twice_;
      return;
    }
    std::string fault = contour_fault(ring);
    if (!fault.empty()) fault = printable_utf8(name) + ": " + fault;
    if (!is_curved(steps)) steps.clear();
    contours_.push_back({name, std::move(ring), std::move(fault), std::move(steps)});
    check_count("contours", contours_.size(), kMostContours);
  }

  void add_line(const std::string& name, NestRing ring, PathSteps steps) {
    names_.push_back(name);
    lines_.push_back(std::move(ring));
    line_steps_.push_back(std::move(steps));
    check_count("open paths", lines_.size(), kMostOpenPaths);
  }

  PathSteps joined_steps(const JoinedContour& contour) const {
    PathSteps all;
    for (const JoinedLine& line : contour.lines) {
      const PathSteps& own = line_steps_[line.number];
      const PathSteps steps = line.backwards ? reversed(own) : own;
      all.insert(all.end(), steps.begin() + (all.empty() ? 0 : 1), steps.end());
    }
    PathStep& last = all.back();
    last.points[std::size_t(points_of(last) - 1)] = all.front().points[0];
    return closed(std::move(all));
  }

  /// The names of the lines that belong to no contour, each once.
  std::vector<std::string> names_but(const std::vector<JoinedContour>& contours) const {
    std::set<std::size_t> joined;
    for (const JoinedContour& contour : contours) {
      for (const auto& line : contour.lines) joined.insert(std::size_t(line.number));
    }
    std::vector<std::string> names;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (!joined.contains(i) && std::find(names.begin(), names.end(), names_[i]) == names.end())
        names.push_back(names_[i]);
    }
    return names;
  }

  std::string path_;
  std::vector<NamedContour> contours_;
  std::set<std::vector<std::pair<double, double>>> seen_;
  int twice_ = 0;         // contours that were there already
  int inside_fills_ = 0;  // invisible contours, with fill on both sides
  std::vector<NestRing> lines_;
  std::vector<PathSteps> line_steps_;
  std::vector<std::string> names_;  // of the lines
  std::size_t points_ = 0;
};

std::string size_text(const NestBox& box) { return fixed(box.width(), 1) + " x " + fixed(box.height(), 1) + " mm"; }

/// Whether the drawing is a level rectangle with everything else in it, which is probably the bed of a machine.
bool is_bed(const std::vector<NestDrawing>& drawings) {
  if (drawings.size() != 1 || drawings.front().holes.empty() || drawings.front().outline.size() != 4) return false;
  const NestBox box = box_of(drawings.front().outline);
  const double area = box.width() * box.height();
  return std::abs(std::abs(signed_area(drawings.front().outline)) - area) < 1e-6 * area;
}

}  // namespace

SvgDrawings svg_drawings(const SvgOutlines& outlines, const std::string& path,
                         const std::vector<std::string>& left_out) {
  SvgReader reader(path);
  SvgDrawings found;
  try {
    for (const SvgOutline& outline : outlines.outlines) {
      if (std::find(left_out.begin(), left_out.end(), outline.name) == left_out.end()) reader.add(outline);
    }
    reader.join_lines(found.notes);
  } catch (const InputError& error) {
    const std::string text = error.what();
    throw InputError(text.starts_with(path) ? text : path + ": " + text);
  }
  note_left_out(int(outlines.undrawn_elements.size()),
                "element that is not drawn (hidden, transparent, empty, damaged, or with neither fill nor stroke)",
                "elements that are not drawn (hidden, transparent, empty, damaged, or with neither fill nor stroke)",
                some_of(outlines.undrawn_elements), found.notes);
  note_left_out(
      outlines.unread_elements,
      "element that is no outline: text or image; a drawing program makes paths of text, and traces images",
      "elements that are no outlines: texts or images; a drawing program makes paths of text, and traces images", "",
      found.notes);
  if (const std::vector<std::string>& masked = outlines.masked_elements; !masked.empty()) {
    found.notes.push_back("left out the mask of " + count_text(masked.size(), "element") +
                          ", whose whole outline is cut (--leave-out NAME leaves one out): " + some_of(masked));
  }
  note_left_out(int(outlines.far_elements.size()),
                "element with a coordinate that is no number or too large, allowed: 1e6 mm either way",
                "elements with coordinates that are no numbers or too large, allowed: 1e6 mm either way",
                some_of(outlines.far_elements), found.notes);
  found.drawings = reader.take(found.notes);
  if (is_bed(found.drawings)) {
    const NestDrawing& bed = found.drawings.front();
    found.notes.push_back(bed.name + " is a rectangle of " + size_text(box_of(bed.outline)) +
                          " round everything else, which is cut as its holes; where it is only the bed, --leave-out " +
                          bed.name + " nests what is in it");
  }
  return found;
}

}  // namespace tessera
