// One value of a job file: from TOML, checked against its key; what is allowed, in words; and back to TOML.
#pragma once

#include <toml++/toml.h>

#include <optional>
#include <string>

#include "job/job_keys.h"

namespace tessera {

/// The key's value from TOML; nothing where the node has another type than the key or lies outside its range. Colours
/// come in lower case, device indices as "0,2" whichever way they were written; paths are not touched.
std::optional<JobValue> read_job_value(const JobKey& key, const toml::node& node);

/// "0 to 500": the least and the greatest number that the key takes, without the unit. Both are allowed.
std::string range_text(const JobKey& key);

/// What the key takes, for messages and the documentation: "a number from 0 to 500 px".
std::string allowed_values(const JobKey& key);

/// The key's value in `job` as TOML, with as few digits as give the same value when read.
std::string job_value_to_toml(const JobKey& key, const Job& job);
/// A value of a table's column (job_tables.h) as TOML.
std::string cell_to_toml(const JobKey& column, const JobValue& value);

}  // namespace tessera
