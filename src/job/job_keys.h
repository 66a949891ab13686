// The table of all keys of a job file: docs/job-format.md lists them, load_job accepts them and to_toml writes them. To
// add a key: a member with its default in Job (job_file.h) or core/settings/settings.h, a line in job_keys.cpp, and a
// line in docs/job-format.md (the test says which).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "job/job_file.h"

namespace tessera {

enum class JobKind {
  number,
  integer,
  flag,        // true or false
  intervals,   // one or more [min, max] of numbers, min <= max
  point,       // [x, y]
  uses,        // at most this many, or [at least, at most]
  size,        // [width, height] of whole numbers
  paper_size,  // [width, height] of numbers, or [0, 0]
  word,        // one of JobKey::words
  name,        // a text
  file,        // a text
  texts,       // a text, or a list of texts
  files,       // a list of paths
  palette,     // one of JobKey::words, a path, or a list of colours
  colour,      // "#rrggbb" or one of JobKey::words
  devices,     // "all", "cpu", "gpu" or indices
  indices,     // a list of distinct whole numbers
};

inline constexpr std::size_t kMostIntervals = 16;

struct JobKey {
  std::string section;  // empty = top level
  std::string name;
  JobKind kind;
  std::string unit;  // empty = none
  double min = 0;    // of each number; both limits are allowed values
  double max = 0;
  std::vector<std::string> words = {};
  std::string meaning = {};
  std::function<JobValue(const Job&)> get = {};
  std::function<void(Job&, const JobValue&)> set = {};
  bool required = false;     // must be given: the default is an empty text
  std::string or_list = {};  // name of a list in the same section that may be given instead, but not together
  bool decides = true;       // changes the collage; false: may differ when an interrupted run continues
  bool in_result = true;     // visible in the files of the result; false: only in its job.toml

  /// "section.name", or only the name at top level.
  std::string full_name() const { return section.empty() ? name : section + "." + name; }
};

/// The intervals from pairs of numbers; a number is `unit_per_member` times as large as in the program.
std::vector<Interval> intervals_of(const JobValue& value, double unit_per_member);

/// All keys, in the order of docs/job-format.md and to_toml.
const std::vector<JobKey>& job_keys();

/// The key, or null where there is none.
const JobKey* find_job_key(const std::string& section, const std::string& name);

/// Largest canvas in px: the fields of a larger one would take gigabytes.
inline constexpr double kMaxCanvas_px2 = 100e6;
inline constexpr int kMaxDeviceIndex = 63;
/// Most pieces in the file of start.pieces.
inline constexpr int kMostStartPieces = 100'000;

}  // namespace tessera
