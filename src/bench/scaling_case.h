// One measured run of `tessera bench scaling`: its workers and shapes, and how the time was spent.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/report.h"

namespace tessera::bench {

/// Times of the whole loop; those of workers are averages over the workers.
struct ScalingCase {
  int workers = 1;
  int asked = 1;  // workers that the master asks itself
  std::uint32_t shapes = 0;
  double loop_s = 0;
  double rounds = 0;
  double pieces = 0;
  double samples = 0;  // number of matched samples

  double objective_s = 0;  // of the master, up to master_processor_s
  double merge_s = 0;
  double questions_s = 0;
  double other_s = 0;
  double ahead_s = 0;  // work while the workers dock
  double waiting_s = 0;
  double master_processor_s = 0;

  double count_s = 0;  // of a worker, up to greatest_processor_s
  double dock_s = 0;
  double refine_s = 0;
  double measure_s = 0;
  double field_s = 0;
  double messages_s = 0;
  double busiest_s = 0;  // sum over the stages of the slowest worker's time
  double processor_s = 0;
  double greatest_processor_s = 0;

  double counts = 0;  // number of requests
  double docks = 0;
  double refines = 0;
  double measures = 0;
  double field_messages = 0;         // to one worker
  double bytes_to_worker = 0;        // to one worker
  double field_bytes_to_worker = 0;  // part of these
  double bytes_from_worker = 0;

  double serial_s() const { return loop_s - waiting_s - ahead_s; }
  /// The loop's time if no other program needs the cores: the processor time of the busiest worker and of the master,
  /// without the master's work while the workers dock.
  double undisturbed_s() const { return master_processor_s - ahead_s + greatest_processor_s; }
};

/// Reads section "ranks" of a card.json, to which `pieces` was added. Throws InputError that names the missing key.
ScalingCase scaling_case(const Json& ranks, std::uint32_t shapes, const std::string& name);

/// Reads the cases in a report of `tessera bench scaling`. Throws InputError.
std::vector<ScalingCase> read_scaling_cases(const std::string& path);

}  // namespace tessera::bench
