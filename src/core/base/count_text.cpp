#include "core/base/count_text.h"

namespace tessera {

std::string by_count(std::size_t count, std::string_view one, std::string_view several) {
  return std::string(count == 1 ? one : several);
}

std::string count_text(std::size_t count, std::string_view one, std::string_view several) {
  const std::string plural = several.empty() ? std::string(one) + "s" : std::string(several);
  return std::to_string(count) + " " + by_count(count, one, plural);
}

}  // namespace tessera
