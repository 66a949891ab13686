#include "artwork/outlines/svg_outlines.h"

#include <cairo-svg.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

#include "artwork/images/cairo_objects.h"
#include "artwork/images/looks_like_svg.h"
#include "artwork/outlines/drawing_elements.h"
#include "artwork/outlines/layer_paths.h"
#include "artwork/outlines/outline_clipping.h"
#include "artwork/svg/flattened_nodes.h"
#include "artwork/svg/svg_document.h"
#include "artwork/svg/svg_page.h"
#include "core/base/error.h"
#include "core/base/too_many.h"
#include "files/gunzip.h"
#include "files/write_all.h"

namespace tessera {
namespace {

constexpr double kMmPerInch = 25.4;
/// Largest reach of a layer in each direction, in its own units: cairo holds 2^23 of them, and rounds to 1/256.
constexpr double kFarthest = 4e6;
/// In the largest unit a layer reaches kFarthestOutline_mm. In the smallest unit coordinates are rounded to a millionth
/// of a mm.
constexpr double kLargestUnit_mm = 0.25, kSmallestUnit_mm = 0.25 / 1024;
/// Coordinates are rounded to this part of a mm. librsvg reads lengths in single precision, 33.4 as 33.4000015, and a
/// part exactly as wide as its sheet must still fit.
constexpr double kStepsPerMm = 1e4;
/// Largest distance between the curve and a polygon that a clip makes.
constexpr double kTolerance_mm = 0.01;

/// A style sheet that removes everything that is no outline or would turn a layer into pixels. Declarations with
/// "!important" in the file override it.
constexpr std::string_view kPlainStyle =
    "*{filter:none!important;mask:none!important;marker-start:none!important;marker-mid:none!important;"
    "marker-end:none!important;mix-blend-mode:normal!important;isolation:auto!important;"
    "stroke-dasharray:none!important}"
    "text,image,foreignObject{display:none!important}";
constexpr std::string_view kOpaqueStyle = "*{opacity:1!important}";

/// Longest text of a layer.
constexpr std::size_t kMostBytes = std::size_t(64) << 20;

cairo_status_t append(void* closure, const unsigned char* from, unsigned count) {
  auto& text = *static_cast<std::string*>(closure);
  if (text.size() + count > kMostBytes) return CAIRO_STATUS_WRITE_ERROR;
  text.append(reinterpret_cast<const char*>(from), count);
  return CAIRO_STATUS_SUCCESS;
}

/// The paths of one element, or of the whole drawing where `leaf` is null. A px is `scale` units; the page's corner is
/// at (kFarthest, kFarthest).
std::vector<LayerPath> paths_of(const SvgDocument& document, const DrawingElement* leaf, double scale) {
  std::string text;
  const CairoSurface surface(cairo_svg_surface_create_for_stream(append, &text, 2 * kFarthest, 2 * kFarthest));
  cairo_svg_surface_restrict_to_version(surface.get(), CAIRO_SVG_VERSION_1_2);
  {
    const CairoContext cairo(cairo_create(surface.get()));
    cairo_translate(cairo.get(), kFarthest, kFarthest);
    cairo_scale(cairo.get(), scale, scale);
    if (leaf)
      document.draw_element(cairo.get(), leaf->id, document.size());
    else
      document.draw(cairo.get(), 1);
  }
  cairo_surface_finish(surface.get());
  const cairo_status_t status = cairo_surface_status(surface.get());
  if (status == CAIRO_STATUS_WRITE_ERROR) throw InputError(too_many(kMostBytes >> 20, "MiB of paths"));
  if (status != CAIRO_STATUS_SUCCESS)
    throw InputError(std::string("cannot be taken apart: ") + cairo_status_to_string(status));
  return layer_paths(text);
}

/// The box round what a layer shows, in the layer's units.
struct Extent {
  cv::Point2d low = {}, high = {};
  bool empty = true;

  void add(cv::Point2d p) {
    low = empty ? p : cv::Point2d(std::min(low.x, p.x), std::min(low.y, p.y));
    high = empty ? p : cv::Point2d(std::max(high.x, p.x), std::max(high.y, p.y));
    empty = false;
  }
  void add(const Extent& other) {
    if (other.empty) return;
    add(other.low);
    add(other.high);
  }
  /// The sides of the box, measured from the page's corner; 0 where nothing is shown.
  std::array<double, 4> sides() const {
    if (empty) return {};
    return {low.x - kFarthest, low.y - kFarthest, high.x - kFarthest, high.y - kFarthest};
  }
};

Extent extent_of(const std::vector<LayerPath>& paths) {
  Extent extent;
  for (const LayerPath& path : paths) {
    const cv::Rect2d box = box_of(path.steps);
    extent.add(box.tl());
    extent.add(box.br());
  }
  return extent;
}

/// The factor by which a drawing is made smaller to test whether it reaches too far.
constexpr double kSmaller = 17.3;

/// Whether something lies beyond the range of cairo's numbers. cairo wraps it round to another place, which depends on
/// the scale. `small` is the extent of the same drawing, made kSmaller times smaller.
bool is_too_far(const Extent& extent, const Extent& small) {
  if (extent.empty != small.empty) return true;
  const double slack =
      2 * kSmaller / 256 + 1e-6 * (std::abs(extent.high.x - extent.low.x) + std::abs(extent.high.y - extent.low.y));
  for (std::size_t i = 0; i < 4; ++i) {
    const double side = extent.sides()[i];
    if (std::abs(side) > kFarthest || std::abs(side - kSmaller * small.sides()[i]) > slack) return true;
  }
  return false;
}

bool is_same(const PathSteps& a, const PathSteps& b) {
  const auto is_near = [](const PathStep& s, const PathStep& t) {
    constexpr double kNear = 0.1;  // a stroke's path is rounded in its own frame
    if (s.command != t.command) return false;
    for (std::size_t i = 0; i < std::size_t(points_of(s)); ++i) {
      if (std::abs(s.points[i].x - t.points[i].x) > kNear || std::abs(s.points[i].y - t.points[i].y) > kNear)
        return false;
    }
    return true;
  };
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), is_near);
}

/// The paths without strokes of paths that are also filled. cairo writes fill and stroke of a path as one path or as
/// two.
std::vector<LayerPath> without_strokes_of_fills(const std::vector<LayerPath>& paths) {
  std::vector<LayerPath> kept;
  for (const LayerPath& path : paths) {
    const bool is_stroke_of_fill = !path.filled && std::any_of(paths.begin(), paths.end(), [&](const LayerPath& other) {
      return other.filled && is_same(other.steps, path.steps);
    });
    if (!is_stroke_of_fill) kept.push_back(path);
  }
  return kept;
}

/// The px in an inch of a program that did not use CSS's 96; 0 for other programs. Inkscape used 90 up to 0.91,
/// Illustrator uses 72.
double px_per_inch_of(std::string_view program) {
  if (program.starts_with("Adobe Illustrator")) return 72;
  constexpr std::string_view kInkscape = "Inkscape 0.";
  if (!program.starts_with(kInkscape)) return 0;
  const std::string_view minor = program.substr(kInkscape.size());
  return minor.starts_with("91") || minor.starts_with("3") || minor.starts_with("4") ? 90 : 0;
}

/// Counts the visible texts, images and foreign objects, and each <use> that shows one.
int count_others(const SvgDocument& document, const std::vector<DrawingElement>& leaves) {
  return int(std::count_if(leaves.begin(), leaves.end(), [&](const DrawingElement& leaf) {
    return leaf.shows_picture || (leaf.is_text && document.draws_element(leaf.id));
  }));
}

/// Gets the paths from librsvg; each element is drawn once. A drawing of the whole tells whether any element is
/// invisible or too far away. Only then each one is tested, as a layer takes a time that grows with the number of
/// elements.
class OutlineReader {
 public:
  OutlineReader(const DrawingElements& leaves, const std::string& path, double px_per_inch)
      : leaves_(leaves),
        path_(path),
        px_per_inch_(px_per_inch) {}

  SvgOutlines read() {
    SvgDocument document = this->document();
    SvgOutlines found = page_of(document);
    found.unread_elements = count_others(document, leaves_.list);
    // librsvg keeps the declarations of earlier sheets: the sheet with the fewest comes first.
    document.set_style(std::string(kPlainStyle));
    const std::size_t seen_paths = paths_of(document, nullptr, scale()).size();
    document.set_style(std::string(kPlainStyle) + std::string(kOpaqueStyle));
    unit_mm_ = unit_for(extent_of(paths_of(document, nullptr, scale() / kSmaller)));
    std::vector<LeafOutlines> drawn = drawn_leaves(document);
    mark_far(document, drawn);
    std::size_t paths = 0;
    for (const LeafOutlines& leaf : drawn) paths += leaf.paths;
    if (paths != seen_paths) clear_unseen(drawn);
    for (std::size_t i = 0; i < drawn.size(); ++i) add(leaves_.list[i], drawn[i], found);
    return found;
  }

 private:
  /// The outlines of one element, drawn as if it were opaque.
  struct LeafOutlines {
    std::vector<SvgOutline> outlines = {};
    std::size_t paths = 0;
    Extent extent = {};
    bool is_far = false;
  };

  /// The document without librsvg's limit of 10 MB: libxml2 has already limited the text's depth and entities.
  SvgDocument document() const { return {bytes_of(leaves_.text), path_, RSVG_HANDLE_FLAG_UNLIMITED, px_per_inch_}; }

  /// Units in a px.
  double scale() const { return kMmPerInch / px_per_inch_ / unit_mm_; }

  /// The smallest unit in which the drawing fits. `small` is the drawing's extent in the largest unit, made kSmaller
  /// times smaller.
  static double unit_for(const Extent& small) {
    double farthest = 0;
    for (const double side : small.sides()) farthest = std::max(farthest, std::abs(side));
    const double farthest_mm = (farthest + 1) * kSmaller * kLargestUnit_mm;
    double unit_mm = kLargestUnit_mm;
    while (unit_mm > kSmallestUnit_mm && farthest_mm < kFarthest * unit_mm / 2) unit_mm /= 2;
    return unit_mm;
  }

  SvgOutlines page_of(const SvgDocument& document) const {
    SvgOutlines found{.says_unit = leaves_.says_px || document.says_unit(),
                      .program = leaves_.program,
                      .program_px_per_inch = document.depends_on_px() ? px_per_inch_of(leaves_.program) : 0};
    if (document.has_size()) found.page_mm = document.size() * (kMmPerInch / px_per_inch_);
    return found;
  }

  std::vector<LeafOutlines> drawn_leaves(const SvgDocument& document) {
    std::vector<LeafOutlines> drawn;
    for (const DrawingElement& leaf : leaves_.list) {
      LeafOutlines& found = drawn.emplace_back();
      if (!leaf.is_shape) continue;
      const std::vector<LayerPath> paths = paths_of(document, &leaf, scale());
      found.paths = paths.size();
      found.extent = extent_of(paths);
      for (const LayerPath& path : without_strokes_of_fills(paths)) add(leaf, path, found.outlines);
    }
    return drawn;
  }

  void add(const DrawingElement& leaf, const LayerPath& path, std::vector<SvgOutline>& outlines) {
    const double tolerance = kTolerance_mm / unit_mm_;
    LayerPath seen = united(clipped(path, tolerance), tolerance);
    if (seen.steps.empty()) return;
    steps_ += seen.steps.size();
    if (steps_ > kMostOutlineSteps) throw InputError(too_many(kMostOutlineSteps, "points and curves in a file"));
    outlines.push_back(
        {.name = leaf.name, .filled = seen.filled, .even_odd = seen.even_odd, .steps = in_mm(std::move(seen.steps))});
  }

  PathSteps in_mm(PathSteps steps) const {
    const auto rounded = [&](double units) {
      return std::round((units - kFarthest) * unit_mm_ * kStepsPerMm) / kStepsPerMm;
    };
    for (PathStep& step : steps) {
      for (int k = 0; k < points_of(step); ++k) {
        cv::Point2d& p = step.points[std::size_t(k)];
        p = {rounded(p.x), rounded(p.y)};
      }
    }
    return steps;
  }

  void mark_far(const SvgDocument& document, std::vector<LeafOutlines>& drawn) const {
    const auto small_extent = [&](const DrawingElement* leaf) {
      return extent_of(paths_of(document, leaf, scale() / kSmaller));
    };
    Extent all;
    for (const LeafOutlines& leaf : drawn) all.add(leaf.extent);
    if (!is_too_far(all, small_extent(nullptr))) return;
    for (std::size_t i = 0; i < drawn.size(); ++i)
      drawn[i].is_far = leaves_.list[i].is_shape && is_too_far(drawn[i].extent, small_extent(&leaves_.list[i]));
  }

  void clear_unseen(std::vector<LeafOutlines>& drawn) const {
    SvgDocument document = this->document();
    document.set_style(std::string(kPlainStyle));
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      if (drawn[i].paths > 0 && paths_of(document, &leaves_.list[i], scale()).empty()) drawn[i].outlines.clear();
    }
  }

  static void add(const DrawingElement& leaf, LeafOutlines& drawn, SvgOutlines& found) {
    if (drawn.is_far)
      found.far_elements.push_back(leaf.name);
    else if (leaf.is_shape && drawn.outlines.empty())
      found.undrawn_elements.push_back(leaf.name);
    else {
      if (leaf.is_masked && leaf.is_shape) found.masked_elements.push_back(leaf.name);
      std::move(drawn.outlines.begin(), drawn.outlines.end(), std::back_inserter(found.outlines));
    }
  }

  const DrawingElements& leaves_;
  const std::string& path_;
  const double px_per_inch_;
  double unit_mm_ = kLargestUnit_mm;
  std::size_t steps_ = 0;
};

}  // namespace

SvgOutlines svg_outlines(std::span<const std::uint8_t> bytes, const std::string& path, double px_per_inch) {
  if (!looks_like_svg(bytes)) throw InputError(path + ": not an SVG file");
  std::vector<std::uint8_t> unpacked;
  if (is_gzip(bytes)) bytes = unpacked = gunzip(bytes, path, kMaxSvgBytes);
  const DrawingElements leaves = drawing_elements(bytes, path);
  try {
    return OutlineReader(leaves, path, px_per_inch).read();
  } catch (const InputError& error) {
    const std::string text = error.what();
    throw InputError(text.starts_with(path) ? text : path + ": " + text);
  }
}

}  // namespace tessera
