// A digest: a number that tells whether many bytes are the same as before. It is not safe against forgery.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

#include "core/base/portable_math.h"

namespace tessera {

/// Each word passes a bijection of 64 bits, so a change within one word always changes the digest.
class Digest {
 public:
  void add(std::uint64_t word) { value_ = mix_bits(value_ ^ word); }

  /// Adds the number of bytes, then the bytes; the last word is padded with zeros.
  template <class T>
  void add_all(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    const char* bytes = reinterpret_cast<const char*>(values.data());
    std::size_t left = values.size_bytes();
    add(left);
    for (std::uint64_t word = 0; left > 0; word = 0) {
      const std::size_t part = left < sizeof word ? left : sizeof word;
      std::memcpy(&word, bytes, part);
      add(word);
      bytes += part;
      left -= part;
    }
  }

  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0;
};

}  // namespace tessera
