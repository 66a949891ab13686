// Writing to an open file.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace tessera {

inline std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Writes all bytes at the file's current position. False, with errno, where that failed; a part may be written then.
bool write_all(int file, std::span<const std::uint8_t> bytes);

}  // namespace tessera
