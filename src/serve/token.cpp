#include "serve/token.h"

#include <sys/random.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/error.h"

namespace tessera::serve {

std::string random_token() {
  std::array<std::uint8_t, 16> bytes;
  if (::getentropy(bytes.data(), bytes.size()) != 0) {
    throw EnvironmentError("the system gives no random bytes (getentropy), which the page's address needs");
  }
  constexpr char kDigits[] = "0123456789abcdef";
  std::string token;
  for (const std::uint8_t byte : bytes) {
    token += kDigits[byte >> 4];
    token += kDigits[byte & 15];
  }
  return token;
}

bool same_token(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) different |= unsigned(a[i] ^ b[i]);
  return different == 0;
}

}  // namespace tessera::serve
