#include "comm/archive.h"

#include "core/base/error.h"

namespace tessera::comm {

void refuse_message(std::size_t message_bytes) {
  throw EnvironmentError("a message of " + std::to_string(message_bytes) +
                         " bytes from another rank is damaged, or another program sent it; allowed: the same program "
                         "on all ranks; install it anew on every node");
}

}  // namespace tessera::comm
