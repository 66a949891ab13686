// The data of an SVG path, and an SVG's transforms.
#pragma once

#include <string_view>
#include <vector>

#include "products/nesting/layout/nest_polygon.h"

namespace tessera {

/// (x, y) becomes (a x + c y + e, b x + d y + f).
struct SvgMatrix {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  NestPoint apply(NestPoint p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  /// First `inner`, then this.
  SvgMatrix after(const SvgMatrix& inner) const;
  /// By how much it enlarges at most, about.
  double scale() const;
};

/// Throws InputError where it is no list of transforms.
SvgMatrix svg_transform(std::string_view text);

struct SvgSubpath {
  NestRing points;  // mm
  bool closed = false;
};

/// All commands of SVG 1.1, flattened in mm. Throws InputError where it is no path data, or has too many points.
std::vector<SvgSubpath> svg_subpaths(std::string_view data, const SvgMatrix& mm_from_path);

/// The numbers of a list, separated by white space or commas. Throws InputError.
std::vector<double> svg_numbers(std::string_view text);

}  // namespace tessera
