// What the elements of a flattened drawing (flattened_svg.h) say, and the frames that they lie in.
#pragma once

#include <cairo.h>

#include <map>
#include <opencv2/core.hpp>
#include <string>
#include <string_view>

#include "artwork/svg/path_steps.h"
#include "artwork/xml/xml_tree.h"

namespace tessera {

using Style = std::map<std::string, std::string>;

cairo_matrix_t identity();
/// First `inner`, then `outer`.
cairo_matrix_t product(const cairo_matrix_t& outer, const cairo_matrix_t& inner);
cairo_matrix_t translation(double x, double y);

/// "" where there is none.
std::string value_of(const Style& style, const std::string& name);
double number_of(const xmlNode* node, const char* name, double otherwise);
cv::Rect2d rectangle_of(const xmlNode* rect);
/// Of a path or a rectangle.
PathSteps steps_of(const xmlNode* node);

const xmlNode* first_child(const xmlNode* node);
const xmlNode* next_sibling(const xmlNode* node);
/// Null where there are none or several.
const xmlNode* only_child(const xmlNode* node);

/// Whether the one lies in the other but for `slack`.
bool holds(const cv::Rect2d& outer, const cv::Rect2d& inner, double slack);

/// An InputError on what nobody knows how to deform as vectors.
[[noreturn]] void throw_unknown(const std::string& what, std::string_view found);

}  // namespace tessera
