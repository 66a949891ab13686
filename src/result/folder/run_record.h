// What made a result: the program, the machines, the input. It stands in card.json and in the run log, nowhere else:
// command lines and paths may say more than their owner wants to hand on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/ranks/rank_site.h"

namespace tessera {

/// The record of one run of the program; a collage that was interrupted is made by several, and the last one's record
/// is kept.
struct RunRecord {
  std::string version;
  std::string commit;
  std::string command_line;  // quoted for a shell
  std::string job_file;
  std::string library_file;
  std::uint64_t library_digest = 0;  // of its content
  std::string started_utc;           // utc_time.h
  std::string ended_utc;             // when the placements were complete; empty before
  std::string resumed_from;          // the checkpoint's file; empty: from the start
  std::uint64_t resumed_pieces = 0;  // that it had
  std::vector<RankSite> ranks;
  std::vector<std::string> warnings;
};

/// "gpu "NAME" of PLATFORM, driver VERSION", several with ", " between them; "no devices".
std::string devices_text(const std::vector<DeviceDescription>& devices);

}  // namespace tessera
