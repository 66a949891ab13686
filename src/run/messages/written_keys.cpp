#include "run/messages/written_keys.h"

#include <algorithm>
#include <vector>

#include "job/job_keys.h"
#include "job/job_tables.h"
#include "job/job_value.h"
#include "job/millimetres.h"
#include "text/number_text.h"

namespace tessera {
namespace {

/// Its value in mm, to a thousandth.
std::string value_in_mm(const JobKey& key, const Job& job, double px_per_mm) {
  std::string text;
  const JobValue value = key.get(job);
  for (const double number : value.numbers) {
    if (!text.empty()) text += ", ";
    text += significant(number / px_per_mm, 5);
  }
  return value.numbers.size() == 1 ? text : "[" + text + "]";
}

}  // namespace

std::string WrittenKeys::with_value(const char* section, const char* name) const {
  const JobKey& key = *find_job_key(section, name);
  const double scale = px_per_mm(job_.canvas);
  if (scale > 0 && is_canvas_length(key)) {
    return key_in_mm(key, scale).full_name() + " (now " + value_in_mm(key, job_, scale) + ")";
  }
  return key.full_name() + " (now " + job_value_to_toml(key, job_) + ")";
}

bool WrittenKeys::is_default(const char* section, const char* name) const {
  const JobKey& key = *find_job_key(section, name);
  return key.get(job_) == key.get(Job());
}

bool WrittenKeys::has_column(const char* table, const std::string& column) const {
  const std::vector<JobRow>& rows = rows_of(job_, table);
  return std::any_of(rows.begin(), rows.end(), [&](const JobRow& row) { return row.contains(column); });
}

bool WrittenKeys::has_rows(const char* table) const { return !rows_of(job_, table).empty(); }

std::string WrittenKeys::length_text(double length_px) const {
  const double scale = px_per_mm(job_.canvas);
  return scale > 0 ? significant(length_px / scale, 3) + " mm" : significant(length_px, 3) + " px";
}

}  // namespace tessera
