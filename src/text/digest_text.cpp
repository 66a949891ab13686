#include "text/digest_text.h"

#include <charconv>
#include <cinttypes>
#include <cstdio>

#include "core/base/error.h"

namespace tessera {

std::string digest_text(std::uint64_t digest) {
  char text[17];
  std::snprintf(text, sizeof text, "%016" PRIx64, digest);
  return text;
}

std::uint64_t digest_of_text(const std::string& text) {
  std::uint64_t digest = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, digest, 16);
  if (error != std::errc() || at != end) throw InputError("\"" + text + "\" is no digest");
  return digest;
}

}  // namespace tessera
