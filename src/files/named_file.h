// An open file and its name in a folder that others may write to.
#pragma once

#include <sys/types.h>

#include <string>

#include "files/file_descriptor.h"

namespace tessera {

/// Of a file that is created, less what the user's umask takes away.
inline constexpr mode_t kNewFileMode = 0666;

/// Whether the name leads to the open file: somebody may have removed or replaced it. A link leads to itself. `folder`:
/// a descriptor, or AT_FDCWD for the current one.
bool leads_to(int folder, const std::string& name, const FileDescriptor& file);

}  // namespace tessera
