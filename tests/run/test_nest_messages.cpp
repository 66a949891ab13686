// Messages between the ranks of a nesting arrive unchanged, and only between ranks of one program.
#include "run/nesting/nest_messages.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "comm/encode.h"
#include "comm/in_process_communicator.h"
#include "core/base/error.h"
#include "run/nesting/nest_chains.h"

namespace tessera {
namespace test_nest_messages {

int any_count() { return *rc::gen::inRange(0, 1000); }
double any_length() { return *rc::gen::arbitrary<double>(); }

template <class Make>
auto some(Make make) {
  std::vector<decltype(make())> values(std::size_t(*rc::gen::inRange(0, 6)));
  for (auto& value : values) value = make();
  return values;
}

NestItem any_item() {
  return {some([] { return NestPoint{any_length(), any_length()}; }), some(any_length), any_count()};
}

TEST(NestMessages, a_search_arrives_as_it_was) {
  EXPECT_TRUE(rc::check([] {
    const NestSearch sent{{some(any_item), any_length(), any_length(), any_length()},
                          {any_count(), *rc::gen::arbitrary<std::uint64_t>()},
                          *rc::gen::arbitrary<std::uint64_t>()};
    const auto got = comm::decode<NestSearch>(comm::encode(sent));
    RC_ASSERT(got.problem.items.size() == sent.problem.items.size());
    for (std::size_t i = 0; i < got.problem.items.size(); ++i) {
      RC_ASSERT(got.problem.items[i].outline == sent.problem.items[i].outline);
      RC_ASSERT(got.problem.items[i].angles_deg == sent.problem.items[i].angles_deg);
      RC_ASSERT(got.problem.items[i].demand == sent.problem.items[i].demand);
    }
    RC_ASSERT(got.problem.height == sent.problem.height);
    RC_ASSERT(got.problem.length == sent.problem.length);
    RC_ASSERT(got.problem.spacing == sent.problem.spacing);
    RC_ASSERT(got.effort.chains == sent.effort.chains);
    RC_ASSERT(got.effort.work_of_piece == sent.effort.work_of_piece);
    RC_ASSERT(got.seed == sent.seed);
  }));
}

TEST(NestMessages, a_strip_without_end_arrives) {
  EXPECT_EQ(comm::decode<NestSearch>(comm::encode(NestSearch{})).problem.length, NestProblem().length);
}

TEST(NestMessages, a_report_arrives_as_it_was) {
  EXPECT_TRUE(rc::check([] {
    NestReport sent;
    sent.layout.pieces = some([] {
      return NestedPiece{any_count(), any_count(), {any_length(), any_length()}, any_count()};
    });
    sent.layout.left_over = some(any_count);
    sent.layout.sheets = any_count();
    sent.layout.used_length = any_length();
    sent.layout.chain = any_count();
    sent.is_last = *rc::gen::arbitrary<bool>();
    const auto got = comm::decode<NestReport>(comm::encode(sent));
    RC_ASSERT(got.layout.pieces == sent.layout.pieces);
    RC_ASSERT(got.layout.left_over == sent.layout.left_over);
    RC_ASSERT(got.layout.sheets == sent.layout.sheets);
    RC_ASSERT(got.layout.used_length == sent.layout.used_length);
    RC_ASSERT(got.layout.chain == sent.layout.chain);
    RC_ASSERT(got.is_last == sent.is_last);
  }));
}

TEST(NestMessages, a_worker_refuses_the_master_of_another_program) {
  comm::InProcessNetwork network(2);
  const std::string other = "tessera 0.0.1, commit none, kernels 0";
  network.connect(0)->broadcast({other.begin(), other.end()});
  try {
    work_on_nesting(*network.connect(1), 60);
  } catch (const EnvironmentError& error) {
    EXPECT_NE(std::string(error.what()).find("the master " + other), std::string::npos) << error.what();
  }
}

}  // namespace test_nest_messages
}  // namespace tessera
