// The table of keys: its defaults are allowed, its documentation is complete, and misspelt names get a suggestion.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <sstream>

#include "job/job_file.h"
#include "job/job_tables.h"
#include "job/job_value.h"
#include "text/nearest_name.h"

namespace tessera {
namespace test_job_keys {

TEST(JobKeys, defaults_are_allowed) {
  for (const JobKey& key : job_keys()) {
    const toml::table table = toml::parse("value = " + job_value_to_toml(key, Job()));
    const auto value = read_job_value(key, *table.get("value"));
    ASSERT_TRUE(value.has_value()) << key.full_name();
    Job job;
    key.set(job, *value);
    EXPECT_EQ(key.get(job), key.get(Job())) << key.full_name();
  }
}

/// The part of docs/job-format.md under "### [section]".
std::string documented_section(const std::string& section) {
  std::ifstream file(std::string(TESSERA_SOURCE_DIR) + "/docs/job-format.md");
  std::stringstream text;
  text << file.rdbuf();
  const std::string all = text.str();
  const auto begin = all.find(section.empty() ? "### Top level\n" : "### [" + section + "]\n");
  if (begin == std::string::npos) return {};
  return all.substr(begin, all.find("\n### ", begin) - begin);
}

TEST(JobKeys, documentation_has_every_key_with_unit_default_and_range) {
  for (const JobKey& key : job_keys()) {
    std::string row = "| `";
    row.append(key.name).append("` | ").append(key.unit).append(" | ");
    row.append(key.required ? "required" : "`" + job_value_to_toml(key, Job()) + "`");
    row.append(" | ").append(allowed_values(key)).append(" | ").append(key.meaning).append(" |\n");
    EXPECT_NE(documented_section(key.section).find(row), std::string::npos) << "docs/job-format.md lacks: " << row;
  }
}

TEST(JobKeys, documentation_has_every_table_with_its_columns) {
  for (const JobTable& table : job_tables()) {
    const std::string section = documented_section("[" + table.name + "]");
    EXPECT_NE(section.find(table.meaning), std::string::npos) << "[[" << table.name << "]]";
    for (const JobKey& column : table.columns) {
      std::string row = "| `";
      row.append(column.name).append("` | ").append(column.unit).append(" | ").append(column.required ? "yes" : "");
      row.append(" | ").append(allowed_values(column)).append(" | ").append(column.meaning).append(" |\n");
      EXPECT_NE(section.find(row), std::string::npos) << "docs/job-format.md lacks: " << row;
    }
  }
}

TEST(NearestName, is_the_least_edited_one_or_none) {
  EXPECT_EQ(nearest_name("scal_px", {"uses", "scale_px", "size_px"}), "scale_px");
  EXPECT_EQ(nearest_name("xyz", {"uses", "scale_px"}), "");
  EXPECT_EQ(nearest_name("", {"uses"}), "");
  EXPECT_EQ(nearest_name(std::string(1000000, 'a'), {"uses"}), "");
}

RC_GTEST_PROP(NearestName, edit_distance_is_a_metric, ()) {
  const auto word = rc::gen::container<std::string>(rc::gen::element('a', 'b'));
  const auto a = *word, b = *word, c = *word;
  RC_ASSERT(edit_distance(a, b) == edit_distance(b, a));
  RC_ASSERT((edit_distance(a, b) == 0) == (a == b));
  RC_ASSERT(edit_distance(a, c) <= edit_distance(a, b) + edit_distance(b, c));
}

}  // namespace test_job_keys
}  // namespace tessera
