#include "artwork/svg/flattened_nodes.h"

#include "artwork/svg/svg_values.h"
#include "core/base/error.h"

namespace tessera {

cairo_matrix_t identity() { return svg_matrix(""); }

cairo_matrix_t product(const cairo_matrix_t& outer, const cairo_matrix_t& inner) {
  cairo_matrix_t both;
  cairo_matrix_multiply(&both, &inner, &outer);
  return both;
}

cairo_matrix_t translation(double x, double y) {
  cairo_matrix_t matrix;
  cairo_matrix_init_translate(&matrix, x, y);
  return matrix;
}

std::string value_of(const Style& style, const std::string& name) {
  const auto found = style.find(name);
  return found == style.end() ? "" : found->second;
}

double number_of(const xmlNode* node, const char* name, double otherwise) {
  const std::string text = attribute(node, name);
  return text.empty() ? otherwise : svg_number(text);
}

cv::Rect2d rectangle_of(const xmlNode* rect) {
  return {number_of(rect, "x", 0), number_of(rect, "y", 0), number_of(rect, "width", 0), number_of(rect, "height", 0)};
}

PathSteps steps_of(const xmlNode* node) {
  if (name_of(node) == "rect") return rectangle_steps(rectangle_of(node));
  return path_steps(attribute(node, "d"));
}

const xmlNode* first_child(const xmlNode* node) { return xmlFirstElementChild(const_cast<xmlNode*>(node)); }
const xmlNode* next_sibling(const xmlNode* node) { return xmlNextElementSibling(const_cast<xmlNode*>(node)); }
const xmlNode* only_child(const xmlNode* node) {
  const xmlNode* child = first_child(node);
  return child && !next_sibling(child) ? child : nullptr;
}

bool holds(const cv::Rect2d& outer, const cv::Rect2d& inner, double slack) {
  return inner.x >= outer.x - slack && inner.y >= outer.y - slack &&
         inner.x + inner.width <= outer.x + outer.width + slack &&
         inner.y + inner.height <= outer.y + outer.height + slack;
}

[[noreturn]] void throw_unknown(const std::string& what, std::string_view found) {
  throw InputError("cannot be deformed but as a picture: " + what + " \"" + std::string(found.substr(0, 40)) + "\"");
}

}  // namespace tessera
