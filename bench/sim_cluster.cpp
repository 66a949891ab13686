#include "sim_cluster.h"

#include <algorithm>
#include <string>

namespace tessera::bench {
namespace {

namespace sg4 = simgrid::s4u;

constexpr double kFlopsPerSecond = 1e9;

std::string host_name(int rank) { return "host" + std::to_string(rank); }

void make_platform(int ranks, const Cluster& cluster) {
  sg4::NetZone* zone = sg4::create_star_zone("cluster");
  for (int rank = 0; rank < ranks; ++rank) {
    sg4::Host* host = zone->create_host(host_name(rank), kFlopsPerSecond);
    sg4::Link* link = zone->create_split_duplex_link("link" + std::to_string(rank), cluster.bytes_per_s)
                          ->set_latency(cluster.latency_s / 2)
                          ->seal();
    const sg4::LinkInRoute up(link, sg4::LinkInRoute::Direction::UP);
    zone->add_route(host->get_netpoint(), nullptr, nullptr, nullptr, {up}, true);
  }
  zone->seal();
}

}  // namespace

sg4::Host* host_of(int rank) { return sg4::Host::by_name(host_name(rank)); }

sg4::Mailbox* inbox(int rank) { return sg4::Mailbox::by_name("to " + std::to_string(rank)); }
sg4::Mailbox* outbox(int rank) { return sg4::Mailbox::by_name("from " + std::to_string(rank)); }

void pass(double seconds) {
  if (seconds > 0) sg4::this_actor::execute(seconds * kFlopsPerSecond);
}

void send(sg4::Mailbox* mailbox, double bytes) {
  static int message;
  mailbox->put_init(&message, std::uint64_t(std::max(1., bytes)))->detach();
}

void simulate(int ranks, const Cluster& cluster, const std::function<void()>& master) {
  sg4::Engine engine("tessera");
  // Links as they are; the default is made for TCP on Ethernet.
  sg4::Engine::set_config("network/model:CM02");
  sg4::Engine::set_config("network/TCP-gamma:0");
  sg4::Engine::set_config("network/crosstraffic:no");
  make_platform(ranks, cluster);
  sg4::Actor::create("master", host_of(0), master);
  engine.run();
}

}  // namespace tessera::bench
