// The SHA-256 digest of a file's bytes. It proves that somebody had the file.
#pragma once

#include <cstdint>
#include <span>

#include "core/shape/shape.h"

namespace tessera {

Sha256 sha256_of(std::span<const std::uint8_t> bytes);

}  // namespace tessera
