// The check refuses launchers that would start several masters. It accepts every way to start one process or Open MPI's ranks.
#include "comm/launcher_check.h"

#include <gtest/gtest.h>

#include <map>

namespace tessera::comm {
namespace test_launcher_check {

std::string problem(const std::map<std::string, std::string>& variables, int ranks = 1) {
  const auto value = [&](const char* name) {
    const auto at = variables.find(name);
    return at == variables.end() ? nullptr : at->second.c_str();
  };
  return launcher_problem(value, ranks);
}

TEST(LauncherCheck, foreign_launchers_of_several_processes_are_refused) {
  EXPECT_NE(problem({{"PMI_SIZE", "3"}, {"PMI_RANK", "0"}}).find("mpirun -n 3 tessera"), std::string::npos);
  EXPECT_NE(problem({{"MPI_LOCALNRANKS", "2"}, {"MPI_LOCALRANKID", "1"}}), "");
  EXPECT_NE(problem({{"MV2_COMM_WORLD_SIZE", "4"}, {"MV2_COMM_WORLD_RANK", "0"}}), "");
  EXPECT_NE(
      problem({{"SLURM_NTASKS", "3"}, {"SLURM_PROCID", "1"}, {"SLURM_STEP_ID", "0"}, {"SLURM_STEP_NUM_TASKS", "3"}})
          .find("srun without PMIx"),
      std::string::npos);
}

TEST(LauncherCheck, srun_whose_pmix_open_mpi_does_not_find_is_refused) {
  EXPECT_NE(problem({{"PMIX_RANK", "1"}, {"SLURM_PROCID", "1"}, {"SLURM_STEP_NUM_TASKS", "3"}}, 1), "");
  EXPECT_EQ(problem({{"PMIX_RANK", "1"}, {"SLURM_PROCID", "1"}, {"SLURM_STEP_NUM_TASKS", "3"}}, 3), "");
}

TEST(LauncherCheck, one_process_is_fine_wherever_it_runs) {
  EXPECT_EQ(problem({}), "");
  // The accepted ways: a batch script's own process, salloc's shell, a step of one task, a shell by srun --pty.
  EXPECT_EQ(
      problem({{"SLURM_JOB_ID", "7"}, {"SLURM_NTASKS", "3"}, {"SLURM_PROCID", "0"}, {"SLURM_TASKS_PER_NODE", "3"}}),
      "");
  EXPECT_EQ(problem({{"SLURM_JOB_ID", "7"}, {"SLURM_NTASKS", "3"}}), "");
  EXPECT_EQ(problem({{"SLURM_NTASKS", "1"}, {"SLURM_PROCID", "0"}, {"SLURM_STEP_NUM_TASKS", "1"}}), "");
  EXPECT_EQ(problem({{"SLURM_PROCID", "0"}, {"SLURM_STEP_NUM_TASKS", "3"}, {"SLURM_PTY_PORT", "4444"}}), "");
  EXPECT_EQ(problem({{"PMI_SIZE", "1"}, {"PMI_RANK", "0"}}), "");
}

TEST(LauncherCheck, open_mpis_ranks_are_fine_inside_other_launchers) {
  EXPECT_EQ(problem({{"OMPI_COMM_WORLD_SIZE", "3"}, {"SLURM_PROCID", "0"}, {"SLURM_STEP_NUM_TASKS", "2"}}, 3), "");
  EXPECT_EQ(problem({{"OMPI_COMM_WORLD_SIZE", "1"}, {"SLURM_PROCID", "0"}, {"SLURM_STEP_NUM_TASKS", "2"}}, 1), "");
}

}  // namespace test_launcher_check
}  // namespace tessera::comm
