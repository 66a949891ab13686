#include "comm/launcher_check.h"

#include <cstdlib>

namespace tessera::comm {
namespace {

struct Launcher {
  const char* tasks;  // environment variable with the number of processes that the launcher started
  const char* rank;
  const char* name;
};

constexpr Launcher kForeignLaunchers[] = {
    {"PMI_SIZE", "PMI_RANK", "another MPI's launcher (MPICH, Intel MPI, Cray, or srun --mpi=pmi2)"},
    {"MPI_LOCALNRANKS", "MPI_LOCALRANKID", "another MPI's launcher (MPICH, Intel MPI)"},
    {"MV2_COMM_WORLD_SIZE", "MV2_COMM_WORLD_RANK", "MVAPICH's launcher"},
    {"PALS_SIZE", "PALS_RANKID", "Cray's launcher"},
    {"JSM_NAMESPACE_SIZE", "JSM_NAMESPACE_RANK", "jsrun"},
    {"FLUX_JOB_SIZE", "FLUX_TASK_RANK", "flux run"},
    // These are set for a step of srun; a batch script and salloc's shell have none. A shell of srun --pty is one
    // process, but its step may have more tasks (SLURM_PTY_PORT).
    {"SLURM_STEP_NUM_TASKS", "SLURM_PROCID", "srun without PMIx"},
};

long number(const Environment& environment, const char* name) {
  const char* text = environment(name);
  return text ? std::strtol(text, nullptr, 10) : 0;
}

bool is_one_of_many(const Environment& environment, const Launcher& launcher) {
  if (std::string(launcher.tasks).starts_with("SLURM") && environment("SLURM_PTY_PORT")) return false;
  return number(environment, launcher.tasks) > 1 && environment(launcher.rank);
}

std::string refusal(const Environment& environment, const Launcher& launcher) {
  const std::string tasks = std::to_string(number(environment, launcher.tasks));
  return "started as one of " + tasks + " processes by " + launcher.name + " (" + launcher.tasks + "=" + tasks +
         "), but this program, built with Open MPI, does not see them as ranks of one job; allowed: Open MPI's "
         "mpirun -n " +
         tasks + " tessera ..., inside sbatch too, or srun --mpi=pmix; for " + tasks +
         " jobs of one process each: env -u " + launcher.tasks + " tessera ...";
}

}  // namespace

std::string launcher_problem(const Environment& environment, int ranks) {
  if (ranks > 1 || environment("OMPI_COMM_WORLD_SIZE")) return "";
  for (const Launcher& launcher : kForeignLaunchers) {
    if (is_one_of_many(environment, launcher)) return refusal(environment, launcher);
  }
  return "";
}

}  // namespace tessera::comm
