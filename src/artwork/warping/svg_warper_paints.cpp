#include "artwork/svg/svg_values.h"
#include "artwork/warping/svg_warper.h"
#include "text/number_text.h"

namespace tessera {

std::string SvgWarper::colour(const std::string& rgb, const Frame& frame) const {
  const std::string hex = hex_colour(rgb);
  return frame.in_mask ? "#ffffff" : hex;
}

std::string SvgWarper::paint(const std::string& value, const cairo_matrix_t& out_from_path, const Frame& frame) {
  if (value == "none") return value;
  const std::string id = local_id(value);
  if (id.empty()) return colour(value, frame);
  const xmlNode* node = node_of(id);
  return url(copy_of(id, "", out_from_path, frame, [&](const std::string& copy, XmlWriter& to) {
    if (name_of(node) == "pattern") return write_pattern(node, copy, out_from_path, frame, to);
    write_gradient(node, copy, out_from_path, frame, to);
  }));
}

void SvgWarper::write_gradient(const xmlNode* node, const std::string& id, const cairo_matrix_t& out_from_path,
                               const Frame& frame, XmlWriter& to) {
  const std::string name(name_of(node));
  if (name != "linearGradient" && name != "radialGradient") throw_unknown("a paint", name);
  to.start(name).attribute("id", id).attribute("gradientUnits", "userSpaceOnUse");
  for (const char* number : {"x1", "y1", "x2", "y2", "cx", "cy", "fx", "fy", "r"}) {
    const std::string text = attribute(node, number);
    if (!text.empty()) to.attribute(number, significant(svg_number(text), kFrameDigits));
  }
  const std::string spread = attribute(node, "spreadMethod");
  if (spread == "reflect" || spread == "repeat") to.attribute("spreadMethod", spread);
  const cairo_matrix_t own = svg_matrix(attribute(node, "gradientTransform"));
  to.attribute("gradientTransform", svg_text(product(out_from_path, own)));
  for (const xmlNode* stop = first_child(node); stop; stop = next_sibling(stop)) write_stop(stop, frame, to);
  to.end();
}

void SvgWarper::write_stop(const xmlNode* stop, const Frame& frame, XmlWriter& to) {
  limits_.count_element(frame.depth);
  const Style style = svg_style(attribute(stop, "style"));
  to.start("stop").attribute("offset", significant(svg_number(attribute(stop, "offset")), kFrameDigits));
  to.attribute("stop-color", colour(value_of(style, "stop-color"), frame));
  to.attribute("stop-opacity", significant(svg_number(value_of(style, "stop-opacity")), kFrameDigits));
  to.end();
}

void SvgWarper::write_pattern(const xmlNode* node, const std::string& id, const cairo_matrix_t& out_from_path,
                              const Frame& frame, XmlWriter& to) {
  to.start("pattern").attribute("id", id).attribute("patternUnits", "userSpaceOnUse");
  write_box(rectangle_of(node), to);
  const cairo_matrix_t own = svg_matrix(attribute(node, "patternTransform"));
  to.attribute("patternTransform", svg_text(product(out_from_path, own)));
  const Frame inside{
      .page_from_user = identity(), .in_mask = frame.in_mask, .in_pattern = true, .depth = frame.depth + 1};
  write_children(node, inside, to);
  to.end();
}

}  // namespace tessera
