#include "job/pieces/shape_group.h"

#include "library/name_index.h"

namespace tessera {

std::vector<std::string> shape_groups(const Job& job, const std::vector<std::string>& names,
                                      const std::vector<std::string>& other_names) {
  std::vector<std::string> groups(names.size());
  const auto table = job.tables.find("shapes");
  if (table == job.tables.end()) return groups;
  const NameIndex index(names, other_names);
  for (const JobRow& row : table->second) {
    if (!row.contains("group")) continue;
    for (const std::string& glob : row.at("names").texts) {
      for (const std::uint32_t place : index.matching(glob)) groups[place] = row.at("group").text;
    }
  }
  return groups;
}

}  // namespace tessera
