// Tests that the user who has made a connection is found.
#include <arpa/inet.h>
#include <gtest/gtest.h>

#include <sstream>

#include "serve/own_peer.h"

namespace tessera::serve {
namespace test_own_peer {

// Lines as Linux writes them.
constexpr const char* kConnections =
    "  sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid  timeout inode\n"
    "   0: 0100007F:AE97 00000000:0000 0A 00000000:00000000 00:00000000 00000000  1000        0 123 1 0000 100 0 0 10 "
    "0\n"
    "   1: 0100007F:AE97 0100007F:D431 01 00000000:00000000 00:00000000 00000000  1000        0 124 1 0000 20 4 0 10 "
    "-1\n"
    "   2: 0100007F:D431 0100007F:AE97 01 00000000:00000000 00:00000000 00000000  1001        0 125 1 0000 20 4 0 10 "
    "-1\n"
    "   3: 0200007F:D431 0100007F:AE97 01 00000000:00000000 00:00000000 00000000  1002        0 126 1 0000 20 4 0 10 "
    "-1\n";

sockaddr_in peer(const char* address, int port) {
  sockaddr_in peer = {};
  peer.sin_family = AF_INET;
  peer.sin_port = htons(std::uint16_t(port));
  ::inet_pton(AF_INET, address, &peer.sin_addr);
  return peer;
}

std::optional<uid_t> user(const sockaddr_in& peer, int port, const std::string& text = kConnections) {
  std::istringstream connections(text);
  return user_of_peer(connections, peer, port);
}

TEST(OwnPeer, is_the_user_of_the_other_end) {
  EXPECT_EQ(user(peer("127.0.0.1", 0xD431), 0xAE97), 1001u);
  EXPECT_EQ(user(peer("127.0.0.2", 0xD431), 0xAE97), 1002u);
}

TEST(OwnPeer, is_unknown_where_no_such_connection_stands) {
  EXPECT_EQ(user(peer("127.0.0.1", 0xD432), 0xAE97), std::nullopt);
  EXPECT_EQ(user(peer("127.0.0.1", 0xD431), 0xAE98), std::nullopt);
  EXPECT_EQ(user(peer("127.0.0.1", 0xD431), 0xAE97, ""), std::nullopt);
  EXPECT_EQ(user(peer("127.0.0.1", 0xD431), 0xAE97, "heads\n garbage"), std::nullopt);
}

}  // namespace test_own_peer
}  // namespace tessera::serve
