// The devices that a benchmark ran on, as they stand in its report.
#pragma once

#include <string>

#include "bench/benchmarks.h"

namespace tessera::bench {

/// What every report begins with: which benchmark, how, where.
Json report_head(const std::string& benchmark, const Setting& setting);

/// Cores of a CPU, multiprocessors of a GPU, of all devices together.
int compute_units(const std::string& devices_use);

}  // namespace tessera::bench
