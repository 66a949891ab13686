// Another process, its end and its last words.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "core/base/error.h"
#include "serve/refinement.h"
#include "support/scratch_folder.h"

namespace tessera::serve {
namespace test_refinement {

class RefinementTest : public ::testing::Test {
 protected:
  std::string program(const std::string& script) {
    const std::string path = folder_.write("program.sh", "#!/bin/sh\n" + script);
    EXPECT_EQ(::chmod(path.c_str(), 0700), 0);
    return path;
  }
  Refinement::State end_of(const Refinement& refinement) {
    for (int i = 0; i < 1000 && refinement.state().runs; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_FALSE(refinement.state().runs);
    return refinement.state();
  }

  test::ScratchFolder folder_;
};

TEST_F(RefinementTest, gives_the_arguments_and_keeps_the_last_line) {
  const Refinement refinement(program("echo lost; echo first >&2; echo >&2; echo \"tessera: $*\" >&2; exit 3"),
                              {"a b", "--out", "$x"});
  const Refinement::State end = end_of(refinement);
  EXPECT_EQ(end.exit_code, 3);
  EXPECT_EQ(end.last_line, "refine a b --out $x");
}

TEST_F(RefinementTest, tells_the_signal_of_a_killed_process) {
  EXPECT_EQ(end_of(Refinement(program("kill -9 $$"), {})).exit_code, 128 + SIGKILL);
}

TEST_F(RefinementTest, keeps_no_endless_line) {
  const Refinement::State end = end_of(Refinement(program("head -c 1000000 /dev/zero | tr '\\0' x >&2; echo >&2"), {}));
  EXPECT_GT(end.last_line.size(), 1000u);
  EXPECT_LT(end.last_line.size(), 10'000u);
}

TEST_F(RefinementTest, asks_with_SIGTERM) {
  Refinement refinement(program("trap 'echo saved >&2; exit 75' TERM; echo ready >&2; while :; do sleep 0.05; done"),
                        {});
  while (refinement.state().last_line != "ready") std::this_thread::sleep_for(std::chrono::milliseconds(10));
  refinement.stop();
  const Refinement::State end = end_of(refinement);
  EXPECT_EQ(end.exit_code, 75);
  EXPECT_EQ(end.last_line, "saved");
}

TEST_F(RefinementTest, has_a_process_group_and_no_variables_of_mpirun) {
  ::setenv("OMPI_COMM_WORLD_SIZE", "4", 1);
  ::setenv("PMIX_RANK", "1", 1);
  const Refinement refinement(
      program("echo \"$(cut -d ' ' -f 5 /proc/$$/stat) $$ [$OMPI_COMM_WORLD_SIZE$PMIX_RANK]\" >&2"), {});
  const std::string line = end_of(refinement).last_line;
  ::unsetenv("OMPI_COMM_WORLD_SIZE");
  ::unsetenv("PMIX_RANK");
  const std::string group = line.substr(0, line.find(' '));
  EXPECT_EQ(line, group + " " + group + " []");
}

TEST_F(RefinementTest, a_missing_program_is_an_error) {
  EXPECT_THROW(Refinement(folder_.path("none"), {}), EnvironmentError);
}

}  // namespace test_refinement
}  // namespace tessera::serve
