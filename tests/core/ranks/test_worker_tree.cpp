#include "core/ranks/worker_tree.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace tessera {
namespace test_worker_tree {

/// The ranks below `rank` and `rank` itself, in the order in which a team of workers joins their parts.
std::vector<int> branch(int rank, int size, int fan_out) {
  std::vector<int> ranks;
  for (const int child : place_in_tree(rank, size, fan_out).children) {
    const std::vector<int> below = branch(child, size, fan_out);
    ranks.insert(ranks.end(), below.begin(), below.end());
  }
  ranks.push_back(rank);
  return ranks;
}

int depth(int rank, int size, int fan_out) {
  const int parent = place_in_tree(rank, size, fan_out).parent;
  return parent < 0 ? 0 : 1 + depth(parent, size, fan_out);
}

TEST(WorkerTree, FewWorkersAreAllAskedByTheMaster) {
  const TreePlace master = place_in_tree(0, 5, 8);
  EXPECT_EQ(master.parent, -1);
  EXPECT_EQ(master.children, (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ(place_in_tree(3, 5, 8).parent, 0);
  EXPECT_TRUE(place_in_tree(3, 5, 8).children.empty());
  EXPECT_TRUE(place_in_tree(0, 1, 8).children.empty());
}

TEST(WorkerTree, HasNoPlaceForOthers) {
  EXPECT_THROW(place_in_tree(5, 5, 8), std::logic_error);
  EXPECT_THROW(place_in_tree(-1, 5, 8), std::logic_error);
  EXPECT_THROW(place_in_tree(1, 5, 0), std::logic_error);
}

TEST(WorkerTree, TenWorkersAndThreeAskedByEach) {
  EXPECT_EQ(place_in_tree(0, 11, 3).children, (std::vector<int>{3, 6, 10}));
  EXPECT_EQ(place_in_tree(3, 11, 3).children, (std::vector<int>{1, 2}));
  EXPECT_EQ(place_in_tree(10, 11, 3).children, (std::vector<int>{7, 8, 9}));
}

RC_GTEST_PROP(WorkerTree, HoldsEveryWorkerOnceInOrder, ()) {
  const int size = *rc::gen::inRange(1, 300);
  const int fan_out = *rc::gen::inRange(1, 20);
  std::vector<int> expected;
  for (int rank = 1; rank < size; ++rank) expected.push_back(rank);
  expected.push_back(0);
  RC_ASSERT(branch(0, size, fan_out) == expected);
}

RC_GTEST_PROP(WorkerTree, ParentsKnowTheirChildren, ()) {
  const int size = *rc::gen::inRange(2, 300);
  const int fan_out = *rc::gen::inRange(1, 20);
  const int rank = *rc::gen::inRange(1, size);
  const TreePlace place = place_in_tree(rank, size, fan_out);
  const std::vector<int> siblings = place_in_tree(place.parent, size, fan_out).children;
  RC_ASSERT(std::count(siblings.begin(), siblings.end(), rank) == 1);
  RC_ASSERT(int(place.children.size()) <= fan_out);
}

RC_GTEST_PROP(WorkerTree, IsNoDeeperThanItMustBe, ()) {
  const int size = *rc::gen::inRange(2, 600);
  const int fan_out = *rc::gen::inRange(2, 20);
  int levels = 0;
  for (int ranks = 1, level = 1; ranks < size; ranks += level) {
    level *= fan_out;
    ++levels;
  }
  RC_ASSERT(depth(*rc::gen::inRange(1, size), size, fan_out) <= levels);
}

}  // namespace test_worker_tree
}  // namespace tessera
