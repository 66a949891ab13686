// Limits the files that a drawer (drawers.h) can open, with Landlock.
#pragma once

#include <string>
#include <vector>

#include "artwork/protocol/drawer_layers.h"

namespace tessera {

/// Restricts this process from now on: it can open only files and folders in `readable`, and only for reading; open
/// files stay open. A link counts as its target. Call it after limit_process (drawer_sandbox.h), which sets the
/// required PR_SET_NO_NEW_PRIVS. Returns `missing` where the kernel has no Landlock (before Linux 5.13, or switched
/// off). Where the kernel refuses a rule for an existing file, nothing is confined and it returns `failed`: without a
/// font that it should have a drawer would silently draw another picture.
LayerState confine_to_files(const std::vector<std::string>& readable);

}  // namespace tessera
