// Of several ranks that fail, the first one tells why: the others mostly fail because it did.
#include <gtest/gtest.h>

#include "comm/failure.h"
#include "comm/in_process_communicator.h"
#include "core/base/error.h"

namespace tessera::comm {
namespace {

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

}  // namespace
}  // namespace tessera::comm
