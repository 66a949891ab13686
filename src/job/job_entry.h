// One "key = value" of a job file or of --set: checked against the table of keys, and all that is said about mistakes.
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
  std::string where;           // start of every message about it: "job.toml:12" or "--set a.b=c"
  std::filesystem::path base;  // what a relative path is relative to
};

/// "[1, 2]" as TOML, under the name "value"; what is not one TOML value is a string: a path, a colour, "0,2".
toml::table parse_value(const std::string& text);
/// Behind the names of a length in px and the same one in mm.
inline constexpr const char* kBothAreGiven = ": both are given; allowed: one of them";

/// The length in px that a column's name in mm stands for; null where it is no such name.
const JobKey* length_in_mm(const JobTable& table, const std::string& name);

/// Whether it gives a length of the canvas in mm (millimetres.h), which needs the canvas' size in px and mm to be
/// known.
bool is_length_in_mm(const JobEntry& entry);

/// Sets the key in `job`. Throws InputError: an unknown section or key with the nearest one, or the value found and
/// what is allowed.
void apply_entry(const JobEntry& entry, Job& job);

/// Adds a row to the job's table. `where`: of a line of the file. Throws InputError as apply_entry does, also where a
/// value is missing.
void add_row(const JobTable& table, const toml::table& row, const std::function<std::string(const toml::node&)>& where,
             Job& job);

bool is_job_section(const std::string& name);

/// The text as messages show it: without control characters, cut to `max_bytes`.
std::string printable(std::string text, std::size_t max_bytes = 60);

}  // namespace tessera
