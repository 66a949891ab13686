// One "key = value" of a job file or of --set: its check against the table of keys, and all messages about mistakes.
#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <functional>
#include <string>

#include "job/job_tables.h"

namespace tessera {

struct JobEntry {
  std::string section;  // empty = top level
  std::string name;
  const toml::node* value;
  std::string where;           // start of every message about the entry: "job.toml:12" or "--set a.b=c"
  std::filesystem::path base;  // folder for a relative path
};

/// Parses "[1, 2]" as TOML, under the name "value". A text that is not one TOML value is taken as a string: a path, a
/// colour, "0,2".
toml::table parse_value(const std::string& text);
/// Part of a message, behind the names of the same length in px and in mm.
inline constexpr const char* kBothAreGiven = ": both are given; allowed: one of them";

/// The px column of a table for a column name in mm; null where `name` is no such name.
const JobKey* length_in_mm(const JobTable& table, const std::string& name);

/// Whether the entry gives a length of the canvas in mm (millimetres.h). Such an entry needs the canvas' size in px and
/// mm.
bool is_length_in_mm(const JobEntry& entry);

/// Sets the key in `job`. Throws InputError for an unknown section or key, with the nearest name, or for a wrong value,
/// with what was found and what is allowed.
void apply_entry(const JobEntry& entry, Job& job);

/// Adds a row to the job's table. `where`: the place of a value in the file, for messages. Throws InputError as
/// apply_entry does, also where a value is missing.
void add_row(const JobTable& table, const toml::table& row, const std::function<std::string(const toml::node&)>& where,
             Job& job);

bool is_job_section(const std::string& name);

/// The text for messages: without control characters, cut to `max_bytes`.
std::string printable(std::string text, std::size_t max_bytes = 60);

}  // namespace tessera
