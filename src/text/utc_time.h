// Times as they stand in records.
#pragma once

#include <ctime>
#include <string>

namespace tessera {

/// ISO 8601, to the second: "2026-11-21T22:53:07Z".
std::string utc_text(std::time_t time);

/// The same for this moment.
inline std::string utc_now() { return utc_text(std::time(nullptr)); }

}  // namespace tessera
