// Compares the result that a folder holds with the result that a job would make.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "checkpoint/checkpoint_origin.h"
#include "job/job_file.h"
#include "result/folder/result_manifest.h"

namespace tessera {

/// A result, finished or not, whose pieces.geojson and job.toml are the files that its manifest was written with. Its cards
/// and pictures may be missing, because nobody needs them to go on.
struct WholeResult {
  ResultManifest manifest;
  Job job;
  bool drawn = false;  // collage.svg and collage.png are there, of any width, like in every result
};

/// Reads a result. Throws InputError that names the file that is missing or differs, also where this version of the program
/// cannot read the job. Where a run is at work in the folder, the message says that instead. Throws EnvironmentError where
/// a file is there and cannot be read. All code that reads a result uses this function, so that all accept the same
/// results.
WholeResult read_result(const std::string& dir);

/// The earlier result that a run finds in its folder.
struct EarlierResult {
  std::string folder;
  std::optional<WholeResult> whole;
  std::string damage;  // why a folder with a manifest holds no whole result

  /// Whether nothing is left to compute.
  bool finished() const { return whole && whole->manifest.finished; }
};

/// Finds the result in a folder. Throws EnvironmentError where a file is there and cannot be read: then nobody knows what a
/// run would replace.
EarlierResult find_earlier_result(const std::string& dir);

/// Whether this is the finished result of `job`. Throws InputError with the keys that differ where it is the result of
/// another job, finished or not, which would be lost.
bool is_finished_result_of(const EarlierResult& earlier, const Job& job);

/// Throws InputError where the finished result belongs to another job, library or canvas than `now`, or began with a result
/// of another digest than `start_digest` (StartSpec::digest).
void check_finished_result(const EarlierResult& earlier, const CheckpointOrigin& now, std::uint64_t start_digest);

/// "; KEY: then A, now B" for each key whose change from `then` to `now` changes the result. Empty where they are the same.
std::string result_differences(const Job& then, const Job& now);

}  // namespace tessera
