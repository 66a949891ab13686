#include "plan/plan_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/base/count_text.h"
#include "core/base/kept_memory.h"
#include "text/number_text.h"

namespace tessera {
namespace {

constexpr double kMemoryMargin = 1.25;
constexpr double kTimeMargin = 3;
constexpr double kTimeStep_s = 300;
constexpr double kMemoryStep_bytes = 100e6;
constexpr int kWarning_s = 120;  // Slurm's signal this long before the time limit, as in slurm/*.sbatch

std::string line(const std::string& label, const std::string& value) {
  constexpr std::size_t kLabelWidth = 22;
  return "  " + label + std::string(kLabelWidth - label.size(), ' ') + value + "\n";
}

std::string megabytes(double bytes) {
  return bytes < 10e6 ? fixed(bytes / 1e6, 1) + " MB" : fixed(bytes / 1e6, 0) + " MB";
}

struct TimeUnit {
  double seconds;
  const char* name;
  int decimals;
};

TimeUnit unit_of(double seconds) {
  if (seconds < 120) return {1, " s", 0};
  return seconds < 7200 ? TimeUnit{60, " min", 0} : TimeUnit{3600, " h", 1};
}

/// The total and its parts in the same unit; the parts have one digit more.
std::string time_text(const PlanEstimate& plan) {
  const TimeUnit unit = unit_of(plan.total_s);
  const auto part = [&](double seconds) { return fixed(seconds / unit.seconds, unit.decimals + 1) + unit.name; };
  return "about " + fixed(plan.total_s / unit.seconds, unit.decimals) + unit.name + ": filling " +
         part(plan.filling_s) + ", improving " + part(plan.improving_s) + ", start and files " + part(plan.beside_s);
}

std::string ranks_text(const PlanInput& input, const PlanEstimate& plan) {
  if (input.ranks == 1) return "1 rank, master and worker in one";
  std::string text = count_text(std::size_t(input.ranks), "rank") + ", a master and " +
                     count_text(std::size_t(plan.workers), "worker");
  if (input.nodes > 1) text += ", on " + count_text(std::size_t(input.nodes), "node");
  return text;
}

std::string memory_text(const PlanInput& input, const PlanEstimate& plan) {
  const std::string device =
      line("on a worker's device", megabytes(plan.device_bytes) + ", of which " + megabytes(plan.largest_buffer_bytes) +
                                       " in one buffer" + (input.host_devices ? "; a CPU: counted above" : ""));
  if (input.ranks == 1) return line("memory", megabytes(plan.master_bytes)) + device;
  return line("memory of the master", megabytes(plan.master_bytes)) +
         line("memory of a worker", megabytes(plan.worker_bytes)) + device +
         line("memory of a node",
              megabytes(plan.node_bytes) + ", " + count_text(std::size_t(plan.ranks_per_node), "rank"));
}

}  // namespace

std::string slurm_time(double seconds) {
  const long whole = std::lround(seconds);
  char text[40];
  std::snprintf(text, sizeof text, "%02ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
  return text;
}

std::string plan_text(const PlanInput& input, const PlanEstimate& plan) {
  return "Estimates for " + ranks_text(input, plan) + "\n" +
         line("library", count_text(input.shapes, "shape") + ", " +
                             count_text(std::size_t(plan.levels), "smoothing level") + ", " +
                             count_text(std::size_t(plan.pads_per_shape), "PAD") + " a shape; " +
                             count_text(std::size_t(plan.shapes_per_worker), "shape") + " a worker") +
         line("pieces", "about " + fixed(plan.pieces, 0)) + memory_text(input, plan) + line("time", time_text(plan)) +
         (input.settings.pieces.fit_all ? line("", "for a few attempts at sizes (pieces.fit), of 12 at most") : "") +
         line("checkpoint", "about " + megabytes(plan.checkpoint_bytes)) +
         "\nThe formulas were measured on one machine, with 234 to 12,940 shapes and 700 to 98,000 pieces; a worker "
         "has\n"
         "two CPU cores of 2 GHz. The run may well take half or twice the time; network and GPUs are not considered. "
         "In\n"
         "four runs the memory was 0.8 to 1.0 times and the filling 1.0 to 1.3 times the estimate. The memory\n"
         "includes " +
         megabytes(double(kKeptFreed_bytes)) + " of freed memory that each process may keep.\n";
}

std::string idle_workers_warning(const PlanInput& input, const PlanEstimate& plan) {
  if (std::size_t(plan.workers) <= input.shapes) return "";
  return "--ranks " + std::to_string(input.ranks) + ": " +
         count_text(std::size_t(plan.workers), "worker divides", "workers divide") + " " +
         count_text(input.shapes, "shape") + ", so that some have none; --ranks " + std::to_string(input.shapes + 1) +
         " is as good";
}

std::string sbatch_header(const PlanInput& input, const PlanEstimate& plan) {
  const double memory_bytes = std::ceil(kMemoryMargin * plan.node_bytes / kMemoryStep_bytes) * kMemoryStep_bytes;
  const double limit_s = std::ceil((kTimeMargin * plan.total_s + kWarning_s) / kTimeStep_s) * kTimeStep_s;
  std::string text =
      "#SBATCH --nodes=" + std::to_string(input.nodes) + "\n#SBATCH --ntasks=" + std::to_string(input.ranks) + "\n";
  if (input.nodes > 1) text += "#SBATCH --ntasks-per-node=" + std::to_string(plan.ranks_per_node) + "\n";
  text += "#SBATCH --mem=" + fixed(memory_bytes / 1e6, 0) + "M\n#SBATCH --time=" + slurm_time(limit_s) +
          "\n#SBATCH --signal=B:USR2@" + std::to_string(kWarning_s) + "\n";
  text += input.host_devices ? "#SBATCH --cpus-per-task=2\n"
                             : "#SBATCH --gres=gpu:" + std::to_string(plan.workers_per_node) + "\n";
  return text;
}

}  // namespace tessera
