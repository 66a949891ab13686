#include "io/job/job_difference.h"

#include "io/job/job_tables.h"
#include "io/job/job_value.h"

namespace tessera::io {

namespace {

/// The rows without the columns that do not count.
std::string rows_text(JobTable table, const Job& job, const std::function<bool(const JobKey&)>& counts) {
  std::erase_if(table.columns, [&](const JobKey& column) { return !counts(column); });
  return table_to_toml(table, job);
}

}  // namespace

std::string job_differences(const Job& then, const Job& now, const std::function<bool(const JobKey&)>& counts) {
  std::string text;
  for (const JobKey& key : job_keys()) {
    if (!counts(key) || key.get(then) == key.get(now)) continue;
    text += "; " + key.full_name() + ": then " + job_value_to_toml(key, then) + ", now " + job_value_to_toml(key, now);
  }
  for (const JobTable& table : job_tables()) {
    if (rows_text(table, then, counts) != rows_text(table, now, counts))
      text += "; [[" + table.name + "]]: others than then";
  }
  return text;
}

}  // namespace tessera::io
