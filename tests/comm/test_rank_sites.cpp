// Rank 0 learns the machine of every rank.
#include "comm/teams/rank_sites.h"

#include <gtest/gtest.h>

#include "on_all_ranks.h"

namespace tessera::comm {
namespace test_rank_sites {

RankSite site_of(int rank) {
  RankSite site{"host" + std::to_string(rank), {}};
  for (int i = 0; i < rank % 3; ++i) {
    site.devices.push_back({"gpu", "device " + std::to_string(i), "platform", "1.2", 70});
  }
  return site;
}

TEST(RankSites, ReachRankZeroInTheOrderOfTheRanks) {
  test::on_all_ranks([](Communicator& ranks) {
    if (ranks.rank() != 0) {
      tell_site(ranks, site_of(ranks.rank()));
      ranks.barrier();
      return;
    }
    const std::vector<RankSite> sites = gather_sites(ranks, site_of(0));
    ranks.barrier();
    ASSERT_EQ(int(sites.size()), ranks.size());
    for (int rank = 0; rank < ranks.size(); ++rank) EXPECT_EQ(sites[std::size_t(rank)], site_of(rank)) << rank;
  });
}

}  // namespace test_rank_sites
}  // namespace tessera::comm
