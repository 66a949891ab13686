// Drawing a result, as a command does it: with progress on stderr, and an end by signals and time limits.
#pragma once

#include <functional>
#include <string>

#include "core/base/stop.h"
#include "render/result_drawing.h"
#include "result/folder/run_log.h"

namespace tessera {

/// Writes into the log which layers around the drawers do not hold; where one failed it is a warning, on stderr, too.
void tell_layers(const std::string& folder, const DrawerLayers& layers, RunLog& log);

/// Draws what the result in `folder` is to have, with a line in the run.log beside the pictures. Prints how well the
/// pieces show colour.image from afar, unless `quiet`; a line on stderr counts the pieces that are not drawn from their
/// originals. False where `stop` ended it (asked from any thread): drawing again goes on. Errors as draw_result.
bool draw(const std::string& folder, const PictureRequest& request, bool quiet, StopQuestion shall_stop);

}  // namespace tessera
