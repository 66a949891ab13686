#include "comm/teams/rank_sites.h"

#include "comm/encode.h"
#include "comm/messages.h"

namespace tessera::comm {

void tell_site(Communicator& ranks, const RankSite& site) { ranks.send(0, Tag::site, encode(site)); }

std::vector<RankSite> gather_sites(Communicator& ranks, RankSite own) {
  std::vector<RankSite> sites{std::move(own)};
  for (int rank = 1; rank < ranks.size(); ++rank) sites.push_back(decode<RankSite>(ranks.receive(rank, Tag::site)));
  return sites;
}

}  // namespace tessera::comm
