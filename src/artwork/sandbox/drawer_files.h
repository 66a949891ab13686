// Which files a drawer (drawers.h) may read. The drawings themselves come over its socket.
#pragma once

#include <string>
#include <vector>

namespace tessera {

/// What librsvg, gdk-pixbuf and fontconfig read: the system's libraries and data, those of LD_LIBRARY_PATH, fonts and
/// their configuration, and what the processors are like; never the home folder as a whole. Asks fontconfig, which
/// reads its configuration: after limit_process (drawer_sandbox.h), so that the memory which that leaves free is not on
/// top of the limit.
std::vector<std::string> files_of_decoders();

}  // namespace tessera
