// The tables of a job file that may occur several times ([[shapes]], [[regions]]): docs/job-format.md lists them,
// load_job accepts them and to_toml writes them. wish_resolution.h resolves what they mean for shapes and regions.
#pragma once

#include <string>
#include <vector>

#include "job/job_keys.h"

namespace tessera {

/// A table. Its columns are keys without get and set; `required` ones must be in every row.
struct JobTable {
  std::string name;
  std::string meaning;
  std::vector<JobKey> columns;
};

const std::vector<JobTable>& job_tables();

/// The table of that name, or null.
const JobTable* find_job_table(const std::string& name);
const JobKey* find_column(const JobTable& table, const std::string& name);

/// The job's rows of the table of that name; empty where there are none.
const std::vector<JobRow>& rows_of(const Job& job, const std::string& table);

/// The job's rows of the table as TOML for load_job; empty where there are none.
std::string table_to_toml(const JobTable& table, const Job& job);

}  // namespace tessera
