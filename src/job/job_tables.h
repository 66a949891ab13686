// The tables of a job file that may come any number of times ([[shapes]], [[regions]]): what docs/job-format.md lists,
// load_job accepts and to_toml writes. What they mean for shapes and regions is resolved by wish_resolution.h.
#pragma once

#include <string>
#include <vector>

#include "job/job_keys.h"

namespace tessera {

/// The columns are keys without get and set; `required` ones must be in every row.
struct JobTable {
  std::string name;
  std::string meaning;
  std::vector<JobKey> columns;
};

const std::vector<JobTable>& job_tables();

/// Null where there is none.
const JobTable* find_job_table(const std::string& name);
const JobKey* find_column(const JobTable& table, const std::string& name);

/// The job's rows of the table of that name; none where there are none.
const std::vector<JobRow>& rows_of(const Job& job, const std::string& table);

/// The job's rows of the table as TOML, readable by load_job; empty where there are none.
std::string table_to_toml(const JobTable& table, const Job& job);

}  // namespace tessera
