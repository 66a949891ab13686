// Deforms the pieces of a finished collage as its job wishes, and takes up again what an earlier run deformed.
#pragma once

#include <functional>
#include <string>

#include "core/base/stop.h"
#include "core/settings/settings.h"
#include "result/collage_files.h"

namespace tessera {

/// Gives each piece the shape that it is deformed to (CollageReport::deformed), as the settings wish. The shapes have
/// outline and field, and placements are the exact ones.
void deform_pieces(CollageReport& report, const CollageSettings& settings);

/// The same from what pieces.geojson in `dir` says, whose polygons are those of the placements' shapes, point by point.
/// Throws InputError where they are not. Before each piece `check_stop` is called, from any thread, and may throw.
void take_up_deformed_pieces(const std::string& dir, CollageReport& report, const StopCheck& check_stop = never_stop);

}  // namespace tessera
