#include "comm/rank_program.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/stop.h"
#include "job_fixture.h"
#include "on_all_ranks.h"

namespace tessera::comm {
namespace test_rank_program {

using test::JobOutcome;
using test::on_all_ranks;
using test::run_job;

/// Expects that rank 0 ended with this exit code and these lines, and that the other ranks left in order and silently.
void expect_outcome(const Communicator& ranks, const JobOutcome& outcome, int exit_code,
                    const std::vector<std::string>& lines) {
  EXPECT_EQ(outcome.result.ending, Ending::orderly);
  EXPECT_EQ(outcome.result.exit_code, ranks.rank() == 0 ? exit_code : 0);
  EXPECT_EQ(outcome.reported, ranks.rank() == 0 ? lines : std::vector<std::string>{});
}

void wait_for_ever(Communicator& ranks) { ranks.receive(0, Tag::turn); }

TEST(RankProgram, RankZerosExitCodeIsTheJobs) {
  for (const int code : {0, 3}) {
    on_all_ranks([code](Communicator& ranks) {
      const JobOutcome outcome = run_job(
          ranks, [code](Communicator&) { return code; }, [](Communicator&) {});
      expect_outcome(ranks, outcome, code, {});
    });
  }
}

TEST(RankProgram, WhenRankZeroReturnsAllWaitsEnd) {
  on_all_ranks([](Communicator& ranks) {
    const JobOutcome outcome = run_job(
        ranks, [](Communicator&) { return 0; },
        [](Communicator& c) {
          wait_for_ever(c);
          ADD_FAILURE() << "the wait did not end";
        });
    expect_outcome(ranks, outcome, 0, {});
  });
}

TEST(RankProgram, RankZerosErrorIsReportedOnceAndEndsAll) {
  on_all_ranks([](Communicator& ranks) {
    const JobOutcome bad_job = run_job(
        ranks, [](Communicator&) -> int { throw InputError("job.toml:3: bad key"); },
        [](Communicator& c) { c.broadcast({}); });
    expect_outcome(ranks, bad_job, 2, {"job.toml:3: bad key"});
  });
  on_all_ranks([](Communicator& ranks) {
    const JobOutcome disk_full = run_job(
        ranks, [](Communicator&) -> int { throw EnvironmentError("disk full"); }, [](Communicator& c) { c.barrier(); });
    expect_outcome(ranks, disk_full, 1, {"disk full"});
  });
}

TEST(RankProgram, AWorkersErrorBecomesRankZerosWithItsName) {
  on_all_ranks([](Communicator& ranks) {
    if (ranks.size() == 1) return;
    const int culprit = ranks.size() - 1;
    const JobOutcome outcome = run_job(
        ranks,
        [](Communicator& c) {
          EXPECT_THROW(c.receive(1, Tag::turn), InputError);
          c.receive(1, Tag::turn);  // throws again because this job is over
          return 0;
        },
        [culprit](Communicator& c) {
          if (c.rank() == culprit) throw InputError("library.h5 is damaged");
          wait_for_ever(c);
        });
    EXPECT_EQ(outcome.result.exit_code, ranks.rank() == 0 ? 2 : 0);
    if (ranks.rank() != 0) return;
    ASSERT_EQ(outcome.reported.size(), 1u);
    EXPECT_EQ(outcome.reported[0].find("rank " + std::to_string(culprit)), 0u) << outcome.reported[0];
    EXPECT_NE(outcome.reported[0].find(": library.h5 is damaged"), std::string::npos) << outcome.reported[0];
  });
}

TEST(RankProgram, ManyWorkersErrorsAreReportedOnce) {
  on_all_ranks([](Communicator& ranks) {
    if (ranks.size() == 1) return;
    const JobOutcome outcome = run_job(
        ranks,
        [](Communicator& c) {
          c.barrier();
          return 0;
        },
        [](Communicator&) { throw EnvironmentError("no OpenCL device"); });
    EXPECT_EQ(outcome.result.exit_code, ranks.rank() == 0 ? 1 : 0);
    EXPECT_EQ(outcome.reported.size(), ranks.rank() == 0 ? 1u : 0u);
  });
}

TEST(RankProgram, WhatAWorkerStillHadToSayDoesNotKeepItsRankZero) {
  on_all_ranks([](Communicator& ranks) {
    const JobOutcome outcome = run_job(
        ranks, [](Communicator&) { return 0; },
        [](Communicator& c) {
          for (int i = 0; i < 5; ++i) c.send(0, Tag::dock_reply, Bytes(2'000'000));
          wait_for_ever(c);
        });
    expect_outcome(ranks, outcome, 0, {});
  });
}

TEST(RankProgram, AnInterruptedWaitLeavesTheJobToRankZero) {
  on_all_ranks([](Communicator& ranks) {
    if (ranks.size() == 1) return;
    const JobOutcome outcome = run_job(
        ranks,
        [](Communicator& c) {
          c.interrupt_waits_when([] { return StopReason::signal; });
          EXPECT_THROW(c.receive(1, Tag::dock_reply), Interrupted);
          return 5;
        },
        wait_for_ever);
    expect_outcome(ranks, outcome, 5, {});
  });
}

}  // namespace test_rank_program
}  // namespace tessera::comm
