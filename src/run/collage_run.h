// tessera collage, after its arguments are read: from the job file to the files of the result. Rank 0 is the master,
// the others are workers; a single rank is both.
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
  std::string out;                        // the folder; empty = out/<name of the job file>
  std::vector<std::string> overrides;     // "section.key=value"
  bool quiet = false;                     // neither progress nor card; warnings all the same
  std::string resume;                     // "latest" or "previous": from that checkpoint; "auto": from the one that is
                                          // there, if any; empty = from the start
  bool restart = false;                   // even where there is a checkpoint
  std::optional<std::string> time_limit;  // time_limit.h; nothing = none but Slurm's
  std::shared_ptr<const RefinedResult> refined = {};  // from whose pieces it begins; null: none
};

/// Where the result goes.
std::string output_folder(const CollageArguments& arguments);

enum class CollageEnd {
  finished,
  incomplete,      // finished and drawn, but without a piece, or without some that must stand: a warning named them
  unfinished,      // a checkpoint, and the result without pictures of what is placed so far
  nothing_placed,  // a checkpoint, and the finished result of an earlier run as it was
  not_drawn,       // the collage is finished, and a signal or the time limit ended drawing
  not_begun,       // ended before the first round; what was in the folder is there still
};

/// Whether the run has nothing left to compute or to draw.
inline bool is_finished(CollageEnd end) { return end == CollageEnd::finished || end == CollageEnd::incomplete; }

/// That of a result that was finished before.
CollageEnd end_of_finished(const ResultManifest& manifest);

/// To be called on every rank. Where the end is_finished() the exit code is kDoneExitCode or kIncompleteExitCode; for
/// every other end it is to be kUnfinishedExitCode, and the caller says how to go on. Throws InputError and EnvironmentError (rank_program.h turns those of the workers into the
/// master's). A worker leaves by JobEnded.
CollageEnd run_collage(const CollageArguments& arguments, comm::Communicator& ranks);

}  // namespace tessera
