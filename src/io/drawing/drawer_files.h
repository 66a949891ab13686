// Which files a drawer (drawers.h) may read. The drawings themselves come over its socket.
#pragma once

#include <string>
#include <vector>

namespace tessera::io {

/// What librsvg, gdk-pixbuf and fontconfig read: the system's libraries and data, fonts and their configuration, and
/// what the processors are like. Asks fontconfig, which reads its configuration: after limit_process
/// (drawer_sandbox.h), so that the memory which that leaves free is not on top of the limit.
std::vector<std::string> files_of_decoders();

/// From now on this process opens only what lies in `readable`, files and folders, and that for reading alone; what is
/// open stays so. A link counts as what it leads to. False where the kernel has no Landlock (before Linux 5.13, or
/// switched off), which loses this layer only. After limit_process, too: it needs PR_SET_NO_NEW_PRIVS.
bool confine_to_files(const std::vector<std::string>& readable);

}  // namespace tessera::io
