// scaling_sim REPORT.json: how a job would scale on a larger cluster, from the measurements of `tessera bench scaling`.
// First the model beside the runs it was made from, then the prediction; CSV and a plot beside the table.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "bench/line_plot.h"
#include "bench/report.h"
#include "bench/round_model.h"
#include "bench_main.h"
#include "files/atomic_file.h"
#include "protocol_sim.h"
#include "result/collage_files.h"
#include "text/number_text.h"
#include "text/text_table.h"

namespace tessera::bench {
namespace {

struct Options {
  std::vector<std::string> reports;
  std::string out = "out/scaling_sim";
  std::vector<int> hosts = {1, 2, 4, 8, 16, 32, 64, 128, 256, 512};
  std::vector<std::uint64_t> shapes = {10'000, 100'000, 1'000'000};
  int fan_out = kFanOut;
  double latency_us = 2;
  double gigabytes_per_s = 10;
  double worker_speed = 1;
  double master_speed = 1;
  bool processor_time = false;
};

struct Job {
  int workers;
  std::uint64_t shapes;
};

struct Prediction {
  Job job;
  SimulatedRound tree;  // as it is
  SimulatedRound star;  // if the master asked all itself
};

Options parsed(int argc, char** argv) {
  Options options;
  CLI::App app("How a job would scale on a larger cluster, simulated.", "scaling_sim");
  app.add_option("REPORT", options.reports, "JSON files of tessera bench scaling: the same canvas and pieces")
      ->required()
      ->type_name("FILE.json");
  app.add_option("--out", options.out, "Names of the CSV and the plot, without ending")->capture_default_str();
  app.add_option("--hosts", options.hosts, "Numbers of workers, a host each")
      ->check(CLI::PositiveNumber)
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--shapes", options.shapes, "Sizes of the library")->delimiter(',')->capture_default_str();
  app.add_option("--fan-out", options.fan_out, "Workers that a rank asks itself")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--latency-us", options.latency_us, "From host to host")->capture_default_str();
  app.add_option("--gigabytes-per-s", options.gigabytes_per_s, "Of a link, each way")->capture_default_str();
  app.add_option("--worker-speed", options.worker_speed, "A host's devices, in workers as they were measured")
      ->capture_default_str();
  app.add_option("--master-speed", options.master_speed,
                 "What if the master's serial work, asking left out, were so many times as fast")
      ->capture_default_str();
  app.add_flag("--processor-time", options.processor_time,
               "Model the processor time of the runs: where other programs took part of the cores");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error));
  }
  std::sort(options.hosts.begin(), options.hosts.end());
  if (options.hosts.empty() || options.hosts.front() != 1) options.hosts.insert(options.hosts.begin(), 1);
  return options;
}

std::vector<Job> jobs_of(const Options& options) {
  std::vector<Job> jobs;
  for (const std::uint64_t shapes : options.shapes) {
    for (const int hosts : options.hosts) jobs.push_back({hosts, shapes});
  }
  return jobs;
}

double efficiency(const SimulatedRound& one, const SimulatedRound& many, int hosts) {
  return one.round_s / many.round_s / hosts;
}

std::vector<ScalingCase> cases_of(const std::vector<std::string>& reports) {
  std::vector<ScalingCase> cases;
  for (const std::string& report : reports) {
    for (const ScalingCase& c : read_scaling_cases(report)) cases.push_back(c);
  }
  return cases;
}

RoundCosts costs_of(const RoundModel& model, const Job& job, const Options& options) {
  RoundCosts costs = model.costs(job.workers, job.shapes);
  costs.master_s /= options.master_speed;
  for (double* stage_s : {&costs.field_s, &costs.count_s, &costs.dock_s, &costs.refine_s, &costs.measure_s}) {
    *stage_s /= options.worker_speed;
  }
  return costs;
}

std::string validation(const RoundModel& model, const std::vector<SimulatedRound>& rounds) {
  TextTable table({"measured", "shapes", "loop s", "model s", "error %"});
  for (std::size_t i = 0; i < rounds.size(); ++i) {
    const ScalingCase& c = model.cases()[i];
    const double model_s = rounds[i].round_s * c.rounds;
    table.add({std::to_string(c.workers) + (c.workers == 1 ? " worker" : " workers"), std::to_string(c.shapes),
               fixed(c.loop_s, 3), fixed(model_s, 3), fixed(100 * (model_s / c.loop_s - 1), 1)});
  }
  return table.text();
}

std::string prediction_table(const std::vector<Prediction>& predictions, double pieces_of_a_round) {
  TextTable table(
      {"shapes", "hosts", "ms a round", "ms a piece", "speed-up", "efficiency", "master busy %", "asking all itself"});
  const Prediction* one = nullptr;
  for (const Prediction& p : predictions) {
    if (p.job.workers == 1) one = &p;
    const double e = efficiency(one->tree, p.tree, p.job.workers);
    table.add({std::to_string(p.job.shapes), std::to_string(p.job.workers), fixed(1000 * p.tree.round_s, 2),
               fixed(1000 * p.tree.round_s / pieces_of_a_round, 2), fixed(e * p.job.workers, 1), fixed(e, 3),
               fixed(100 * p.tree.master_busy_s / p.tree.round_s, 1),
               fixed(efficiency(one->tree, p.star, p.job.workers), 3)});
  }
  return table.text();
}

std::string csv(const std::vector<Prediction>& predictions) {
  std::string text = "shapes,hosts,round_s,master_busy_s,asking_all_round_s,asking_all_master_busy_s\n";
  for (const Prediction& p : predictions) {
    text += std::to_string(p.job.shapes) + "," + std::to_string(p.job.workers);
    for (const double s : {p.tree.round_s, p.tree.master_busy_s, p.star.round_s, p.star.master_busy_s}) {
      text += "," + fixed(s, 9);
    }
    text += "\n";
  }
  return text;
}

void plot(const std::vector<Prediction>& predictions, const Options& options) {
  const double most = options.hosts.back();
  Panel speed{"Predicted speed-up", "hosts", "times as fast", true, std::max(2., most), {}};
  Panel share{"Predicted efficiency", "hosts", "of the ideal", false, 1.2, {}};
  speed.curves.push_back({"ideal", {{1, 1}, {most, most}}, true});
  share.curves.push_back({"ideal", {{1, 1}, {most, 1}}, true});
  for (std::size_t i = 0; i < predictions.size();) {
    const Prediction& one = predictions[i];
    const std::string name = std::to_string(one.job.shapes) + " shapes";
    PlotCurve faster{name, {}, false};
    PlotCurve efficient{name, {}, false};
    for (; i < predictions.size() && predictions[i].job.shapes == one.job.shapes; ++i) {
      const int hosts = predictions[i].job.workers;
      const double e = efficiency(one.tree, predictions[i].tree, hosts);
      faster.points.emplace_back(hosts, e * hosts);
      efficient.points.emplace_back(hosts, e);
    }
    speed.curves.push_back(faster);
    share.curves.push_back(efficient);
  }
  write_plot({speed, share}, options.out);
}

void run(const Options& options) {
  const RoundModel model(cases_of(options.reports), options.processor_time ? Clock::processor : Clock::wall);
  const Cluster cluster{options.latency_us * 1e-6, options.gigabytes_per_s * 1e9};
  std::vector<Scenario> scenarios;
  for (const ScalingCase& c : model.cases()) {
    scenarios.push_back({model.costs(c.workers, c.shapes)});
  }
  const std::vector<Job> jobs = jobs_of(options);
  for (const Job& job : jobs) {
    const RoundCosts costs = costs_of(model, job, options);
    scenarios.push_back({costs, options.fan_out});
    scenarios.push_back({costs, job.workers});
  }
  const std::vector<SimulatedRound> rounds = simulate_rounds(scenarios, cluster);

  const auto measured = std::ptrdiff_t(model.cases().size());
  std::vector<Prediction> predictions;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    predictions.push_back({jobs[i], rounds[std::size_t(measured) + 2 * i], rounds[std::size_t(measured) + 2 * i + 1]});
  }
  prepare_output_directory(std::filesystem::absolute(options.out).parent_path().string());
  write_file_atomically(options.out + ".csv", csv(predictions));
  plot(predictions, options);
  std::printf("%s\n%s\nwritten to %s.csv, .svg and .png\n",
              validation(model, {rounds.begin(), rounds.begin() + measured}).c_str(),
              prediction_table(predictions, model.pieces_of_a_round()).c_str(), options.out.c_str());
}

}  // namespace
}  // namespace tessera::bench

int main(int argc, char** argv) {
  using namespace tessera::bench;
  return exit_code_of("scaling_sim", [&] { run(parsed(argc, argv)); });
}
