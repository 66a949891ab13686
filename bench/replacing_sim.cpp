// replacing_sim REPORT.json: how replacement trials would scale on a larger cluster, from a batch that
// `tessera bench replacing` measured.
#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>

#include "batch_sim.h"
#include "bench_main.h"
#include "text/number_text.h"
#include "text/text_table.h"

namespace tessera::bench {
namespace {

struct Options {
  std::string report;
  std::vector<int> hosts = {1, 2, 4, 8, 16, 32, 64, 128};
  std::vector<int> cores = {1, 2, 8};
  double latency_us = 2;
  double gigabytes_per_s = 10;
};

Options parsed(int argc, char** argv) {
  Options options;
  CLI::App app("How replacement trials would scale on a larger cluster, simulated.", "replacing_sim");
  app.add_option("REPORT", options.report, "JSON file of tessera bench replacing")->required()->type_name("FILE.json");
  app.add_option("--hosts", options.hosts, "Numbers of workers, a host each, beside the master's")
      ->check(CLI::Range(1, 4096))
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--cores", options.cores, "Cores of each")
      ->check(CLI::Range(1, 4096))
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--latency-us", options.latency_us, "From host to host")->capture_default_str();
  app.add_option("--gigabytes-per-s", options.gigabytes_per_s, "Of a link, each way")->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error));
  }
  return options;
}

void run(const Options& options) {
  const ReplacingCase measured = read_replacing_case(options.report);
  std::vector<BatchScenario> scenarios;
  for (const int cores : options.cores) {
    for (const int hosts : options.hosts) scenarios.push_back({&measured, hosts, cores});
  }
  const std::vector<SimulatedBatch> batches =
      simulate_batches(scenarios, {options.latency_us * 1e-6, options.gigabytes_per_s * 1e9});
  TextTable table({"hosts", "cores each", "a batch, ms", "trials a second", "efficiency", "master busy %"});
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    const auto& [of_case, hosts, cores, fan_out] = scenarios[i];
    // Beside one core that has nobody to ask and nothing to wait for.
    const double alone_s = measured.work_s() + measured.master_s;
    const double batch_s = batches[i].batch_s;
    table.add({std::to_string(hosts), std::to_string(cores), fixed(1000 * batch_s, 1),
               fixed(double(measured.trials()) / batch_s, 0), fixed(alone_s / batch_s / (hosts * cores), 3),
               fixed(100 * batches[i].master_busy_s / batch_s, 1)});
  }
  std::printf("%zu windows, %llu trials, %d x %d px\n%s", measured.windows.size(),
              static_cast<unsigned long long>(measured.trials()), measured.canvas_px, measured.canvas_px,
              table.text().c_str());
}

}  // namespace
}  // namespace tessera::bench

int main(int argc, char** argv) {
  using namespace tessera::bench;
  return exit_code_of("replacing_sim", [&] { run(parsed(argc, argv)); });
}
