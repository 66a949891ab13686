// Records what made a result: program, machines, input. It is only in card.json and run.log, because command lines and
// paths may tell more than their owner wants to pass on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/ranks/rank_site.h"

namespace tessera {

/// How much of the canvas was covered after these seconds of the loop.
struct GrowthMoment {
  double seconds = 0;
  double coverage = 0;  // fraction of the canvas
};

/// The record of one run of the program. An interrupted collage is made by several runs; the record of the last one is
/// kept.
struct RunRecord {
  std::string version;
  std::string commit;
  std::string command_line;  // quoted for a shell
  std::string job_file;
  std::string library_file;
  std::uint64_t library_digest = 0;  // digest of its content
  std::string started_utc;           // utc_time.h
  std::string ended_utc;             // when the placements were complete; empty before
  std::string resumed_from;          // the checkpoint's file; empty: from the start
  std::uint64_t resumed_pieces = 0;  // number of pieces in that checkpoint
  std::vector<RankSite> ranks;
  std::vector<std::string> warnings;
  std::vector<GrowthMoment> growth;  // some hundred moments of this run at most
};

/// A list of devices with ", " between them: "gpu "NAME" of PLATFORM, driver VERSION"; "no devices".
std::string devices_text(const std::vector<DeviceDescription>& devices);

}  // namespace tessera
