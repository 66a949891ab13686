// Decompression of data that may be a decompression bomb.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tessera {

bool is_gzip(std::span<const std::uint8_t> bytes);

/// The decompressed bytes. Throws InputError, which names `path`, where the data are damaged or would become more than
/// `limit_bytes`.
std::vector<std::uint8_t> gunzip(std::span<const std::uint8_t> bytes, const std::string& path, std::size_t limit_bytes);

}  // namespace tessera
