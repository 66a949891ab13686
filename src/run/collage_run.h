// tessera collage, after its arguments are read: makes the files of the result from the job file. Rank 0 is the master, the
// others are workers; a single rank is both.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "comm/communicator.h"
#include "result/folder/result_manifest.h"
#include "run/refined_result.h"
#include "terminal/exit_codes.h"

namespace tessera {

struct CollageArguments {
  std::string job;                        // the file
  std::string out;                        // the folder; empty: out/<name of the job file>
  std::vector<std::string> overrides;     // "section.key=value"
  bool quiet = false;                     // neither progress nor card, only warnings
  std::string resume;                     // "latest" or "previous": from that checkpoint; "auto": from the one that is
                                          // there, if any; empty = from the start
  bool restart = false;                   // start again even where there is a checkpoint
  bool early = false;                     // also write the pieces once the canvas is filled (early_result.h)
  std::optional<std::string> time_limit;  // time_limit.h; empty: none but Slurm's
  std::shared_ptr<const RefinedResult> refined = {};  // the result whose pieces it begins with; null: none
};

/// The folder of the result.
std::string output_folder(const CollageArguments& arguments);

enum class CollageEnd {
  finished,
  incomplete,      // finished and drawn, but empty or without pieces that must stand; a warning names them
  unfinished,      // a checkpoint, and a result without pictures, of the pieces so far
  nothing_placed,  // a checkpoint; the finished result of an earlier run is unchanged
  not_drawn,       // finished, but a signal or the time limit ended drawing
  not_begun,       // ended before the first round; the folder is unchanged
};

/// Whether the run has nothing left to compute or to draw.
inline bool is_finished(CollageEnd end) { return end == CollageEnd::finished || end == CollageEnd::incomplete; }

/// The end of a run whose result was finished before.
CollageEnd end_of_finished(const ResultManifest& manifest);

/// To be called on every rank. Where the end is_finished(), the exit code is kDoneExitCode or kIncompleteExitCode. For
/// every other end it is kUnfinishedExitCode, and the caller says how to go on. Throws InputError and EnvironmentError;
/// rank_program.h passes errors of workers on to the master. A worker leaves by JobEnded.
CollageEnd run_collage(const CollageArguments& arguments, comm::Communicator& ranks);

}  // namespace tessera
