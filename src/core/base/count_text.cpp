#include "core/base/count_text.h"

#include <cstdio>

namespace tessera {

std::string by_count(std::size_t count, std::string_view one, std::string_view several) {
  return std::string(count == 1 ? one : several);
}

std::string count_text(std::size_t count, std::string_view one, std::string_view several) {
  const std::string plural = several.empty() ? std::string(one) + "s" : std::string(several);
  return std::to_string(count) + " " + by_count(count, one, plural);
}

std::string gigabytes(std::uint64_t bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f GB", double(bytes) * 1e-9);
  return text;
}

std::string size_text(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

}  // namespace tessera
