// Points in time as text, for records.
#pragma once

#include <ctime>
#include <string>

namespace tessera {

/// The time in ISO 8601, to the second: "2026-11-21T22:53:07Z".
std::string utc_text(std::time_t time);

/// The present time in the same form.
inline std::string utc_now() { return utc_text(std::time(nullptr)); }

}  // namespace tessera
