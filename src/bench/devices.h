// The devices that a benchmark ran on, as they stand in its report.
#pragma once

#include <string>

#include "bench/report.h"

namespace tessera::bench {

/// Their names.
Json device_names(const std::string& devices_use);

/// Cores of a CPU, multiprocessors of a GPU, of all devices together.
int compute_units(const std::string& devices_use);

}  // namespace tessera::bench
