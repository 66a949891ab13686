// The limits that the system sets for this process, for error messages.
#pragma once

#include <string>
#include <system_error>

#include "core/base/error.h"

namespace tessera {

/// The limits that are set of file size, address space and data. Example: "; limits of this process: files of 64 KiB
/// (ulimit -f), 300 MiB of address space (ulimit -v)". Empty if none is set.
std::string process_limits();

/// The error for a system that gives the process no thread at all.
EnvironmentError no_thread(const std::system_error& error);

}  // namespace tessera
