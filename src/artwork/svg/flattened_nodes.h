// Reads the elements of a flattened drawing (flattened_svg.h): attributes, styles, and matrices between their frames.
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
/// The matrix that applies `inner`, then `outer`.
cairo_matrix_t product(const cairo_matrix_t& outer, const cairo_matrix_t& inner);
cairo_matrix_t translation(double x, double y);

/// The value of a property; "" where there is none.
std::string value_of(const Style& style, const std::string& name);
double number_of(const xmlNode* node, const char* name, double otherwise);
cv::Rect2d rectangle_of(const xmlNode* rect);
/// The steps of a <path> or a <rect>.
PathSteps steps_of(const xmlNode* node);

const xmlNode* first_child(const xmlNode* node);
const xmlNode* next_sibling(const xmlNode* node);
/// The only child element; null where there are none or several.
const xmlNode* only_child(const xmlNode* node);

/// Whether `inner` lies within `outer`, with a tolerance of `slack`.
bool holds(const cv::Rect2d& outer, const cv::Rect2d& inner, double slack);

/// Throws the InputError for something that cannot be deformed as vectors.
[[noreturn]] void throw_unknown(const std::string& what, std::string_view found);

}  // namespace tessera
