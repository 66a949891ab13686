// Recognises pictures in formats that are not supported, by their first bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace tessera {

/// "gif", "pdf" and so on; empty where the bytes are of no such format.
std::string unread_format(std::span<const std::uint8_t> bytes);

/// The message for such a picture, whether its name or its content shows the format.
std::string unread_format_reason(const std::string& format);

}  // namespace tessera
