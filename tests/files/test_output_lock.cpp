// One run at a time writes an output. A second run learns which run holds it; the output of a dead process is taken over.
#include "files/output_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/base/error.h"
#include "support/file_size_limit.h"
#include "support/planted_files.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_output_lock {

class OutputLockTest : public testing::Test {
 protected:
  ~OutputLockTest() override { as_slurm_job("", ""); }

  std::string complaint() const {
    try {
      const OutputLock lock(path_, "result");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  /// Starts a process that holds the lock until it is killed, with a child of its own if asked for.
  pid_t start_holder(bool with_child) const {
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    const pid_t holder = fork();
    if (holder == 0) {
      const OutputLock lock(path_, "result");
      if (with_child && fork() == 0) {
        alarm(10);
        pause();
      }
      if (write(ends[1], "x", 1) == 1) pause();
      _exit(1);
    }
    char byte = 0;
    EXPECT_EQ(read(ends[0], &byte, 1), 1);
    close(ends[0]);
    close(ends[1]);
    return holder;
  }

  static void kill_and_wait(pid_t process) {
    kill(process, SIGKILL);
    waitpid(process, nullptr, 0);
  }

  void leave_by_another_machine() const {
    folder_.write("run.lock", "boot other\nhost node7\npid 71\nslurm_job 12\nslurm_restart 1\n");
  }

  static void as_slurm_job(const std::string& job, const std::string& restarts) {
    job.empty() ? unsetenv("SLURM_JOB_ID") : setenv("SLURM_JOB_ID", job.c_str(), 1);
    restarts.empty() ? unsetenv("SLURM_RESTART_COUNT") : setenv("SLURM_RESTART_COUNT", restarts.c_str(), 1);
  }

  test::ScratchFolder folder_;
  std::string path_ = folder_.path("run.lock");
};

TEST_F(OutputLockTest, is_gone_when_it_is_released) {
  {
    const OutputLock lock(path_, "result");
    EXPECT_TRUE(std::filesystem::exists(path_));
  }
  EXPECT_FALSE(std::filesystem::exists(path_));
  EXPECT_EQ(complaint(), "");
}

TEST_F(OutputLockTest, names_the_process_that_holds_it) {
  const pid_t holder = start_holder(false);
  const std::string text = complaint();
  EXPECT_EQ(text.find("result: another run is at work here: process " + std::to_string(holder) + " on "), 0u) << text;
  kill_and_wait(holder);
  EXPECT_TRUE(std::filesystem::exists(path_));
  EXPECT_EQ(complaint(), "") << "the process is dead";
}

TEST_F(OutputLockTest, is_not_kept_by_a_child_of_a_dead_process) {
  kill_and_wait(start_holder(true));
  EXPECT_EQ(complaint(), "");
}

TEST_F(OutputLockTest, of_a_dead_process_can_be_removed_and_no_other) {
  remove_stale_lock(path_);
  const pid_t holder = start_holder(false);
  remove_stale_lock(path_);
  EXPECT_TRUE(std::filesystem::exists(path_)) << "its holder is alive";
  kill_and_wait(holder);
  remove_stale_lock(path_);
  EXPECT_FALSE(std::filesystem::exists(path_));
  leave_by_another_machine();
  remove_stale_lock(path_);
  EXPECT_TRUE(std::filesystem::exists(path_)) << "nobody knows of its holder";
}

TEST_F(OutputLockTest, is_removed_where_a_library_ends_the_process) {
  const pid_t child = fork();
  if (child == 0) {
    const OutputLock lock(path_, "result");
    std::exit(0);
  }
  waitpid(child, nullptr, 0);
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(OutputLockTest, of_another_machine_is_left_to_the_user) {
  leave_by_another_machine();
  EXPECT_EQ(complaint(),
            "result: another run may still be at work here: process 71 on node7, Slurm job 12, and "
            "this machine cannot tell whether it has ended; if it has, remove " +
                path_);
  EXPECT_TRUE(std::filesystem::exists(path_));
}

TEST_F(OutputLockTest, is_taken_over_by_the_same_slurm_job_queued_again) {
  leave_by_another_machine();
  as_slurm_job("12", "1");
  EXPECT_NE(complaint(), "") << "the same run of the job";
  as_slurm_job("13", "2");
  EXPECT_NE(complaint(), "") << "another job";
  as_slurm_job("12", "2");
  EXPECT_EQ(complaint(), "");
}

TEST_F(OutputLockTest, follows_nothing_that_others_put_there) {
  for (const test::Plant plant : test::kPlants) {
    if (plant == test::Plant::file) continue;
    const test::PlantedFiles planted;
    planted.put(plant, path_);
    EXPECT_THROW(OutputLock(path_, "result"), EnvironmentError);
    planted.expect_untouched();
    std::filesystem::remove(path_);
  }
}

TEST_F(OutputLockTest, leaves_no_file_where_there_is_no_room_for_a_word) {
  const test::FileSizeLimit full(0);
  EXPECT_THROW(OutputLock(path_, "result"), EnvironmentError);
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(OutputLockTest, cannot_be_written_where_there_is_no_folder) {
  EXPECT_THROW(OutputLock(folder_.path("none/run.lock"), "none"), EnvironmentError);
}

}  // namespace test_output_lock
}  // namespace tessera
