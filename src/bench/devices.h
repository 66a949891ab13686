// The devices of a benchmark, for its report.
#pragma once

#include <string>

#include "bench/benchmarks.h"

namespace tessera::bench {

/// The first entries of every report: the benchmark, its setting, and the machine.
Json report_head(const std::string& benchmark, const Setting& setting);

/// The number of CPU cores or GPU multiprocessors of all devices together.
int compute_units(const std::string& devices_use);

}  // namespace tessera::bench
