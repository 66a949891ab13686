#include <algorithm>
#include <cmath>
#include <set>

#include "artwork/svg/svg_values.h"
#include "artwork/warping/svg_warper.h"
#include "artwork/warping/warped_path.h"
#include "text/number_text.h"

namespace tessera {
namespace {

/// Whether the value has only numbers and words, as in a style.
bool is_plain(const std::string& value) {
  return std::all_of(value.begin(), value.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == ',' || c == '-' || c == '+' || c == ' ';
  });
}

/// The affine map that moves the middles of the box's sides apart as the warp does; the path's paint moves by it.
cairo_matrix_t nearest_affine(const Warp& warp, const cv::Rect2d& box) {
  const auto image = [&](double x, double y) {
    const Vec2 p = warp.apply({float(box.x + x * box.width), float(box.y + y * box.height)});
    return cv::Point2d(p.x, p.y);
  };
  const cv::Point2d left = image(0, 0.5), right = image(1, 0.5), top = image(0.5, 0), bottom = image(0.5, 1);
  const cv::Point2d along = box.width > 0 ? (right - left) / box.width : cv::Point2d(1, 0);
  const cv::Point2d down = box.height > 0 ? (bottom - top) / box.height : cv::Point2d(0, 1);
  const cv::Point2d middle = (left + right + top + bottom) / 4;
  const cv::Point2d origin = middle - along * (box.x + box.width / 2) - down * (box.y + box.height / 2);
  return {along.x, along.y, down.x, down.y, origin.x, origin.y};
}

}  // namespace

PathSteps SvgWarper::placed(const PathSteps& page_path, const Frame& frame) {
  if (frame.in_pattern) return page_path;
  return warped_path(page_path, warp_, tolerance_, limits_.steps_left());
}

std::string SvgWarper::data_of(const PathSteps& steps, int digits) {
  std::string data = path_data(steps, digits);
  limits_.count_bytes(data.size());
  return data;
}

void SvgWarper::write_path(const xmlNode* node, const Frame& frame, XmlWriter& to) {
  Style style = svg_style(attribute(node, "style"));
  const PathSteps steps = within_page(transformed(frame.page_from_user, steps_of(node)), frame);
  if (const xmlNode* bitmap = bitmap_of_pattern(value_of(style, "fill")); bitmap && !frame.in_pattern) {
    write_bitmap_fill(node_of(local_id(style["fill"])), bitmap, steps, style, frame, to);
    style["fill"] = "none";
  }
  const std::string stroke = value_of(style, "stroke");
  const bool strokes = !stroke.empty() && stroke != "none";
  if (steps.empty() || (!strokes && value_of(style, "fill") == "none")) return;
  note_box(box_of(steps), strokes ? reach(style, frame.page_from_user) : 0, frame);
  // Widths and dashes of a stroke are those in the path's own frame.
  cairo_matrix_t path_from_page = frame.page_from_user;
  if (strokes && cairo_matrix_invert(&path_from_page) != CAIRO_STATUS_SUCCESS) return;
  const cairo_matrix_t out_from_page = strokes ? path_from_page : identity();
  to.start("path");
  if (strokes) to.attribute("transform", svg_text(frame.page_from_user));
  to.attribute("d", data_of(transformed(out_from_page, placed(steps, frame)), strokes ? kFrameDigits : kPageDigits));
  const cairo_matrix_t moved = frame.in_pattern ? identity() : nearest_affine(warp_, box_of(steps));
  write_style(style, product(out_from_page, product(moved, frame.page_from_user)), frame, to);
  to.end();
}

PathSteps SvgWarper::within_page(PathSteps steps, const Frame& frame) const {
  const std::optional<cv::Rect2d> box = frame.in_pattern ? std::nullopt : level_rectangle(steps);
  return box && holds(*box, page_, kClipSlack * unit_) ? rectangle_steps(page_) : steps;
}

double SvgWarper::reach(const Style& style, const cairo_matrix_t& m) {
  const double width =
      svg_number(value_of(style, "stroke-width")) * std::max(std::hypot(m.xx, m.yx), std::hypot(m.xy, m.yy));
  const std::string limit = value_of(style, "stroke-miterlimit");
  return width / 2 * std::max(2., limit.empty() ? 0. : svg_number(limit));
}

void SvgWarper::note_box(cv::Rect2d box, double reach, const Frame& frame) {
  if (frame.in_pattern) return;
  box = {box.x - reach, box.y - reach, box.width + 2 * reach, box.height + 2 * reach};
  leaves_page_ = leaves_page_ || !holds(page_, box, 0);
}

void SvgWarper::write_style(const Style& style, const cairo_matrix_t& out_from_path, const Frame& frame,
                            XmlWriter& to) {
  static const std::set<std::string> kKept = {"fill-rule",        "fill-opacity",      "stroke-width",
                                              "stroke-opacity",   "stroke-linecap",    "stroke-linejoin",
                                              "stroke-dasharray", "stroke-dashoffset", "stroke-miterlimit"};
  for (const auto& [name, value] : style) {
    if (name == "fill" || name == "stroke") {
      to.attribute(name, paint(value, out_from_path, frame));
    } else if (kKept.contains(name) && is_plain(value)) {
      to.attribute(name, value);
    } else {
      throw_unknown("a style", name + ":" + value);
    }
  }
}

}  // namespace tessera
