#include "cli/key_text.h"

#include "io/job/job_keys.h"
#include "io/job/job_value.h"
#include "io/job/millimetres.h"
#include "io/number_text.h"

namespace tessera::cli {
namespace {

/// Its value in mm, to a thousandth.
std::string value_in_mm(const io::JobKey& key, const io::Job& job, double px_per_mm) {
  std::string text;
  const io::JobValue value = key.get(job);
  for (const double number : value.numbers) {
    if (!text.empty()) text += ", ";
    text += io::significant(number / px_per_mm, 5);
  }
  return value.numbers.size() == 1 ? text : "[" + text + "]";
}

}  // namespace

std::string with_value(const io::Job& job, const char* section, const char* name) {
  const io::JobKey& key = *io::find_job_key(section, name);
  const double px_per_mm = io::px_per_mm(job.canvas);
  if (px_per_mm > 0 && io::is_canvas_length(key)) {
    return io::key_in_mm(key, px_per_mm).full_name() + " (now " + value_in_mm(key, job, px_per_mm) + ")";
  }
  return key.full_name() + " (now " + io::job_value_to_toml(key, job) + ")";
}

bool is_default(const io::Job& job, const char* section, const char* name) {
  const io::JobKey& key = *io::find_job_key(section, name);
  return key.get(job) == key.get(io::Job());
}

std::string length_text(const io::Job& job, double length_px) {
  const double px_per_mm = io::px_per_mm(job.canvas);
  return px_per_mm > 0 ? io::significant(length_px / px_per_mm, 3) + " mm" : io::significant(length_px, 3) + " px";
}

}  // namespace tessera::cli
