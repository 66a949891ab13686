// The table of all keys of a job file: what docs/job-format.md lists, load_job accepts and to_toml writes.
// To add a key: a member in Job (job_file.h) or core/settings/settings.h with its default, a line in job_keys.cpp, a line in
// docs/job-format.md (the test says which).
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
  uses,        // at most so many, or [at least, at most]
  size,        // [width, height] of whole numbers
  paper_size,  // [width, height] of numbers, or [0, 0]
  word,        // one of JobKey::words
  name,        // a text
  file,        // a path
  texts,       // a text, or a list of texts
  files,       // a list of paths
  palette,     // one of JobKey::words, a path, or a list of colours
  colour,      // "#rrggbb" or one of JobKey::words
  devices,     // "all", "cpu", "gpu", indices
  indices,     // a list of distinct whole numbers
};

inline constexpr std::size_t kMostIntervals = 16;

struct JobKey {
  std::string section;  // empty = top level
  std::string name;
  JobKind kind;
  std::string unit;  // empty = none
  double min = 0;    // of each number; both ends are allowed
  double max = 0;
  std::vector<std::string> words = {};
  std::string meaning = {};
  std::function<JobValue(const Job&)> get = {};
  std::function<void(Job&, const JobValue&)> set = {};
  bool required = false;     // the default, an empty text, will not do
  std::string or_list = {};  // a list of the same section that may be given instead, but not beside it
  bool decides = true;       // about the collage; false: may be another one when an interrupted run goes on
  bool in_result = true;     // shows in the files of the result; false: only in its job.toml

  /// "section.name", or the name alone at top level.
  std::string full_name() const { return section.empty() ? name : section + "." + name; }
};

/// Of pairs of numbers that are `unit_per_member` times as large as in the program.
std::vector<Interval> intervals_of(const JobValue& value, double unit_per_member);

/// All keys in the order in which docs/job-format.md and to_toml have them.
const std::vector<JobKey>& job_keys();

/// Null where there is none.
const JobKey* find_job_key(const std::string& section, const std::string& name);

/// A canvas of more px than this is refused: its fields alone would take gigabytes.
inline constexpr double kMaxCanvas_px2 = 100e6;
inline constexpr int kMaxDeviceIndex = 63;
/// Of the file of start.pieces.
inline constexpr int kMostStartPieces = 100'000;

}  // namespace tessera
