// The result that tessera refine improves: which may be, with which keys its job is run again, and what may not have
// changed since.
#pragma once

#include <string>
#include <vector>

#include "checkpoint/checkpoint_origin.h"
#include "job/job_file.h"
#include "result/folder/finished_result.h"
#include "result/placed_pieces.h"

namespace tessera {

struct RefinedResult {
  std::string folder;
  WholeResult whole;
  std::vector<int> erased = {};            // pieces that go
  std::vector<int> locked = {};            // that are locked from now on
  std::vector<std::string> not_anew = {};  // shapes that do not come in
  bool relaxes = false;                    // its pieces are to be relaxed; where they are not, that is told
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

/// To leave all pieces where they are and deform them, as `kind` says ("capped" or "voronoi").
std::vector<std::string> deforming_keys(const RefinedResult& result, const std::string& kind);

/// To begin with the result's pieces.
std::vector<std::string> starting_keys(const RefinedResult& result);

/// To fill the room of the pieces that go, which a limit of what is covered in all is not to prevent.
std::vector<std::string> erasing_keys();

/// Throws InputError where the result cannot say exactly where its pieces lie, or their sizes follow from all of them.
void check_can_be_erased(const RefinedResult& result, const std::vector<PlacedPiece>& all);

/// The job's pieces are those of the result, with what is said of them here: lists may be longer than an override. Throws
/// InputError where the job would be too long for its file.
Job with_pieces_of(const RefinedResult& result, Job job);

/// Of the job `now.job`, whose pieces were read. Throws InputError where its library, canvas or pictures are others
/// than the result was made from, and where the result does not say which pieces are locked.
void check_is_the_same_collage(const RefinedResult& result, const CheckpointOrigin& now,
                               const std::vector<GivenPiece>& given);

}  // namespace tessera
