// One measured run of `tessera bench scaling`: so many workers, so many shapes, and where the time went.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/report.h"

namespace tessera::bench {

/// Workers' times are the average over the workers; all times are of the whole loop.
struct ScalingCase {
  int workers = 1;
  int asked = 1;  // of them by the master itself
  std::uint32_t shapes = 0;
  double loop_s = 0;
  double rounds = 0;
  double samples = 0;  // matched

  double objective_s = 0;  // the master's
  double merge_s = 0;
  double questions_s = 0;
  double other_s = 0;
  double ahead_s = 0;  // while the workers dock
  double waiting_s = 0;
  double master_processor_s = 0;

  double count_s = 0;  // a worker's
  double dock_s = 0;
  double refine_s = 0;
  double measure_s = 0;
  double field_s = 0;
  double messages_s = 0;
  double busiest_s = 0;  // sum over the stages of the slowest worker's time
  double processor_s = 0;
  double greatest_processor_s = 0;

  double counts = 0;  // questions
  double docks = 0;
  double refines = 0;
  double measures = 0;
  double field_messages = 0;         // to one worker
  double bytes_to_worker = 0;        // to one worker
  double field_bytes_to_worker = 0;  // of them
  double bytes_from_worker = 0;

  double serial_s() const { return loop_s - waiting_s - ahead_s; }
  /// What the loop takes where nobody else wants the cores: the processor time of the busiest worker, and the master's
  /// but for what it does while the workers dock.
  double undisturbed_s() const { return master_processor_s - ahead_s + greatest_processor_s; }
};

/// Reads section "ranks" of a card.json. Throws InputError that names the missing key.
ScalingCase scaling_case(const Json& ranks, std::uint32_t shapes, const std::string& name);

/// The cases of a report of `tessera bench scaling`. Throws InputError.
std::vector<ScalingCase> read_scaling_cases(const std::string& path);

}  // namespace tessera::bench
