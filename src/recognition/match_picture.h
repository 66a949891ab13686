// The picture of matches: both sets of curves with the parts that follow one another in colour, and B laid onto A.
#pragma once

#include <string>
#include <vector>

#include "core/recognition/curve_match.h"

namespace tessera {

/// An SVG with a row for each match. Parts that belong together have the same colour.
std::string match_picture(const std::vector<Curve>& a, const std::vector<Curve>& b,
                          const std::vector<CurveMatch>& matches);

}  // namespace tessera
