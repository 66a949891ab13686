#include "io/job/shape_group.h"

#include <algorithm>

#include "io/library/name_globs.h"

namespace tessera::io {

std::string shape_group(const Job& job, const std::string& shape_name) {
  const auto table = job.tables.find("shapes");
  if (table == job.tables.end()) return {};
  const std::vector<JobRow>& rows = table->second;
  const auto row = std::find_if(rows.rbegin(), rows.rend(), [&](const JobRow& r) {
    return r.contains("group") && matches_any(r.at("names").texts, shape_name);
  });
  return row == rows.rend() ? std::string() : row->at("group").text;
}

}  // namespace tessera::io
