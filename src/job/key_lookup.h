// The tables and keys of a job by the names that a user gives on the command line.
#pragma once

#include <string>
#include <vector>

#include "job/job_keys.h"

namespace tessera {

/// A table of the job file with its keys: [pieces], the top level, or [[shapes]], which may come any number of times.
struct KeyTable {
  std::string name;      // empty = top level
  bool is_list = false;  // [[name]]
  std::string meaning;   // of a list; else empty
  std::vector<const JobKey*> keys;

  /// The heading of the table in a job file: "[pieces]", "[[shapes]]", or "Top level" for the keys before all tables.
  std::string heading() const;
};

/// All tables, those of job_keys() first.
std::vector<KeyTable> key_tables();

/// Null where there is none. The pointer is into `tables`.
const KeyTable* find_key_table(const std::vector<KeyTable>& tables, const std::string& name);

/// A key of job_keys() or a column of job_tables() by its full name, "pieces.scale_px". A length's name in mm
/// (millimetres.h) finds the length in px. Null where there is none.
const JobKey* find_full_key(const std::vector<KeyTable>& tables, const std::string& full_name);

/// Throws InputError: a job has no table and no key of that name. The message has near names and what is allowed.
[[noreturn]] void fail_unknown_name(const std::vector<KeyTable>& tables, const std::string& name);

}  // namespace tessera
