// Reads integers and texts at any place of a file in memory that may be damaged.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace tessera {

/// Reads a file in memory and never beyond its end: there it finds no text and no integer.
class ByteReader {
 public:
  ByteReader(std::span<const std::uint8_t> bytes, bool big_endian) : bytes_(bytes), big_endian_(big_endian) {}

  /// Whether `text` is at the place `at`.
  bool has(std::size_t at, std::string_view text) const {
    return at <= bytes_.size() && text.size() <= bytes_.size() - at &&
           std::equal(text.begin(), text.end(), bytes_.begin() + std::ptrdiff_t(at),
                      [](char c, std::uint8_t b) { return std::uint8_t(c) == b; });
  }

  /// The unsigned integer of `width` bytes (1 to 4) at the place `at`; nullopt where the file ends before.
  std::optional<std::uint32_t> integer(std::size_t at, int width) const {
    if (at > bytes_.size() || std::size_t(width) > bytes_.size() - at) return std::nullopt;
    std::uint32_t value = 0;
    for (int i = 0; i < width; ++i) value = value << 8 | bytes_[at + std::size_t(big_endian_ ? i : width - 1 - i)];
    return value;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  bool big_endian_;
};

}  // namespace tessera
