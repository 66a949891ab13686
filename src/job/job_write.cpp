#include "job/job_keys.h"
#include "job/job_tables.h"
#include "job/job_value.h"

namespace tessera {

std::string to_toml(const Job& job) {
  std::string text = "# The effective job: every key with its value, defaults filled in (docs/job-format.md).\n";
  std::string section;
  for (const JobKey& key : job_keys()) {
    if (key.section != section) text += "\n[" + (section = key.section) + "]\n";
    text += key.name + " = " + job_value_to_toml(key, job) + "\n";
  }
  for (const JobTable& table : job_tables()) text += table_to_toml(table, job);
  return text;
}

}  // namespace tessera
