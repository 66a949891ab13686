// What the system allows this process, for messages about what failed.
#pragma once

#include <string>
#include <system_error>

#include "core/base/error.h"

namespace tessera {

/// "; limits of this process: files of 64 KiB (ulimit -f), 300 MiB of address space (ulimit -v)": those that are set of
/// the size of files, of address space and of data. Empty where none is.
std::string process_limits();

/// Where the system gives a process no thread at all.
EnvironmentError no_thread(const std::system_error& error);

}  // namespace tessera
