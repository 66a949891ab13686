// One measured batch of replacement trials: what the master does for it, what its questions weigh, and what they take.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/report.h"

namespace tessera::bench {

struct MeasuredWindow {
  std::uint32_t trials = 0;
  double work_s = 0;  // of one core
  double request_bytes = 0;
  double reply_bytes = 0;
};

struct ReplacingCase {
  int canvas_px = 0;
  std::size_t pieces = 0;
  double master_s = 0;   // cutting the batch into windows and joining their outcomes; while nobody else works
  double request_s = 0;  // packing a window, of whoever asks
  double unpack_s = 0;   // a window, of whoever is asked
  double reply_s = 0;    // packing an outcome, or unpacking it
  std::vector<MeasuredWindow> windows;

  std::uint64_t trials() const;
  double work_s() const;
};

Json to_json(const ReplacingCase& c);

/// Of a report of `tessera bench replacing`. Throws InputError.
ReplacingCase read_replacing_case(const std::string& path);

}  // namespace tessera::bench
