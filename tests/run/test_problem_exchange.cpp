// A worker's comparison with the master before the first round, over ranks that are threads.
#include "run/problem_exchange.h"

#include <gtest/gtest.h>

#include <thread>

#include "comm/in_process_communicator.h"
#include "core/base/error.h"
#include "run/program_identity.h"

namespace tessera::cli {
namespace test_problem_exchange {

/// The text of the exception that the worker's `join` throws, or "". The master runs "master 1" with a job of seed 5.
template <class Join>
std::string complaint(Join join) {
  comm::InProcessNetwork network(2);
  std::jthread master([&network] {
    Job job;
    job.library = "/a/library.h5";
    job.quality = QualityWord::none;  // an effective job has the number instead
    job.settings.seed = 5;
    const auto ranks = network.connect(0);
    announce_job(*ranks, "master 1", job);
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
              const Job job = receive_job(ranks, "master 1");
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

/// The master's name may hold any bytes.
TEST(RankAgreement, another_program_is_found_out_before_anything_else_is_read) {
  comm::InProcessNetwork network(2);
  network.connect(0)->broadcast(comm::Bytes{'x', '\x1b', '\x01'});
  EXPECT_THROW(receive_job(*network.connect(1), "worker 2"), EnvironmentError);
}

TEST(RankAgreement, a_job_that_cannot_be_read_is_refused) {
  comm::InProcessNetwork network(2);
  const auto master = network.connect(0);
  announce_program(*master, "master 1");
  master->broadcast(comm::Bytes(5, 'x'));
  EXPECT_THROW(receive_job(*network.connect(1), "master 1"), EnvironmentError);
}

}  // namespace test_problem_exchange
}  // namespace tessera::cli
