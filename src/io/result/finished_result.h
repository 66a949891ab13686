// What a folder already holds, compared with what a job would give.
#pragma once

#include <optional>
#include <string>

#include "io/checkpoint/checkpoint_origin.h"
#include "io/job/job_file.h"
#include "io/result/result_manifest.h"

namespace tessera::io {

/// The manifest of the whole result in `dir`, finished or not: pieces.geojson and job.toml are those that it was
/// written with, this version of the program reads the job, and the cards, which drawing rewrites, are there. All who
/// ask for a result ask here, so that none takes for one what another refuses. Throws InputError that names the file
/// that is missing or differs.
ResultManifest read_result(const std::string& dir);

/// Why `dir`, which has a manifest, holds no whole result. Empty where it does, and where there is no manifest.
std::string damage_of_result(const std::string& dir);

/// The job whose finished collage `dir` holds: a whole result whose manifest says that nothing is left to compute.
/// Nothing where there is none, or none that this version of the program reads.
std::optional<Job> job_of_finished_result(const std::string& dir);

/// Whether `dir` holds the finished result of `job`. Throws InputError with the keys that differ where it holds that of
/// another job, which would be lost.
bool is_finished_result_of(const std::string& dir, const Job& job);

/// Throws InputError where `dir` holds no finished collage, or one of another job, library or canvas than `now`.
void check_finished_result(const std::string& dir, const CheckpointOrigin& now);

/// Whether the result in `dir` has the pictures that every result gets: collage.svg and collage.png, of any width.
/// Throws InputError where there is no result.
bool is_drawn(const std::string& dir);

/// "; KEY: then A, now B" for each key that makes the result of `now` another one than that of `then`. Empty where they
/// are the same.
std::string result_differences(const Job& then, const Job& now);

}  // namespace tessera::io
