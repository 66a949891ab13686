// Reads the request of a page to refine a result (RefineRequest in web/src/data.ts).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "result/marks_file.h"

namespace tessera::serve {

struct RefineRequest {
  std::string result;         // the name of the result to refine
  std::string pieces_digest;  // of the pieces that the user saw
  Marks marks;
  std::optional<std::uint64_t> seed;  // of the new filling; empty: the job's
};

/// Reads the body of a request. Throws InputError that names the key, what was found and what is allowed.
RefineRequest parse_refine_request(const std::string& body);

}  // namespace tessera::serve
