// The files that a drawer (drawers.h) may read. The drawings themselves come over its socket.
#pragma once

#include <string>
#include <vector>

namespace tessera {

/// The files that librsvg, gdk-pixbuf and fontconfig read: the system's libraries and data, those of LD_LIBRARY_PATH,
/// fonts and their configuration, and descriptions of the processors; never the whole home folder. Call it after
/// limit_process (drawer_sandbox.h): fontconfig reads its configuration here, and memory that this leaves free must
/// count for the limit.
std::vector<std::string> files_of_decoders();

}  // namespace tessera
