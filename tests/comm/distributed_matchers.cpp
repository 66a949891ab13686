// The suite of all matchers, with workers that are threads of this process.
#include <thread>

#include "comm/in_process_communicator.h"
#include "comm/rank_program.h"
#include "comm/teams/worker_server.h"
#include "comm/teams/worker_team.h"
#include "core/matcher_suite.h"
#include "core/ranks/partition.h"
#include "idle_replacer.h"

namespace tessera::comm {
namespace test_distributed_matchers {

using tessera::test::MatcherKind;
using tessera::test::MatcherSuite;

/// A master's communicator and its workers. Each worker is a thread with a reference matcher for its part.
class ThreadedJob {
 public:
  ThreadedJob(const MatchingContext& context, std::uint32_t first, const std::vector<ShapeModel>& models, int workers)
      : network_(workers + 1),
        master_(network_.connect(0)) {
    const std::vector<ShapeRange> parts = balanced_ranges(std::vector<std::uint64_t>(models.size(), 1), workers);
    for (int w = 0; w < workers; ++w) {
      auto part = std::make_unique<ReferenceMatcher>(
          context, first + parts[w].begin,
          std::vector<ShapeModel>{models.begin() + parts[w].begin, models.begin() + parts[w].end});
      threads_.emplace_back([this, w, part = std::move(part)]() mutable { work(w + 1, std::move(part)); });
    }
  }

  ~ThreadedJob() {
    master_->tell_end(Ending::orderly);
    EXPECT_TRUE(master_->wait_for_goodbyes(60));
  }

 protected:
  std::vector<std::unique_ptr<Matcher>> gathered() {
    std::vector<std::unique_ptr<Matcher>> all;
    all.push_back(gather_workers(*master_));
    return all;
  }

 private:
  void work(int rank, std::unique_ptr<Matcher> part) {
    const std::unique_ptr<Communicator> ranks = network_.connect(rank);
    run_rank(*ranks,
             {.run = [&](Communicator& c) -> int { serve(c, std::move(part), std::make_unique<test::IdleReplacer>()); },
              .report_error = {}});
  }

  InProcessNetwork network_;
  std::unique_ptr<Communicator> master_;
  std::vector<std::jthread> threads_;
};

class ThreadedTeam : ThreadedJob, public CompositeMatcher {
 public:
  ThreadedTeam(const MatchingContext& context, std::uint32_t first, const std::vector<ShapeModel>& models, int workers)
      : ThreadedJob(context, first, models, workers),
        CompositeMatcher(gathered()) {}
};

MatcherKind team_of(int workers) {
  return {"TeamOf" + std::to_string(workers),
          [workers](const MatchingContext& context, std::uint32_t first, std::vector<ShapeModel> models) {
            return std::make_unique<ThreadedTeam>(context, first, models, workers);
          }};
}

INSTANTIATE_TEST_SUITE_P(Distributed, MatcherSuite,
                         testing::Values(team_of(1), team_of(2), team_of(3), team_of(11), team_of(30)),
                         [](const auto& info) { return info.param.name; });

}  // namespace test_distributed_matchers
}  // namespace tessera::comm
