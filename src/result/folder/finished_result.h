// What a folder already holds, compared with what a job would give.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "checkpoint/checkpoint_origin.h"
#include "job/job_file.h"
#include "result/folder/result_manifest.h"

namespace tessera {

/// A result, finished or not, whose pieces.geojson and job.toml are those that its manifest was written with. Its cards
/// and pictures may be lost: they are not needed to go on with it.
struct WholeResult {
  ResultManifest manifest;
  Job job;
  bool drawn = false;  // collage.svg and collage.png are there, of any width, as every result gets them
};

/// Throws InputError that names the file that is missing or differs, also where this version of the program cannot read
/// the job; where a run is at work in the folder, that is said instead. Throws EnvironmentError where a file is there
/// and cannot be read. All who ask for a result ask here, so
/// that none takes for one what another refuses.
WholeResult read_result(const std::string& dir);

/// What a run finds in its folder.
struct EarlierResult {
  std::string folder;
  std::optional<WholeResult> whole;
  std::string damage;  // why a folder that has a manifest holds no whole result

  /// Nothing is left to compute.
  bool finished() const { return whole && whole->manifest.finished; }
};

/// Throws EnvironmentError where a file is there and cannot be read: nobody knows then what would be replaced.
EarlierResult find_earlier_result(const std::string& dir);

/// Whether this is the finished result of `job`. Throws InputError with the keys that differ where it is that of
/// another job, finished or not, which would be lost.
bool is_finished_result_of(const EarlierResult& earlier, const Job& job);

/// Throws InputError where the finished result is one of another job, library or canvas than `now`, or began from a
/// result with another digest than `start_digest` (StartSpec::digest).
void check_finished_result(const EarlierResult& earlier, const CheckpointOrigin& now, std::uint64_t start_digest);

/// "; KEY: then A, now B" for each key that makes the result of `now` another one than that of `then`. Empty where they
/// are the same.
std::string result_differences(const Job& then, const Job& now);

}  // namespace tessera
