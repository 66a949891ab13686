// Deforms the pieces of a finished collage as its job wishes, and restores the deformed pieces of an earlier run.
#pragma once

#include <functional>
#include <string>

#include "core/base/stop.h"
#include "core/settings/settings.h"
#include "result/collage_files.h"

namespace tessera {

/// Gives each piece its deformed shape (CollageReport::deformed) by the settings. The shapes must have outline and field,
/// and the placements must be the exact ones.
void deform_pieces(CollageReport& report, const CollageSettings& settings);

/// Restores the deformed pieces from pieces.geojson in `dir`. Its polygons must be those of the placements' shapes, point
/// by point, or InputError is thrown. Calls `check_stop`, which may throw, before each piece, from any thread.
void restore_deformed_pieces(const std::string& dir, CollageReport& report, const StopCheck& check_stop = never_stop);

}  // namespace tessera
