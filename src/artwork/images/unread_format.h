// Pictures in formats that are not read, known by their first bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace tessera {

/// "gif", "pdf" and so on. Empty where the bytes are of no such format.
std::string unread_format(std::span<const std::uint8_t> bytes);

/// What is said of such a picture, whether its name or its content tells.
std::string unread_format_reason(const std::string& format);

}  // namespace tessera
