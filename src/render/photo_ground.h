// The background of pieces that were cut out of a photo (output.background = "photo"): round each piece lies what lies
// round it in the photo, its joint, its ground and its contact shadow.
#pragma once

#include "artwork/drawers/drawers.h"
#include "layers/ground_tile.h"
#include "render/pieces/stop_watcher.h"
#include "result/collage_files.h"

namespace tessera {

/// A tile over the whole canvas. Each place shows the photo of the nearest piece; where that shows another element, the
/// photo of the next piece that has something there; else `below`. Under a piece lies the piece itself, so that its soft
/// edge meets its own colours. It has the pixels of the picture, up to 64 megapixels. Throws InputError that names the key
/// where no placed shape has surroundings (Artwork::surroundings_png), and DrawingStopped. A damaged picture shows nothing.
GroundTile photo_ground(const CollageReport& report, const GroundTile& below, Drawers& drawers,
                        const StopWatcher& stop);

}  // namespace tessera
