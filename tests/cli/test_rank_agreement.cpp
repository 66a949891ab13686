// What a worker compares with the master before the first round, over ranks that are threads.
#include "cli/rank_agreement.h"

#include <gtest/gtest.h>

#include <thread>

#include "comm/in_process_communicator.h"
#include "core/base/error.h"

namespace tessera::cli {
namespace {

/// What the worker's `join` throws, as text; "" for nothing. The master runs "master 1" with a job of seed 5.
template <class Join>
std::string complaint(Join join) {
  comm::InProcessNetwork network(2);
  std::jthread master([&network] {
    io::Job job;
    job.library = "/a/library.h5";
    job.settings.seed = 5;
    const auto ranks = network.connect(0);
    announce_run(*ranks, "master 1", job, 77);
  });
  const auto ranks = network.connect(1);
  try {
    join(*ranks);
    return "";
  } catch (const EnvironmentError& error) {
    return error.what();
  }
}

TEST(RankAgreement, the_masters_job_arrives) {
  EXPECT_EQ(complaint([](comm::Communicator& ranks) {
              const io::Job job = receive_job(ranks, "master 1");
              EXPECT_EQ(job.settings.seed, 5u);
              EXPECT_EQ(job.library, "/a/library.h5");
            }),
            "");
}

TEST(RankAgreement, another_program_is_refused) {
  EXPECT_EQ(
      complaint([](comm::Communicator& ranks) { receive_job(ranks, "worker 2"); }),
      "this rank runs worker 2, the master master 1; allowed: the same program on all ranks; install it anew on every "
      "node");
}

TEST(RankAgreement, the_program_is_told_by_version_commit_and_kernels) {
  EXPECT_TRUE(program_identity().starts_with("tessera "));
  EXPECT_NE(program_identity().find(", commit "), std::string::npos);
  EXPECT_NE(program_identity().find(", kernels "), std::string::npos);
}

}  // namespace
}  // namespace tessera::cli
