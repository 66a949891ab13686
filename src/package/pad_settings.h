// Checks the public PadSettings and fills in its defaults.
#pragma once

#include "tessera/matching/pad.h"

namespace tessera::matching {

/// The width of the smoothing for curves of this length, both in one unit. Throws Error where a setting is out of its
/// range.
double smoothing_of(const PadSettings& settings, double length);

}  // namespace tessera::matching
