#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

#include "bench/amdahl.h"
#include "bench/baselines/program_run.h"
#include "bench/benchmarks.h"
#include "bench/devices.h"
#include "bench/inputs/enlarged_library.h"
#include "bench/line_plot.h"
#include "bench/scaling_case.h"
#include "core/base/count_text.h"
#include "core/base/error.h"
#include "files/atomic_file.h"
#include "result/collage_files.h"
#include "result/folder/result_file.h"
#include "text/number_text.h"
#include "text/text_table.h"

namespace tessera::bench {
namespace {

namespace fs = std::filesystem;

constexpr int kMostRanks = 10'000;

/// Runs of one case: the same number of workers, the same library.
struct Repeated {
  int workers = 1;
  std::uint32_t shapes = 0;
  std::vector<std::pair<ScalingCase, Json>> runs;  // with section "ranks" of the card

  const std::pair<ScalingCase, Json>& median() const { return runs[runs.size() / 2]; }
  const ScalingCase& typical() const { return median().first; }
};

struct Plan {
  ScalingOptions options;
  std::string devices;
  std::vector<int> workers;           // ascending
  std::vector<std::uint32_t> shapes;  // ascending
  std::string folder;                 // for the runs
};

void check(const ScalingOptions& options) {
  if (std::getenv("OMPI_COMM_WORLD_SIZE")) {
    throw InputError("bench scaling starts mpirun itself: give it without mpirun");
  }
  for (const int ranks : options.ranks) {
    if (ranks < 2 || ranks > kMostRanks) {
      throw InputError("--ranks: found " + std::to_string(ranks) + "; allowed: 2 to " + std::to_string(kMostRanks) +
                       ", one of them the master");
    }
  }
  if (options.repeats < 1)
    throw InputError("--repeats: found " + std::to_string(options.repeats) + "; allowed: from 1");
}

/// The sizes of the weak scaling: the given number for the most workers, and a proportional share for fewer workers.
std::vector<std::uint32_t> weak_sizes(std::uint32_t shapes, const std::vector<int>& workers) {
  std::set<std::uint32_t> sizes;
  for (const int w : workers) {
    sizes.insert(std::max<std::uint32_t>(
        1, std::uint32_t(std::uint64_t(shapes) * std::uint64_t(w) / std::uint64_t(workers.back()))));
  }
  return {sizes.begin(), sizes.end()};
}

/// Reduces the options for a quick run; those that were given stay.
void make_small(ScalingOptions& options) {
  const ScalingOptions defaults;
  if (options.shapes == defaults.shapes) options.shapes = 12;
  if (options.pieces == defaults.pieces) options.pieces = 3;
  if (options.size_px == defaults.size_px) options.size_px = 200;
  if (options.repeats == defaults.repeats) options.repeats = 1;
}

Plan make_plan(const Setting& setting, const ScalingOptions& options, std::size_t library_shapes) {
  Plan plan{options, setting.devices, {}, {}, fs::path(setting.out).replace_extension().string()};
  if (setting.quick) make_small(plan.options);
  std::set<int> workers;
  for (const int ranks : options.ranks) workers.insert(ranks - 1);
  plan.workers.assign(workers.begin(), workers.end());
  const std::uint32_t shapes = plan.options.shapes > 0 ? plan.options.shapes : std::uint32_t(library_shapes);
  plan.shapes = weak_sizes(shapes, plan.workers);
  return plan;
}

/// Paths of the libraries by size; a library of another size is written beside the runs.
std::map<std::uint32_t, std::string> libraries_of_sizes(const Plan& plan, const LibraryFile& library) {
  std::map<std::uint32_t, std::string> paths;
  for (const std::uint32_t shapes : plan.shapes) {
    if (shapes == library.size()) {
      paths[shapes] = fs::absolute(library.path()).string();
      continue;
    }
    paths[shapes] = fs::absolute(plan.folder + "/shapes_" + std::to_string(shapes) + ".h5").string();
    write_library_of_size(library, shapes, paths[shapes]);
  }
  return paths;
}

std::string write_job(const Plan& plan, const std::string& library) {
  const std::string path = plan.folder + "/job.toml";
  const std::string side = std::to_string(plan.options.size_px);
  write_file_atomically(path, "[library]\nfile = \"" + library + "\"\n[canvas]\nsize_px = [" + side + ", " + side +
                                  "]\n[stop]\npieces = " + std::to_string(plan.options.pieces) +
                                  "\n[improve]\ntrials = 0\n[devices]\nuse = \"" + plan.devices +
                                  "\"\n[output]\nwidth_px = 64\n");
  return path;
}

std::string result_folder(const Plan& plan, int workers, std::uint32_t shapes) {
  return plan.folder + "/workers_" + std::to_string(workers) + "_shapes_" + std::to_string(shapes);
}

Json run_once(const Plan& plan, int workers, std::uint32_t shapes, const std::string& library) {
  std::vector<std::string> command = words_of(plan.options.launcher);
  const std::string out = result_folder(plan, workers, shapes);
  command.insert(command.end(), {"-n", std::to_string(workers + 1), plan.options.program, "collage",
                                 write_job(plan, library), "--quiet", "--out", out});
  run_program(command);
  const Json card = Json::parse(read_result_file(out, "card.json"));
  Json ranks = card.at("ranks");
  ranks["pieces"] = card.at("quality").at("pieces");
  return ranks;
}

void check_same_pieces(const Plan& plan) {
  for (const std::uint32_t shapes : plan.shapes) {
    const auto pieces = [&](int workers) {
      return read_result_file(result_folder(plan, workers, shapes), "pieces.geojson");
    };
    for (const int workers : plan.workers) {
      if (pieces(workers) != pieces(plan.workers.front())) {
        throw EnvironmentError("pieces.geojson of " + result_folder(plan, workers, shapes) + " differs from that of " +
                               std::to_string(plan.workers.front()) + " worker");
      }
    }
  }
}

/// Runs all cases in turn, repeatedly, so that other work on the machine affects all of them equally.
std::vector<Repeated> run_all(const Plan& plan, const LibraryFile& library) {
  const std::map<std::uint32_t, std::string> libraries = libraries_of_sizes(plan, library);
  std::vector<Repeated> cases;
  for (const std::uint32_t shapes : plan.shapes) {
    for (const int workers : plan.workers) cases.push_back({workers, shapes, {}});
  }
  const Repeated& smallest = cases.front();
  run_once(plan, smallest.workers, smallest.shapes, libraries.at(smallest.shapes));  // compiles the kernels
  for (int repeat = 0; repeat < plan.options.repeats; ++repeat) {
    for (Repeated& c : cases) {
      Json ranks = run_once(plan, c.workers, c.shapes, libraries.at(c.shapes));
      c.runs.emplace_back(scaling_case(ranks, c.shapes, "card.json"), std::move(ranks));
    }
  }
  for (Repeated& c : cases) {
    std::sort(c.runs.begin(), c.runs.end(),
              [](const auto& a, const auto& b) { return a.first.loop_s < b.first.loop_s; });
  }
  check_same_pieces(plan);
  return cases;
}

const Repeated* find_case(const std::vector<Repeated>& cases, int workers, std::uint32_t shapes) {
  const auto found = std::find_if(cases.begin(), cases.end(),
                                  [&](const Repeated& c) { return c.workers == workers && c.shapes == shapes; });
  return found == cases.end() ? nullptr : &*found;
}

/// The median of `figure` over the runs.
template <class Figure>
double median_of(const Repeated& c, Figure figure) {
  std::vector<double> values;
  for (const auto& [run, ranks] : c.runs) values.push_back(figure(run));
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double loop_s(const Repeated& c) {
  return median_of(c, [](const ScalingCase& run) { return run.loop_s; });
}
double undisturbed_s(const Repeated& c) {
  return median_of(c, [](const ScalingCase& run) { return run.undisturbed_s(); });
}
double master_percent(const Repeated& c) {
  return median_of(c, [](const ScalingCase& run) { return 100 * run.serial_s() / run.loop_s; });
}
double undisturbed_master_percent(const Repeated& c) {
  return median_of(c, [](const ScalingCase& run) { return 100 * run.master_processor_s / run.undisturbed_s(); });
}

/// A case and the case with the fewest workers, with which it is compared.
struct Compared {
  const Repeated* base;
  const Repeated* run;

  double more_workers() const { return double(run->workers) / base->workers; }
};

std::vector<Compared> strong_series(const std::vector<Repeated>& cases, const Plan& plan, std::uint32_t shapes) {
  std::vector<Compared> series;
  const Repeated* base = find_case(cases, plan.workers.front(), shapes);
  for (const int workers : plan.workers) series.push_back({base, find_case(cases, workers, shapes)});
  return series;
}

std::vector<Compared> weak_series(const std::vector<Repeated>& cases, const Plan& plan) {
  std::vector<Compared> series;
  for (const int workers : plan.workers) {
    const std::uint32_t shapes = weak_sizes(plan.shapes.back(), {workers, plan.workers.back()}).front();
    const Repeated* run = find_case(cases, workers, shapes);
    series.push_back({series.empty() ? run : series.front().base, run});
  }
  return series;
}

AmdahlFit fit(const std::vector<Compared>& strong, double (*seconds)(const Repeated&)) {
  std::vector<TimedRun> runs;
  for (const Compared& c : strong) runs.push_back({c.run->workers, seconds(*c.run)});
  return fit_amdahl(runs);
}

std::string case_rows(const std::vector<Compared>& series, bool weak) {
  TextTable table({weak ? "weak" : "strong", "shapes", "loop s", "speed-up", "efficiency", "undisturbed s", "speed-up",
                   "master %", "undisturbed"});
  for (const Compared& c : series) {
    const double growth = weak ? c.more_workers() : 1;  // growth of the work
    const double speed_up = growth * loop_s(*c.base) / loop_s(*c.run);
    const double quiet_speed_up = growth * undisturbed_s(*c.base) / undisturbed_s(*c.run);
    table.add({count_text(std::size_t(c.run->workers), "worker"), std::to_string(c.run->shapes),
               fixed(loop_s(*c.run), 3), fixed(speed_up, 2), fixed(speed_up / c.more_workers(), 2),
               fixed(undisturbed_s(*c.run), 3), fixed(quiet_speed_up, 2), fixed(master_percent(*c.run), 1),
               fixed(undisturbed_master_percent(*c.run), 1)});
  }
  return table.text();
}

Json case_json(const Repeated& c) {
  Json loops = Json::array();
  for (const auto& [run, ranks] : c.runs) loops.push_back(rounded(run.loop_s));
  return {{"workers", c.workers},
          {"shapes", c.shapes},
          {"loop_s", rounded(loop_s(c))},
          {"undisturbed_s", rounded(undisturbed_s(c))},
          {"loops_s", loops},
          {"master_percent", rounded(master_percent(c))},
          {"undisturbed_master_percent", rounded(undisturbed_master_percent(c))},
          {"ranks", c.median().second}};
}

Json series_json(const std::vector<Compared>& series, bool weak) {
  Json json = Json::array();
  for (const Compared& c : series) {
    const double growth = weak ? c.more_workers() : 1;
    const double speed_up = growth * loop_s(*c.base) / loop_s(*c.run);
    json.push_back({{"workers", c.run->workers},
                    {"shapes", c.run->shapes},
                    {"speed_up", rounded(speed_up)},
                    {"efficiency", rounded(speed_up / c.more_workers())},
                    {"undisturbed_speed_up", rounded(growth * undisturbed_s(*c.base) / undisturbed_s(*c.run))}});
  }
  return json;
}

Json fit_json(const AmdahlFit& fit) {
  return {{"serial_s", rounded(fit.serial_s)},
          {"parallel_s", rounded(fit.parallel_s)},
          {"serial_percent", rounded(100 * fit.serial_share())}};
}

std::string csv(const std::vector<Repeated>& cases) {
  std::string text =
      "workers,shapes,loop_s,undisturbed_s,master_serial_s,worker_count_s,worker_dock_s,worker_refine_s,"
      "worker_messages_s,worker_busiest_s,bytes_to_worker,bytes_from_worker\n";
  for (const Repeated& c : cases) {
    const ScalingCase& t = c.typical();
    text += std::to_string(c.workers) + "," + std::to_string(c.shapes);
    for (const double value :
         {t.loop_s, t.undisturbed_s(), t.serial_s(), t.count_s, t.dock_s, t.refine_s, t.messages_s, t.busiest_s}) {
      text += "," + fixed(value, 6);
    }
    text += "," + fixed(t.bytes_to_worker, 0) + "," + fixed(t.bytes_from_worker, 0) + "\n";
  }
  return text;
}

PlotCurve speed_up_curve(const std::string& name, const std::vector<Compared>& series, bool weak, bool efficiency) {
  PlotCurve curve{name, {}, false};
  for (const Compared& c : series) {
    const double growth = weak ? c.more_workers() : 1;
    const double speed_up = growth * loop_s(*c.base) / loop_s(*c.run);
    curve.points.emplace_back(c.more_workers(), efficiency ? speed_up / c.more_workers() : speed_up);
  }
  return curve;
}

void plot(const std::vector<Compared>& strong, const std::vector<Compared>& weak, const std::string& path) {
  const double most = strong.back().more_workers();
  const std::string times = "times as many workers";
  Panel speed{"Speed-up", times, "times as fast", true, std::max(2., most), {}};
  Panel efficiency{"Efficiency", times, "of the ideal", false, 1.2, {}};
  speed.curves.push_back({"ideal", {{1, 1}, {most, most}}, true});
  efficiency.curves.push_back({"ideal", {{1, 1}, {most, 1}}, true});
  for (const bool is_weak : {false, true}) {
    const std::string name = is_weak ? "weak: shapes grow with the workers" : "strong: the same shapes";
    speed.curves.push_back(speed_up_curve(name, is_weak ? weak : strong, is_weak, false));
    efficiency.curves.push_back(speed_up_curve(name, is_weak ? weak : strong, is_weak, true));
  }
  write_plot({speed, efficiency}, path);
}

/// The text about Amdahl's law. Needs long loops and at least two numbers of workers: otherwise a line fits anything.
std::string amdahl_text(const Plan& plan, bool quick, const AmdahlFit& wall, const AmdahlFit& quiet) {
  if (quick || plan.workers.size() < 2) return "";
  return " Amdahl, strong: serial " + fixed(100 * wall.serial_share(), 1) + " % of one worker's loop, undisturbed " +
         fixed(100 * quiet.serial_share(), 1) + " %.";
}

std::string explanation(const Plan& plan, const std::string& amdahl) {
  return "Medians of " + std::to_string(plan.options.repeats) + " loops of " + std::to_string(plan.options.pieces) +
         " pieces on " + std::to_string(plan.options.size_px) + " x " + std::to_string(plan.options.size_px) +
         " px. Undisturbed: the master's processor time and\nthe busiest worker's, which is what other programs do not "
         "lengthen. Master %: its share of the loop while the workers\nwait." +
         amdahl + "\n";
}

}  // namespace

Report bench_scaling(const Setting& setting, const ScalingOptions& options) {
  check(options);
  const LibraryFile library(options.library);
  const Plan plan = make_plan(setting, options, library.size());
  prepare_output_directory(plan.folder);
  check_can_be_written(plan.folder + ".csv");
  check_plot_can_be_written(plan.folder);
  setenv("POCL_MAX_PTHREAD_COUNT", "1", 0);  // one core for each worker
  const std::vector<Repeated> cases = run_all(plan, library);

  const std::vector<Compared> strong = strong_series(cases, plan, plan.shapes.back());
  const std::vector<Compared> weak = weak_series(cases, plan);
  const AmdahlFit wall = fit(strong, loop_s);
  const AmdahlFit quiet = fit(strong, undisturbed_s);
  write_file_atomically(plan.folder + ".csv", csv(cases));
  plot(strong, weak, plan.folder);

  Report report;
  report.json = report_head("scaling", setting);
  report.json.update({{"library", options.library},
                      {"canvas_px", plan.options.size_px},
                      {"pieces", plan.options.pieces},
                      {"strong", series_json(strong, false)},
                      {"weak", series_json(weak, true)},
                      {"amdahl", fit_json(wall)},
                      {"amdahl_undisturbed", fit_json(quiet)},
                      {"cases", Json::array()}});
  for (const Repeated& c : cases) report.json["cases"].push_back(case_json(c));
  report.text = case_rows(strong, false) + "\n" + case_rows(weak, true) + "\n" +
                explanation(plan, amdahl_text(plan, setting.quick, wall, quiet));
  return report;
}

}  // namespace tessera::bench
