// Keys of a job as messages name them, each with the value that the job has.
#pragma once

#include <string>

#include "job/job_file.h"

namespace tessera {

/// "pieces.scale_px (now [20, 160])"; in mm where the canvas has a size on paper: "pieces.scale_mm (now [8, 60])".
std::string with_value(const Job& job, const char* section, const char* name);

/// Whether the job has the key's default.
bool is_default(const Job& job, const char* section, const char* name);

/// "41 px", or "10.4 mm" where the canvas has a size on paper.
std::string length_text(const Job& job, double length_px);

}  // namespace tessera
