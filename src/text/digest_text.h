// Digests (core/base/digest.h) as files and messages show them.
#pragma once

#include <cstdint>
#include <string>

namespace tessera {

/// The digest as 16 hexadecimal digits.
std::string digest_text(std::uint64_t digest);

/// The digest of 16 hexadecimal digits. Throws InputError for any other text.
std::uint64_t digest_of_text(const std::string& text);

}  // namespace tessera
