#include "artwork/images/sha256.h"

#include <glib.h>

#include <memory>

namespace tessera {

Sha256 sha256_of(std::span<const std::uint8_t> bytes) {
  const std::unique_ptr<GChecksum, decltype(&g_checksum_free)> checksum(g_checksum_new(G_CHECKSUM_SHA256),
                                                                        g_checksum_free);
  g_checksum_update(checksum.get(), bytes.data(), gssize(bytes.size()));
  Sha256 digest{};
  gsize size = digest.size();
  g_checksum_get_digest(checksum.get(), digest.data(), &size);
  return digest;
}

}  // namespace tessera
