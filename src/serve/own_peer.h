// Finds out which user of this machine has made a connection.
#pragma once

#include <netinet/in.h>
#include <sys/types.h>

#include <istream>
#include <optional>

namespace tessera::serve {

/// The user who made a connection from the loopback address `peer` to our `port`. `connections`: the text of
/// /proc/net/tcp. Empty where the connection does not stand there.
std::optional<uid_t> user_of_peer(std::istream& connections, const sockaddr_in& peer, int port);

/// Whether the other end belongs to the user of this process or to root. True where the system does not tell.
bool is_own_peer(const sockaddr_in& peer, int port);

}  // namespace tessera::serve
