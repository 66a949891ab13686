// Which files a drawer (drawers.h) can open, by Landlock.
#pragma once

#include <string>
#include <vector>

#include "artwork/protocol/drawer_layers.h"

namespace tessera {

/// From now on this process opens only what lies in `readable`, files and folders, and that for reading alone; what is
/// open stays so. A link counts as what it leads to. After limit_process (drawer_sandbox.h): it needs
/// PR_SET_NO_NEW_PRIVS. Missing where the kernel has no Landlock (before Linux 5.13, or switched off). Where the kernel
/// refuses a rule for something that is there, nothing is confined and the layer has failed, which is told: without a
/// font that it should have a drawer would make another picture and not notice.
LayerState confine_to_files(const std::vector<std::string>& readable);

}  // namespace tessera
