// Checks whether a name still belongs to an open file, in a folder that others may write to.
#pragma once

#include <sys/types.h>

#include <string>

#include "files/file_descriptor.h"

namespace tessera {

/// Permissions of a new file, before the user's umask.
inline constexpr mode_t kNewFileMode = 0666;

/// Whether the name still belongs to the open file: somebody may have removed or replaced it. Links are not followed.
/// `folder`: a descriptor, or AT_FDCWD for the current folder.
bool leads_to(int folder, const std::string& name, const FileDescriptor& file);

}  // namespace tessera
