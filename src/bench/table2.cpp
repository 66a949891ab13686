#include <algorithm>
#include <cmath>

#include "bench/benchmarks.h"
#include "bench/devices.h"
#include "bench/inputs/library_matcher.h"
#include "bench/table2_rows.h"
#include "core/base/error.h"
#include "core/base/stop.h"
#include "core/field/canvas.h"
#include "core/matching/matcher.h"
#include "library/library_shapes.h"
#include "master/collage_loop.h"
#include "text/number_text.h"
#include "text/text_table.h"

namespace tessera::bench {
namespace {

// Rule for the range of scales: start with scales at which the engine fills a canvas with about that many pieces; while
// it is full before, take smaller ones.
constexpr float kFirstMaxScale = 2.25f;  // times the square root of the canvas' area for each piece
constexpr float kScaleRatio = 8;
constexpr float kSmaller = 0.85f;
constexpr int kMostTries = 12;
constexpr float kLeastScale_px = 2;

struct SizedRun {
  master::CollageResult result;
  PieceSettings pieces;
  int tries = 0;
  std::size_t candidates = 0;
};

SizedRun run_row(const Table2Row& row, const LibraryFile& library, const Canvas& canvas,
                 const std::string& devices_use) {
  SizedRun run;
  run.candidates = std::min<std::size_t>(library.size(), std::size_t(row.candidates));
  CollageSettings settings;
  settings.stop.pieces = row.iterations;
  settings.pieces.max_scale_px = kFirstMaxScale * std::sqrt(float(canvas.area_px2) / float(row.iterations));
  do {
    if (run.tries++ > 0) settings.pieces.max_scale_px *= kSmaller;
    settings.pieces.min_scale_px = std::max(kLeastScale_px, settings.pieces.max_scale_px / kScaleRatio);
    const auto matcher = library_matcher(library, run.candidates, settings, devices_use);
    LibraryShapes shapes(library);
    master::SilentObserver silent;
    run.result = master::make_collage(canvas, settings, *matcher, shapes, silent);
  } while (run.result.statistics.stopped_by != StopReason::pieces && run.tries < kMostTries);
  run.pieces = settings.pieces;
  return run;
}

std::vector<Table2Row> chosen_rows(const std::vector<std::string>& names) {
  std::vector<Table2Row> chosen;
  std::string allowed;
  for (const Table2Row& row : table2_rows()) {
    if (names.empty() || std::find(names.begin(), names.end(), row.figure) != names.end()) chosen.push_back(row);
    allowed += (allowed.empty() ? "" : ", ") + std::string(row.figure);
  }
  for (const std::string& name : names) {
    const auto same = [&](const Table2Row& row) { return row.figure == name; };
    if (std::none_of(chosen.begin(), chosen.end(), same)) {
      throw InputError("--rows: found \"" + name + "\"; allowed: " + allowed);
    }
  }
  return chosen;
}

struct StagePercents {
  double prune, dock, objective, merge;
};

StagePercents stage_percents(const RunStatistics& run) {
  const double whole_s = std::max(1e-9, run.prune_s + run.dock_s + run.objective_s + run.merge_s);
  return {100 * run.prune_s / whole_s, 100 * run.dock_s / whole_s, 100 * run.objective_s / whole_s,
          100 * run.merge_s / whole_s};
}

double filled_fraction(const SizedRun& run, const Canvas& canvas) {
  double area_px2 = 0;
  for (const Placement& p : run.result.placements) {
    area_px2 += double(p.canvas_from_shape.scale()) * p.canvas_from_shape.scale();
  }
  return area_px2 / canvas.area_px2;
}

Json paper_json(const Table2Row& row) {
  return {{"candidates", row.candidates},
          {"pads_per_shape", row.pads_per_shape},
          {"iterations", row.iterations},
          {"docking_choices", row.docking_choices},
          {"pruned_percent", row.pruned_percent},
          {"total_s", row.total_min * 60},
          {"prune_share_percent", row.prune_percent},
          {"dock_share_percent", row.dock_percent},
          {"objective_share_percent", row.objective_percent},
          {"merge_share_percent", row.merge_percent}};
}

Json run_json(const SizedRun& run, const Canvas& canvas) {
  const RunStatistics& s = run.result.statistics;
  const StagePercents share = stage_percents(s);
  return {{"candidates", run.candidates},
          {"pads_per_shape", s.pads_per_shape},
          {"iterations", run.result.placements.size()},  // the paper's place a piece each
          {"rounds", s.rounds},
          {"docking_choices", s.docking_choices},
          {"pruned_percent", rounded(100 * s.pruned_fraction())},
          {"total_s", rounded(s.total_s)},
          {"prune_share_percent", rounded(share.prune)},
          {"dock_share_percent", rounded(share.dock)},
          {"objective_share_percent", rounded(share.objective)},
          {"merge_share_percent", rounded(share.merge)},
          {"scale_px", {rounded(run.pieces.min_scale_px), rounded(run.pieces.max_scale_px)}},
          {"tries", run.tries},
          {"stopped_by", stop_word(s.stopped_by.value())},
          {"filled_fraction", rounded(filled_fraction(run, canvas))}};
}

void add_lines(TextTable& table, const Table2Row& row, const SizedRun& run) {
  const RunStatistics& s = run.result.statistics;
  const StagePercents share = stage_percents(s);
  const std::string figure(row.figure);
  table.add({"Fig. " + figure + " ours", std::to_string(run.candidates), fixed(s.pads_per_shape, 0),
             std::to_string(run.result.placements.size()), short_number(double(s.docking_choices)),
             fixed(100 * s.pruned_fraction(), 2), fixed(s.total_s, 1), fixed(share.prune, 0), fixed(share.dock, 0),
             fixed(share.objective, 0), fixed(share.merge, 0)});
  table.add({"Fig. " + figure + " paper", std::to_string(row.candidates), std::to_string(row.pads_per_shape),
             std::to_string(row.iterations), std::string(row.docking_choices), fixed(row.pruned_percent, 2),
             fixed(row.total_min * 60, 1), std::to_string(row.prune_percent), std::to_string(row.dock_percent),
             std::to_string(row.objective_percent), std::to_string(row.merge_percent)});
}

/// Remarks on differences between the row and our run.
std::string remarks(const Table2Row& row, const SizedRun& run) {
  std::string text;
  const std::string figure = "Fig. " + std::string(row.figure) + ": ";
  if (run.candidates < std::size_t(row.candidates)) {
    text += figure + "the library has " + std::to_string(run.candidates) + " shapes of " +
            std::to_string(row.candidates) + ".\n";
  }
  if (run.result.statistics.stopped_by != StopReason::pieces) {
    text += figure + "no range of scales was found that gives " + std::to_string(row.iterations) + " pieces.\n";
  }
  return text;
}

}  // namespace

Report bench_table2(const Setting& setting, const Table2Options& options) {
  const LibraryFile library(options.library);
  const bool default_quick = setting.quick && options.rows.empty();
  const std::vector<Table2Row> rows = chosen_rows(default_quick ? std::vector<std::string>{"19"} : options.rows);
  const int size_px = setting.quick ? 300 : 1000;
  const Canvas canvas = make_rectangle_canvas(size_px, size_px);

  TextTable table({"", "candidates", "PADs a shape", "iterations", "docking choices", "pruned %", "total s", "prune %",
                   "dock %", "objective %", "merge %"});
  Report report;
  report.json = report_head("table2", setting);
  report.json.update({{"library", options.library}, {"canvas_px", size_px}, {"rows", Json::array()}});
  std::string notes;
  for (const Table2Row& row : rows) {
    const SizedRun run = run_row(row, library, canvas, setting.devices);
    add_lines(table, row, run);
    notes += remarks(row, run);
    report.json["rows"].push_back(
        {{"figure", row.figure}, {"ours", run_json(run, canvas)}, {"paper", paper_json(row)}});
  }
  report.text = table.text() + "\n" + notes + "Ours: as many shapes and pieces on a square of " +
                std::to_string(size_px) +
                " px, not the paper's drawings, canvases and seeds; time of the loop, of the last\ntry where a canvas "
                "was full too early. Paper: dual Xeon E5-2670, eight Tesla K20m.\n";
  return report;
}

}  // namespace tessera::bench
