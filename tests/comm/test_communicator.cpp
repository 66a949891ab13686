#include "comm/communicator.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "comm/teams/node_turn.h"
#include "core/base/error.h"
#include "core/base/stop.h"
#include "on_all_ranks.h"

namespace tessera::comm {
namespace test_communicator {

using test::on_all_ranks;

Bytes pattern(std::size_t size, int seed) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = char((i * 31 + std::size_t(seed) * 7 + (i >> 11)) & 0xff);
  return bytes;
}

int next_rank(const Communicator& ranks) { return (ranks.rank() + 1) % ranks.size(); }
int previous_rank(const Communicator& ranks) { return (ranks.rank() + ranks.size() - 1) % ranks.size(); }

TEST(Communicator, KnowsItsPlace) {
  on_all_ranks([](Communicator& ranks) {
    EXPECT_GE(ranks.rank(), 0);
    EXPECT_LT(ranks.rank(), ranks.size());
    EXPECT_EQ(ranks.node_ranks().at(std::size_t(ranks.local_rank())), ranks.rank());
    EXPECT_TRUE(std::is_sorted(ranks.node_ranks().begin(), ranks.node_ranks().end()));
    EXPECT_EQ(ranks.local_size(), ranks.size());  // the tests run on one node
    EXPECT_EQ(ranks.place().find("rank " + std::to_string(ranks.rank())), 0u);
  });
}

TEST(Communicator, PassesBytesAroundTheRing) {
  for (const std::size_t size : {0u, 1u, 4095u, 65537u, 5000000u}) {
    on_all_ranks([size](Communicator& ranks) {
      ranks.send(next_rank(ranks), Tag::count_request, pattern(size, ranks.rank()));
      EXPECT_EQ(ranks.receive(previous_rank(ranks), Tag::count_request), pattern(size, previous_rank(ranks)));
      ranks.flush();
    });
  }
}

TEST(Communicator, KeepsTheOrderWithinATagAndTakesTagsInAnyOrder) {
  on_all_ranks([](Communicator& ranks) {
    for (int i = 0; i < 20; ++i) {
      ranks.send(next_rank(ranks), i % 2 ? Tag::count_request : Tag::dock_request, pattern(std::size_t(i) * 700, i));
    }
    const int from = previous_rank(ranks);
    for (int i = 1; i < 20; i += 2)
      EXPECT_EQ(ranks.receive(from, Tag::count_request), pattern(std::size_t(i) * 700, i));
    for (int i = 0; i < 20; i += 2) EXPECT_EQ(ranks.receive(from, Tag::dock_request), pattern(std::size_t(i) * 700, i));
  });
}

TEST(Communicator, ReceiveAnyFollowsTheOrderOfSending) {
  on_all_ranks([](Communicator& ranks) {
    for (const Tag tag : {Tag::update_field, Tag::turn, Tag::dock_request, Tag::update_field}) {
      ranks.send(next_rank(ranks), tag, {});
    }
    for (const Tag tag : {Tag::update_field, Tag::dock_request, Tag::update_field}) {
      EXPECT_EQ(ranks.receive_any(previous_rank(ranks), {Tag::dock_request, Tag::update_field}).tag, tag);
    }
    ranks.receive(previous_rank(ranks), Tag::turn);
  });
}

constexpr std::size_t kLargeSize = 100'000'000;
constexpr std::size_t kTwoMayBeUnderWay = Communicator::kMostUnderWay / 2 + 1;

TEST(Communicator, LargeMessagesBothWaysDoNotLockUp) {
  on_all_ranks([](Communicator& ranks) {
    if (ranks.rank() > 1) return;  // two ranks are enough here
    const int other = ranks.size() == 1 ? 0 : 1 - ranks.rank();
    Bytes sent(kLargeSize, char(ranks.rank()));
    ranks.send(other, Tag::update_field, std::move(sent));
    ranks.send(other, Tag::dock_reply, pattern(3'000'000, ranks.rank()));
    EXPECT_EQ(ranks.receive(other, Tag::dock_reply),
              pattern(3'000'000, other));  // another order than the one of sending
    const Bytes received = ranks.receive(other, Tag::update_field);
    ASSERT_EQ(received.size(), kLargeSize);
    EXPECT_EQ(received[kLargeSize / 2], char(other));
  });
}

TEST(Communicator, MoreThanMayBeUnderWayBothWaysDoesNotLockUp) {
  on_all_ranks([](Communicator& ranks) {
    if (ranks.rank() > 1) return;
    const int other = ranks.size() == 1 ? 0 : 1 - ranks.rank();
    for (int i = 0; i < 3; ++i) ranks.send(other, Tag::update_field, Bytes(kTwoMayBeUnderWay, char(i)));
    for (int i = 0; i < 3; ++i) EXPECT_EQ(ranks.receive(other, Tag::update_field).back(), char(i));
  });
}

TEST(Communicator, BroadcastGivesEveryRankTheFirstOnesBytes) {
  for (const std::size_t size : {0u, 3u, 300000u}) {
    on_all_ranks([size](Communicator& ranks) {
      const Bytes own = ranks.rank() == 0 ? pattern(size, 5) : pattern(17, 6);
      EXPECT_EQ(ranks.broadcast(own), pattern(size, 5));
    });
  }
}

TEST(Communicator, NobodyPassesABarrierBeforeAllHaveCome) {
  on_all_ranks([](Communicator& ranks) {
    // After barrier i a rank finds the messages of round i from all others, because they sent them before their barrier.
    for (int round = 0; round < 10; ++round) {
      for (int to = 0; to < ranks.size(); ++to) ranks.send(to, Tag::turn, pattern(8, round));
      ranks.barrier();
      for (int from = 0; from < ranks.size(); ++from) EXPECT_EQ(ranks.receive(from, Tag::turn), pattern(8, round));
    }
  });
}

TEST(Communicator, CountsTraffic) {
  on_all_ranks([](Communicator& ranks) {
    ranks.send(next_rank(ranks), Tag::count_reply, Bytes(1000));
    ranks.send(next_rank(ranks), Tag::count_reply, Bytes(24));
    ranks.send(next_rank(ranks), Tag::dock_reply, {});
    for (const Tag tag : {Tag::count_reply, Tag::count_reply, Tag::dock_reply})
      ranks.receive(previous_rank(ranks), tag);
    const Traffic& traffic = ranks.traffic();
    for (const TrafficCount& count : {traffic.sent(Tag::count_reply), traffic.received(Tag::count_reply)}) {
      EXPECT_EQ(count.messages, 2u);
      EXPECT_EQ(count.bytes, 1024u);
    }
    EXPECT_EQ(traffic.sent(Tag::dock_reply).messages, 1u);
    EXPECT_EQ(traffic.sent(Tag::hello).messages, 0u);
    EXPECT_EQ(traffic.total_sent().messages, 3u);
    EXPECT_EQ(traffic.total_received().bytes, 1024u);
  });
}

TEST(Communicator, AWaitCanBeInterrupted) {
  on_all_ranks([](Communicator& ranks) {
    int looks = 0;
    ranks.interrupt_waits_when([&looks] { return ++looks > 3 ? std::optional(StopReason::signal) : std::nullopt; });
    EXPECT_THROW(ranks.receive(ranks.rank(), Tag::turn), Interrupted);
    ranks.interrupt_waits_when(nullptr);
    ranks.barrier();
  });
}

TEST(NodeTurn, OneWorkerOfTheNodeGoesFirst) {
  on_all_ranks([](Communicator& ranks) {
    if (ranks.rank() == 0) {
      for (int worker = 1; worker < ranks.size(); ++worker) {
        const Bytes seen = ranks.receive(worker, Tag::count_reply);
        EXPECT_EQ(seen, Bytes(1, char(worker > 1)));
      }
      return;
    }
    // Every rank except the node's first one finds the note of that one.
    bool note = false;
    first_worker_of_node_first(ranks, [&] {
      if (ranks.rank() == 1) {
        for (int worker = 2; worker < ranks.size(); ++worker) ranks.send(worker, Tag::dock_request, {});
      } else {
        ranks.receive(1, Tag::dock_request);
        note = true;
      }
    });
    ranks.send(0, Tag::count_reply, Bytes(1, char(note)));
  });
}

}  // namespace test_communicator
}  // namespace tessera::comm
