// The text for a count that exceeds its limit, if nothing is counted beyond the limit.
#pragma once

#include <cstddef>
#include <string>

namespace tessera {

/// too_many(5, "points in a file"): "found more than 5 points in a file; allowed: 5 or fewer".
inline std::string too_many(std::size_t most, const std::string& what) {
  const std::string number = std::to_string(most);
  return "found more than " + number + " " + what + "; allowed: " + number + " or fewer";
}

}  // namespace tessera
