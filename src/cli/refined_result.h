// The result that tessera refine improves: which may be, with which keys its job is run again, and what may not have
// changed since.
#pragma once

#include <string>
#include <vector>

#include "io/checkpoint/checkpoint_origin.h"
#include "io/job/job_file.h"
#include "io/result/finished_result.h"

namespace tessera::cli {

struct RefinedResult {
  std::string folder;
  io::WholeResult whole;
};

/// Throws InputError where the folder holds no finished result that is whole, or work that is unfinished;
/// EnvironmentError where a file is there and cannot be read.
RefinedResult read_refined_result(const std::string& folder);

/// The result's folder with a suffix to its name.
std::string folder_beside(const std::string& folder, const std::string& suffix);

/// Throws InputError where `out` is the result's own folder.
void check_other_folder(const RefinedResult& result, const std::string& out);

/// Throws InputError where an override says what the pieces of the result are to be, or in a word how much is improved.
void check_overrides(const std::vector<std::string>& overrides);

/// "section.key=value" for improving with a first trial that relaxes, of `trials`; 0: no more than that needs. Limits
/// that may have ended the run of the result end no relaxing, but then no pieces are added.
std::vector<std::string> relaxing_keys(const RefinedResult& result, int trials);

/// To begin with the result's pieces.
std::vector<std::string> starting_keys(const RefinedResult& result);

/// Of the job `now.job`, whose pieces were read. Throws InputError where its library, canvas or pictures are others
/// than the result was made from, and where the result does not say which pieces are locked.
void check_is_the_same_collage(const RefinedResult& result, const io::CheckpointOrigin& now);

}  // namespace tessera::cli
