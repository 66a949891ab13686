// When several ranks fail, the first failure is reported: the others mostly fail because of it.
#include <gtest/gtest.h>

#include <new>
#include <string>

#include "comm/failure.h"
#include "comm/in_process_communicator.h"
#include "core/base/error.h"

namespace tessera::comm {
namespace test_first_failure {

TEST(FirstFailure, IsTheOneThatTheMasterTells) {
  InProcessNetwork network(3);
  const std::unique_ptr<Communicator> master = network.connect(0);
  network.connect(2)->report_failure({kInputExitCode, "the cause"});
  network.connect(1)->report_failure({kEnvironmentExitCode, "a consequence"});
  try {
    master->receive(1, Tag::hello);
    ADD_FAILURE() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "the cause");
  }
}

/// A rank of another program version sends such bytes.
TEST(FirstFailure, IsToldWithItsRankWhereItCannotBeRead) {
  InProcessNetwork network(2);
  const std::unique_ptr<Communicator> master = network.connect(0);
  network.connect(1)->send(0, Tag::failure, Bytes{1, 2, 3});
  try {
    master->receive(1, Tag::hello);
    ADD_FAILURE() << "nothing was thrown";
  } catch (const EnvironmentError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("rank 1 failed, and its message cannot be read; allowed: "));
  }
}

/// Lack of memory is a failure of the machine, not of the job: another machine may have enough.
TEST(FirstFailure, WantOfMemoryIsTheMachines) {
  try {
    throw std::bad_alloc();
  } catch (...) {
    const Failure failure = describe_current_exception();
    EXPECT_EQ(failure.exit_code, kEnvironmentExitCode);
    EXPECT_EQ(failure.text, "out of memory");
  }
}

}  // namespace test_first_failure
}  // namespace tessera::comm
