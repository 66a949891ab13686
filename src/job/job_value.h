// One value of a job file: read from TOML and checked against its key, described in words, and written back to TOML.
#pragma once

#include <toml++/toml.h>

#include <optional>
#include <string>

#include "job/job_keys.h"

namespace tessera {

/// The key's value from TOML; nullopt where the node has another type than the key or lies outside its range. Colours
/// become lower case, device indices "0,2" however they were written; paths stay as they are.
std::optional<JobValue> read_job_value(const JobKey& key, const toml::node& node);

/// The range of the key's numbers without the unit: "0 to 500". Both ends are allowed.
std::string range_text(const JobKey& key);

/// The allowed values of the key, for messages and the documentation: "a number from 0 to 500 px".
std::string allowed_values(const JobKey& key);

/// The key's value in `job` as TOML, with the fewest digits that give the same value when read.
std::string job_value_to_toml(const JobKey& key, const Job& job);
/// A value of a table's column (job_tables.h) as TOML.
std::string cell_to_toml(const JobKey& column, const JobValue& value);

}  // namespace tessera
