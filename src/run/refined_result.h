// The result that tessera refine improves: which results it accepts, the keys with which it runs the result's job again,
// and what must not have changed since.
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
  std::vector<int> erased = {};            // numbers of the pieces to take out
  std::vector<int> locked = {};            // numbers of the pieces that are locked from now on
  std::vector<std::string> not_anew = {};  // names of shapes that must not come in
  // the user wants its pieces to be relaxed; a warning says so where they are not
  bool relaxes = false;
};

/// Throws InputError where the folder holds no whole finished result, or unfinished work; EnvironmentError where a file is
/// there and cannot be read.
RefinedResult read_refined_result(const std::string& folder);

/// The result's folder with a suffix to its name.
std::string folder_beside(const std::string& folder, const std::string& suffix);

/// Throws InputError where `out` is the result's own folder.
void check_other_folder(const RefinedResult& result, const std::string& out);

/// Throws InputError where an override sets pieces that come from the result, or the key quality.
void check_overrides(const std::vector<std::string>& overrides);

/// The keys ("section.key=value") for improving with `trials` trials, the first of which relaxes; 0: as few as relaxing
/// needs. Limits that may have ended the run of the result do not end relaxing, but then no pieces are added.
std::vector<std::string> relaxing_keys(const RefinedResult& result, int trials);

/// The keys that leave all pieces where they are and deform them; `kind`: "capped" or "voronoi".
std::vector<std::string> deforming_keys(const RefinedResult& result, const std::string& kind);

/// The keys that begin with the result's pieces.
std::vector<std::string> starting_keys(const RefinedResult& result);

/// The keys that fill the room of removed pieces. A limit of coverage must not prevent that.
std::vector<std::string> erasing_keys();

/// Throws InputError where the result does not say exactly where its pieces lie, or where the size of each depends on all
/// of them.
void check_can_be_erased(const RefinedResult& result, const std::vector<PlacedPiece>& all);

/// The job with the lists of pieces in `result`, which may be too long for overrides. Throws InputError where the job would
/// be too long for its file.
Job with_pieces_of(const RefinedResult& result, Job job);

/// Throws InputError where library, canvas or pictures of the new run (`now`) differ from those of the result, or where
/// the result does not say which pieces are locked. `given`: the pieces that the new job was given.
void check_is_the_same_collage(const RefinedResult& result, const CheckpointOrigin& now,
                               const std::vector<GivenPiece>& given);

}  // namespace tessera
