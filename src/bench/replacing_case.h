// One measured batch of replacement trials: the master's time, the sizes of requests, and the times of the trials.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/report.h"

namespace tessera::bench {

struct MeasuredWindow {
  std::uint32_t trials = 0;
  double work_s = 0;  // processor time
  double request_bytes = 0;
  double reply_bytes = 0;
};

struct ReplacingCase {
  int canvas_px = 0;
  std::size_t pieces = 0;
  double master_s = 0;   // cutting the batch into windows and joining outcomes, while the workers wait
  double request_s = 0;  // packing a window, by the sender
  double unpack_s = 0;   // unpacking a window, by the receiver
  double reply_s = 0;    // packing an outcome, or unpacking it
  std::vector<MeasuredWindow> windows;

  std::uint64_t trials() const;
  double work_s() const;
};

Json to_json(const ReplacingCase& c);

/// Reads a report of `tessera bench replacing`. Throws InputError.
ReplacingCase read_replacing_case(const std::string& path);

}  // namespace tessera::bench
