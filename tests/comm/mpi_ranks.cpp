// on_all_ranks over MPI, and the main function of tests that mpirun starts. The rank of a failed expectation prints it and ends the job,
// because other ranks may wait for that rank.
#include <gtest/gtest.h>

#include <cstdio>

#include "comm/mpi_communicator.h"
#include "comm/mpi_job.h"
#include "on_all_ranks.h"

namespace tessera::comm::test {

void on_all_ranks(const std::function<void(Communicator&)>& body) {
  MpiCommunicator ranks;
  body(ranks);
  ranks.wait_until_sent(60);  // flush() would throw, as the job may be over
}

namespace {

class EndJobOnFailure : public testing::EmptyTestEventListener {
  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (!result.failed()) return;
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    std::fprintf(stderr, "rank %d: %s:%d: %s\n", rank, result.file_name(), result.line_number(), result.message());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
};

}  // namespace
}  // namespace tessera::comm::test

int main(int argc, char** argv) {
  const tessera::comm::MpiGuard mpi(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
  if (rank != 0) delete listeners.Release(listeners.default_result_printer());
  listeners.Append(new tessera::comm::test::EndJobOnFailure);
  return RUN_ALL_TESTS();
}
