#include "artwork/outlines/outline_clipping.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <polyclipping/clipper.hpp>

#include "artwork/outlines/flat_path.h"
#include "artwork/svg/flattened_nodes.h"

namespace tessera {
namespace {

namespace clip = ClipperLib;

/// cairo's numbers have 24.8 bits: it rounds to this part of a unit.
constexpr double kSteps = 256;

clip::Path whole(const std::vector<cv::Point2d>& points) {
  clip::Path path;
  for (const cv::Point2d p : points) path.emplace_back(std::llround(p.x * kSteps), std::llround(p.y * kSteps));
  return path;
}

/// A path in the form that Clipper takes.
struct Parts {
  clip::Paths closed, open;

  double size() const {
    double sum = 0;
    for (const clip::Path& path : closed) sum += clip::Area(path);  // the area of holes is negative
    for (const clip::Path& path : open) sum += length_of(path);
    return sum;
  }
  /// The amount by which rounding may change the size.
  double slack() const {
    double sum = 1;
    for (const clip::Path& path : closed) sum += length_of(path);
    return sum + 2 * double(open.size());
  }

 private:
  static double length_of(const clip::Path& path) {
    double sum = 0;
    for (std::size_t i = 1; i < path.size(); ++i)
      sum += std::hypot(double(path[i].X - path[i - 1].X), double(path[i].Y - path[i - 1].Y));
    return sum;
  }
};

/// The contours of a path. A filled path is closed everywhere; an open one stays a line.
Parts parts_of(const LayerPath& path, double tolerance) {
  Parts parts;
  for (const FlatSubpath& subpath : flat_path(path.steps, tolerance))
    (path.filled || subpath.closed ? parts.closed : parts.open).push_back(whole(subpath.points));
  const clip::PolyFillType rule = path.filled && !path.even_odd ? clip::pftNonZero : clip::pftEvenOdd;
  clip::SimplifyPolygons(parts.closed, rule);
  return parts;
}

clip::Paths grown(const clip::Paths& paths, double by) {
  clip::ClipperOffset offset;
  offset.AddPaths(paths, clip::jtMiter, clip::etClosedPolygon);
  clip::Paths out;
  offset.Execute(out, by);
  return out;
}

/// cairo writes a clip with horizontal and vertical sides as rectangles side by side; this joins the parts that they
/// cut.
clip::Paths without_seams(const clip::Paths& paths) {
  constexpr double kWidth = 2;
  return grown(grown(paths, kWidth), -kWidth);
}

Parts cut(const Parts& parts, const LayerClip& by, double tolerance) {
  clip::Paths window;
  for (const FlatSubpath& subpath : flat_path(by.steps, tolerance)) window.push_back(whole(subpath.points));
  clip::Clipper clipper;
  clipper.AddPaths(parts.closed, clip::ptSubject, true);
  clipper.AddPaths(parts.open, clip::ptSubject, false);
  clipper.AddPaths(window, clip::ptClip, true);
  clip::PolyTree seen;
  clipper.Execute(clip::ctIntersection, seen, clip::pftEvenOdd, by.even_odd ? clip::pftEvenOdd : clip::pftNonZero);
  Parts left;
  clip::ClosedPathsFromPolyTree(seen, left.closed);
  clip::OpenPathsFromPolyTree(seen, left.open);
  if (window.size() > 1) left.closed = without_seams(left.closed);
  return left;
}

void add(const clip::Paths& paths, bool closed, PathSteps& steps) {
  for (const clip::Path& path : paths) {
    for (std::size_t i = 0; i < path.size(); ++i)
      steps.push_back({i == 0 ? 'M' : 'L', {{{double(path[i].X) / kSteps, double(path[i].Y) / kSteps}}}});
    if (closed) steps.push_back({'Z'});
  }
}

/// The box and the area of a contour. Contours with the same box and area count as equal.
struct Trace {
  clip::IntPoint low, high;  // its box
  double area;
  double slack;  // how much rounding may change the area

  bool is_near(const Trace& other) const {
    constexpr clip::cInt kNear = 2;
    const auto near = [](const clip::IntPoint& p, const clip::IntPoint& q) {
      return std::abs(p.X - q.X) <= kNear && std::abs(p.Y - q.Y) <= kNear;
    };
    return near(low, other.low) && near(high, other.high) && std::abs(area - other.area) <= slack;
  }
};

Trace trace_of(const clip::Path& contour) {
  Trace trace{contour.front(), contour.front(), std::abs(clip::Area(contour)), 1};
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const clip::IntPoint& p = contour[i];
    const clip::IntPoint& next = contour[(i + 1) % contour.size()];
    trace.low = {std::min(trace.low.X, p.X), std::min(trace.low.Y, p.Y)};
    trace.high = {std::max(trace.high.X, p.X), std::max(trace.high.Y, p.Y)};
    trace.slack += std::hypot(double(next.X - p.X), double(next.Y - p.Y));
  }
  return trace;
}

/// Whether each path of `some` equals one of `all`.
bool are_among(const clip::Paths& some, const clip::Paths& all) {
  constexpr clip::cInt kReach = 2;
  std::multimap<clip::cInt, Trace> traces;  // by the left side of the box
  for (const clip::Path& contour : all) {
    if (contour.empty()) continue;
    const Trace trace = trace_of(contour);
    traces.emplace(trace.low.X, trace);
  }
  return std::all_of(some.begin(), some.end(), [&](const clip::Path& contour) {
    const Trace trace = trace_of(contour);
    return std::any_of(traces.lower_bound(trace.low.X - kReach), traces.upper_bound(trace.low.X + kReach),
                       [&](const auto& other) { return trace.is_near(other.second); });
  });
}

/// Whether the clip is a rectangle round `box`: most clips are the page or a viewport, round all that they cut.
bool surrounds(const LayerClip& by, const cv::Rect2d& box) {
  const std::optional<cv::Rect2d> window = level_rectangle(by.steps);
  return window && holds(*window, box, 1 / kSteps);
}

}  // namespace

LayerPath clipped(LayerPath path, double tolerance) {
  const cv::Rect2d box = box_of(path.steps);
  std::vector<const LayerClip*> clips;
  for (const std::shared_ptr<const LayerClip>& by : path.clips) {
    if (!surrounds(*by, box)) clips.push_back(by.get());
  }
  if (clips.empty()) return path;
  const Parts whole = parts_of(path, tolerance);
  Parts left = whole;
  for (const LayerClip* by : clips) left = cut(left, *by, tolerance);
  if (left.size() >= whole.size() - whole.slack()) return path;
  path.even_odd = true;
  path.steps.clear();
  add(left.closed, true, path.steps);
  add(left.open, false, path.steps);
  return path;
}

LayerPath united(LayerPath path, double tolerance) {
  if (!path.filled) return path;
  const clip::PolyFillType rule = path.even_odd ? clip::pftEvenOdd : clip::pftNonZero;
  clip::Paths contours;
  for (const FlatSubpath& subpath : flat_path(path.steps, tolerance)) contours.push_back(whole(subpath.points));
  if (contours.size() < 2) return path;
  clip::Paths joined;
  clip::SimplifyPolygons(contours, joined, rule);
  if (are_among(joined, contours)) return path;
  path.even_odd = true;
  path.steps.clear();
  add(joined, true, path.steps);
  return path;
}

}  // namespace tessera
