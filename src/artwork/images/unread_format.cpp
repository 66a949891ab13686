#include "artwork/images/unread_format.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace tessera {
namespace {

struct Signature {
  std::string_view first_bytes;
  const char* format;
};

constexpr std::array<Signature, 5> kSignatures = {
    {{"GIF8", "gif"}, {"%PDF", "pdf"}, {"%!PS", "ps"}, {"8BPS", "psd"}, {"gimp xcf", "xcf"}}};

bool starts_with(std::span<const std::uint8_t> bytes, std::string_view text) {
  return bytes.size() >= text.size() && std::equal(text.begin(), text.end(), bytes.begin());
}

}  // namespace

std::string unread_format(std::span<const std::uint8_t> bytes) {
  const auto found = std::find_if(kSignatures.begin(), kSignatures.end(),
                                  [&](const Signature& s) { return starts_with(bytes, s.first_bytes); });
  return found == kSignatures.end() ? "" : found->format;
}

std::string unread_format_reason(const std::string& format) {
  return "a format that is not read; convert it to SVG or PNG: " + format;
}

}  // namespace tessera
