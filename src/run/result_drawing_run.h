// Draws a result for a command: with progress on stderr, until it is done or a signal or time limit ends it.
#pragma once

#include <functional>
#include <string>

#include "core/base/stop.h"
#include "render/result_drawing.h"
#include "result/folder/run_log.h"

namespace tessera {

/// Logs which layers around the drawers the system lacks. A layer that failed is a warning, on stderr, too.
void tell_layers(const std::string& folder, const DrawerLayers& layers, RunLog& log);

/// Draws the pictures that the result in `folder` shall have, and notes it in the run.log beside them. Prints how well the
/// pieces show colour.image from afar, unless `quiet`. A line on stderr counts pieces that are not drawn from their
/// originals. False where `shall_stop`, which any thread may call, ended it: drawing again goes on. Errors like
/// draw_result().
bool draw(const std::string& folder, const PictureRequest& request, bool quiet, StopQuestion shall_stop);

}  // namespace tessera
