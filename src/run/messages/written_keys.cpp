#include "run/messages/key_text.h"

#include "job/job_keys.h"
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

std::string with_value(const Job& job, const char* section, const char* name) {
  const JobKey& key = *find_job_key(section, name);
  const double scale = px_per_mm(job.canvas);
  if (scale > 0 && is_canvas_length(key)) {
    return key_in_mm(key, scale).full_name() + " (now " + value_in_mm(key, job, scale) + ")";
  }
  return key.full_name() + " (now " + job_value_to_toml(key, job) + ")";
}

bool is_default(const Job& job, const char* section, const char* name) {
  const JobKey& key = *find_job_key(section, name);
  return key.get(job) == key.get(Job());
}

std::string length_text(const Job& job, double length_px) {
  const double scale = px_per_mm(job.canvas);
  return scale > 0 ? significant(length_px / scale, 3) + " mm" : significant(length_px, 3) + " px";
}

}  // namespace tessera
