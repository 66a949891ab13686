#include "core/quality/quality.h"

#include <algorithm>
#include <filesystem>

#include "bench/benchmarks.h"
#include "bench/devices.h"
#include "bench/inputs/library_matcher.h"
#include "bench/line_plot.h"
#include "core/base/error.h"
#include "core/base/rank_pool.h"
#include "core/replacing/own_replacer.h"
#include "library/library_shapes.h"
#include "library/storage/library_file.h"
#include "master/collage_loop.h"
#include "text/number_text.h"
#include "text/text_table.h"

namespace tessera::bench {
namespace {

/// 1, 2, 4 and so on below `last`, then `last`.
std::vector<double> marks_up_to(int last) {
  std::vector<double> marks;
  for (int mark = 1; mark < last; mark *= 2) marks.push_back(mark);
  marks.push_back(last);
  return marks;
}

/// A run of its own with this much time, as improving plans with the time that it has.
master::CollageResult improved(const Canvas& canvas, CollageSettings settings, Matcher& matcher, ShapeSource& shapes,
                               double seconds) {
  settings.improve.seconds = seconds;
  settings.stop.seconds = seconds;
  OwnReplacer replacer(shapes, rank_pool(), [] {});
  master::SilentObserver silent;
  return master::make_collage(canvas, settings, matcher, shapes, silent, {}, &replacer);
}

struct Way {
  const char* name;
  bool relax;
};
constexpr Way kWays[] = {{"pieces that move and are exchanged", true}, {"ruin and recreate alone", false}};

void add_row(const Way& way, const RunStatistics& s, const Quality& q, TextTable& table, Json& rows) {
  table.add({way.name, fixed(s.total_s, 1), std::to_string(s.trials), fixed(100 * q.coverage, 2),
             fixed(100 * q.overlap, 3), q.balance ? fixed(q.balance->evenness, 2) : "-", std::to_string(q.pieces),
             std::to_string(q.distinct_shapes)});
  rows.push_back({{"relax", way.relax},
                  {"seconds", rounded(s.total_s)},
                  {"trials", s.trials},
                  {"coverage_percent", rounded(100 * q.coverage)},
                  {"overlap_percent", rounded(100 * q.overlap)},
                  {"size_balance", q.balance ? Json(rounded(q.balance->evenness)) : Json()},
                  {"pieces", q.pieces},
                  {"distinct_shapes", q.distinct_shapes}});
}

Report empty_report(const Setting& setting, const SquareJob& job, std::size_t shapes, int size_px) {
  Report report;
  report.json = report_head("quality", setting);
  report.json.update({{"library", job.library},
                      {"shapes", shapes},
                      {"canvas_px", size_px},
                      {"scale_px", job.scale_px},
                      {"seed", job.seed},
                      {"rows", Json::array()}});
  return report;
}

std::string explanation(const SquareJob& job, std::size_t shapes, int size_px) {
  return "\n" + std::to_string(shapes) + " shapes, " + std::to_string(size_px) + " x " + std::to_string(size_px) +
         " px, pieces of " + short_number(job.scale_px[0]) + " to " + short_number(job.scale_px[1]) + " px, seed " +
         std::to_string(job.seed) +
         "; each row is a run of its own, start-up is not counted.\nPieces move together where the largest is "
         "at most five times the smallest; elsewhere both are the same.\n";
}

/// The table and the curves of the report, to which each run adds a row and two points.
struct Shown {
  TextTable table{{"improving by", "s", "trials", "coverage %", "overlap %", "balance", "pieces", "shapes"}};
  Panel open{"What is not covered", "seconds", "% of the canvas", true, 64, {}};
  Panel balance{"Balance of sizes", "seconds", "1 = even", false, 1, {}};

  void begin(const Way& way) {
    open.curves.push_back({way.name, {}, false});
    balance.curves.push_back({way.name, {}, false});
  }

  void add(const Way& way, const RunStatistics& run, const Quality& q, Json& rows) {
    add_row(way, run, q, table, rows);
    const double at_s = std::max(1., run.total_s);
    open.curves.back().points.emplace_back(at_s, 100 * (1 - q.coverage));
    balance.curves.back().points.emplace_back(at_s, q.balance ? q.balance->evenness : 0);
  }
};

}  // namespace

Report bench_quality(const Setting& setting, const SquareJob& job, int seconds) {
  check(job);
  if (seconds < 1 || seconds > 3600) {
    throw InputError("--seconds: found " + std::to_string(seconds) + "; allowed: 1 to 3600 s");
  }
  const std::string plot = std::filesystem::path(setting.out).replace_extension().string();
  if (!plot.empty()) check_plot_can_be_written(plot);
  const LibraryFile library(job.library);
  const int size_px = setting.quick ? std::min(job.size_px, 160) : job.size_px;
  CollageSettings settings;
  settings.seed = job.seed;
  settings.pieces.min_scale_px = job.scale_px[0];
  settings.pieces.max_scale_px = job.scale_px[1];
  LibraryShapes shapes(library);
  const Canvas canvas = make_rectangle_canvas(size_px, size_px);

  Report report = empty_report(setting, job, library.size(), size_px);
  Shown shown;
  for (const Way& way : kWays) {
    settings.improve.relax = way.relax;
    const auto matcher = library_matcher(library, library.size(), settings, setting.devices);
    shown.begin(way);
    for (const double mark_s : marks_up_to(setting.quick ? 2 : seconds)) {
      const master::CollageResult made = improved(canvas, settings, *matcher, shapes, mark_s);
      const Quality q = measure_quality(
          canvas, made.placements, [&](ShapeId id) -> const Shape& { return shapes.shape(id); },
          SizeRange{job.scale_px[0], job.scale_px[1]});
      shown.add(way, made.statistics, q, report.json["rows"]);
    }
  }
  if (!plot.empty()) write_plot({shown.open, shown.balance}, plot);
  report.text = shown.table.text() + explanation(job, library.size(), size_px);
  return report;
}

}  // namespace tessera::bench
