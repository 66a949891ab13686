// The texts of `tessera keys` about the keys of a job. They come from the tables by which the program reads jobs (job_keys.h,
// job_tables.h): lines for a terminal, or Markdown for docs/reference/job-keys.md.
#pragma once

#include <string>

namespace tessera {

enum class ReferenceForm { text, markdown };

/// `name` is a table ("pieces", "shapes"), a key ("seed", "pieces.scale_px"), or empty for all tables. A table's name may
/// stand in its brackets. The text ends with a line end. Throws InputError where a job has neither such a table nor such
/// a key.
std::string key_reference(const std::string& name, ReferenceForm form);

}  // namespace tessera
