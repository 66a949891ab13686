#include "run/messages/written_keys.h"

#include <algorithm>
#include <vector>

#include "core/base/count_text.h"
#include "job/job_keys.h"
#include "job/job_tables.h"
#include "job/job_value.h"
#include "job/millimetres.h"
#include "text/number_text.h"

namespace tessera {
namespace {

constexpr std::size_t kRowsTold = 3;

struct NamedValue {
  std::string name;
  std::string value;
};

/// A value as job files have it: in mm, rounded, where the canvas has a size on paper.
NamedValue as_written(const JobKey& key, JobValue value, double px_per_mm) {
  if (px_per_mm <= 0 || !is_canvas_length(key)) return {key.name, cell_to_toml(key, value)};
  for (double& number : value.numbers) number = std::stod(significant(number / px_per_mm, 5));
  const JobKey in_mm = key_in_mm(key, px_per_mm);
  return {in_mm.name, cell_to_toml(in_mm, value)};
}

/// The name of a row: the value of its table's first column, a name or patterns of names.
std::string name_of(const JobTable& table, const JobRow& row) {
  const JobValue& value = row.at(table.columns.front().name);
  if (value.texts.empty()) return '"' + value.text + '"';
  return '"' + value.texts.front() + '"' + (value.texts.size() > 1 ? ", ..." : "");
}

}  // namespace

std::string WrittenKeys::with_value(const char* section, const char* name) const {
  const JobKey& key = *find_job_key(section, name);
  const double scale = px_per_mm(job_.canvas);
  if (scale > 0 && is_canvas_length(key)) {
    const NamedValue written = as_written(key, key.get(job_), scale);
    return key.section + "." + written.name + " (now " + written.value + ")";
  }
  return key.full_name() + " (now " + job_value_to_toml(key, job_) + ")";
}

bool WrittenKeys::is_default(const char* section, const char* name) const {
  const JobKey& key = *find_job_key(section, name);
  return key.get(job_) == key.get(Job());
}

std::vector<std::uint32_t> WrittenKeys::rows_with(const char* table, const char* column) const {
  const std::vector<JobRow>& rows = rows_of(job_, table);
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < rows.size(); ++i) {
    if (rows[i].contains(column)) found.push_back(i);
  }
  return found;
}

std::string WrittenKeys::rows_with_values(const char* table_name, const char* column,
                                          const std::vector<std::uint32_t>& rows) const {
  const JobTable& table = *find_job_table(table_name);
  const JobKey& key = *find_column(table, column);
  std::string text;
  for (std::size_t i = 0; i < std::min(rows.size(), kRowsTold); ++i) {
    const JobRow& row = rows_of(job_, table_name)[rows[i]];
    const NamedValue written = as_written(key, row.at(column), px_per_mm(job_.canvas));
    text += (text.empty() ? written.name + " of [[" + table_name + "]] " : ", ") + name_of(table, row) + " (now " +
            written.value + ")";
  }
  return rows.size() > kRowsTold ? text + " and " + count_text(rows.size() - kRowsTold, "other") : text;
}

bool WrittenKeys::has_rows(const char* table) const { return !rows_of(job_, table).empty(); }

std::string WrittenKeys::length_text(double length_px) const {
  const double scale = px_per_mm(job_.canvas);
  return scale > 0 ? significant(length_px / scale, 3) + " mm" : significant(length_px, 3) + " px";
}

}  // namespace tessera
