#include "serve/own_peer.h"

#include <arpa/inet.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>

namespace tessera::serve {
namespace {

/// An address as /proc/net/tcp has it: the number of the address in the machine's order of bytes, and the port.
std::string address_text(in_addr_t address, int port) {
  char text[32];
  std::snprintf(text, sizeof text, "%08X:%04X", unsigned(address), unsigned(port));
  return text;
}

}  // namespace

std::optional<uid_t> user_of_peer(std::istream& connections, const sockaddr_in& peer, int port) {
  const std::string from = address_text(peer.sin_addr.s_addr, ntohs(peer.sin_port));
  const std::string to = address_text(htonl(INADDR_LOOPBACK), port);
  std::string line;
  std::getline(connections, line);  // the heads of the columns
  std::string number, local, remote, state, queues, timer, retransmits;
  uid_t user = 0;
  while (connections >> number >> local >> remote >> state >> queues >> timer >> retransmits >> user) {
    if (local == from && remote == to) return user;
    std::getline(connections, line);
  }
  return {};
}

bool is_own_peer(const sockaddr_in& peer, int port) {
  std::ifstream connections("/proc/net/tcp");
  const std::optional<uid_t> user = user_of_peer(connections, peer, port);
  return !user || *user == ::geteuid() || *user == 0;
}

}  // namespace tessera::serve
