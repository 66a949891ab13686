#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "bench/benchmarks.h"
#include "bench/blocking/pad_recogniser.h"
#include "bench/blocking/silhouette_case.h"
#include "bench/devices.h"
#include "bench/line_plot.h"
#include "bench/scenes/answer_measures.h"
#include "bench/scenes/left_out.h"
#include "bench/scenes/scene_queries.h"
#include "bench/scenes/scene_success.h"
#include "bench/scenes/verdicts.h"
#include "core/base/error.h"
#include "core/base/processor_time.h"
#include "core/base/rank_pool.h"
#include "text/number_text.h"
#include "text/text_table.h"

namespace tessera::bench {
namespace {

constexpr int kLeastHidden_percent = 1;
constexpr int kMostHidden_percent = 90;
constexpr std::size_t kQuickScenes = 10;
constexpr int kThresholdStep_percent = 5;

LeftOut left_out_kind(const std::string& name) {
  if (name == "none") return LeftOut::none;
  if (name == "classes") return LeftOut::classes;
  if (name == "shapes") return LeftOut::shapes;
  throw InputError("--left-out: found \"" + name + "\"; allowed: none, classes, shapes");
}

void check_scenes(const ScenesOptions& options) {
  check(static_cast<const SilhouetteOptions&>(options));
  left_out_kind(options.left_out);
  for (const int percent : options.hidden) {
    if (percent < kLeastHidden_percent || percent > kMostHidden_percent) {
      throw InputError("--hidden: found " + std::to_string(percent) + "; allowed: 1 to 90 %");
    }
  }
  const std::vector<std::string>& allowed = scene_kinds();
  for (const std::string& kind : options.kinds) {
    if (std::find(allowed.begin(), allowed.end(), kind) != allowed.end()) continue;
    std::string names;
    for (const std::string& name : allowed) names += (names.empty() ? "" : ", ") + name;
    throw InputError("--kinds: found \"" + kind + "\"; allowed: " + names);
  }
}

/// The options with defaults for those that are not given.
ScenesOptions whole_scenes(ScenesOptions options, bool quick) {
  if (options.kinds.empty()) options.kinds = scene_kinds();
  if (options.hidden.empty()) options.hidden = quick ? std::vector<int>{50} : std::vector<int>{20, 30, 40, 50, 60, 70};
  if (options.queries == 0 && quick) options.queries = kQuickScenes;
  return options;
}

/// The silhouettes, and which of them are left out of the library.
struct ScenesCase {
  SilhouetteCase silhouettes;
  std::vector<bool> left_out;

  /// Silhouettes that may be in a scene with this one: known ones with known ones, others with others.
  std::vector<std::size_t> others_of(std::size_t silhouette) const {
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < left_out.size(); ++i) {
      if (i != silhouette && left_out[i] == left_out[silhouette]) others.push_back(i);
    }
    return others;
  }
};

ScenesCase make_scenes_case(const ScenesOptions& options) {
  ScenesCase run{read_silhouette_case(options), {}};
  const LeftOut kind = left_out_kind(options.left_out);
  run.left_out = chosen_left_out(run.silhouettes.silhouettes, run.silhouettes.twins, kind, options.seed);
  leave_out(run.left_out, run.silhouettes.library);
  if (run.silhouettes.library.shapes.empty()) throw InputError("--left-out: no shape is left in the library");
  return run;
}

/// The outcome of one query.
struct SceneAnswer {
  bool made = false;  // false: no other silhouette can hide that much of it, or too little is visible
  bool known = false;
  SceneSuccess success;
  AnswerMeasures measures;
  double query_s = 0;
};

SceneAnswer answered(const ScenesCase& run, const PadRecogniser& recogniser, const std::string& kind,
                     int hidden_percent, std::size_t silhouette) {
  SceneAnswer answer;
  const std::optional<SceneQuery> scene =
      scene_query(run.silhouettes, kind, silhouette, hidden_percent, run.others_of(silhouette));
  if (!scene || scene->query.curves.empty()) return answer;
  answer.made = true;
  answer.known = !run.left_out[silhouette];
  const double start_s = thread_processor_time_s();
  const std::vector<Recognition> found = recogniser.recognitions(scene->query);
  answer.query_s = thread_processor_time_s() - start_s;
  std::vector<std::uint32_t> places;
  for (const Recognition& r : found) places.push_back(std::uint32_t(index_of(r.shape)));
  answer.success = scene_success(places, scene->shown, run.silhouettes.library, run.silhouettes.twins);
  answer.measures = answer_measures(found, run.silhouettes.library, run.silhouettes.twins);
  return answer;
}

std::vector<SceneAnswer> all_answers(const ScenesCase& run, const PadRecogniser& recogniser, const std::string& kind,
                                     int hidden_percent) {
  std::vector<SceneAnswer> answers(run.silhouettes.queries());
  parallel_for(answers.size(), [&](std::size_t i) {
    answers[i] = answered(run, recogniser, kind, hidden_percent, run.silhouettes.silhouette_of(i));
  });
  std::erase_if(answers, [](const SceneAnswer& answer) { return !answer.made; });
  return answers;
}

/// The answers to the queries of one kind with one part hidden.
struct ScenesRow {
  std::string kind;
  int hidden_percent = 0;
  std::vector<SceneAnswer> answers;

  /// The number of queries of shapes in the library; successes are counted among these.
  std::size_t known() const {
    return std::size_t(std::count_if(answers.begin(), answers.end(), [](const SceneAnswer& a) { return a.known; }));
  }
  double percent(bool SceneSuccess::*kind_of_success) const {
    const auto count = std::count_if(answers.begin(), answers.end(),
                                     [&](const SceneAnswer& a) { return a.known && a.success.*kind_of_success; });
    return 100. * double(count) / double(std::max<std::size_t>(1, known()));
  }
  double query_s() const {  // mean
    double sum = 0;
    for (const SceneAnswer& answer : answers) sum += answer.query_s;
    return sum / double(std::max<std::size_t>(1, answers.size()));
  }
};

/// The table and the plot of successes, to which each row is added.
struct ScenesShown {
  TextTable table{{"scene", "hidden %", "queries", "itself %", "or a twin %", "or other shown %", "in first 10 %",
                   "all in first 10 %", "nothing %", "ms a query"}};
  Panel panel{"The first answer is shown in the scene", "hidden or changed, %", "% of queries", false, 100, {}, false};

  void add(const ScenesRow& row, Json& rows) {
    const double nothing = 100 - row.percent(&SceneSuccess::told);
    table.add({row.kind, std::to_string(row.hidden_percent), std::to_string(row.known()),
               fixed(row.percent(&SceneSuccess::itself), 1), fixed(row.percent(&SceneSuccess::twin), 1),
               fixed(row.percent(&SceneSuccess::any), 1), fixed(row.percent(&SceneSuccess::among), 1),
               fixed(row.percent(&SceneSuccess::all_among), 1), fixed(nothing, 1), fixed(1000 * row.query_s(), 1)});
    rows.push_back({{"scene", row.kind},
                    {"hidden_percent", row.hidden_percent},
                    {"queries", row.known()},
                    {"itself_percent", rounded(row.percent(&SceneSuccess::itself))},
                    {"twin_percent", rounded(row.percent(&SceneSuccess::twin))},
                    {"shown_percent", rounded(row.percent(&SceneSuccess::any))},
                    {"among_ten_percent", rounded(row.percent(&SceneSuccess::among))},
                    {"all_among_ten_percent", rounded(row.percent(&SceneSuccess::all_among))},
                    {"nothing_percent", rounded(nothing)},
                    {"query_s", tessera::rounded(row.query_s(), 6)}});
    if (panel.curves.empty() || panel.curves.back().name != row.kind) panel.curves.push_back({row.kind, {}, false});
    panel.curves.back().points.emplace_back(row.hidden_percent, row.percent(&SceneSuccess::any));
  }
};

std::vector<Verdict> verdicts_of(const std::vector<ScenesRow>& rows, double AnswerMeasures::*measure) {
  std::vector<Verdict> verdicts;
  for (const ScenesRow& row : rows) {
    for (const SceneAnswer& a : row.answers) {
      verdicts.push_back({a.measures.*measure, a.success.told, a.success.any, a.known});
    }
  }
  return verdicts;
}

Json json_of(const PrecisionRecall& counts) {
  return {{"least", rounded(counts.least)},
          {"precision_percent", rounded(100 * counts.precision())},
          {"recall_percent", rounded(100 * counts.recall())},
          {"f1_percent", rounded(100 * counts.f1())}};
}

void add_cells(const PrecisionRecall& counts, std::vector<std::string>& cells) {
  for (const double part : {counts.precision(), counts.recall(), counts.f1()}) cells.push_back(fixed(100 * part, 1));
}

/// Adds precision and recall for thresholds of score and similarity to the report.
Panel add_thresholds(const std::vector<ScenesRow>& rows, Report& report) {
  Panel panel{"Precision and recall", "least score or similarity, %", "%", false, 100, {}, false};
  TextTable table{
      {"at least", "score: precision %", "recall %", "F1 %", "similarity: precision %", "recall %", "F1 %"}};
  const std::vector<Verdict> by_score = verdicts_of(rows, &AnswerMeasures::score);
  const std::vector<Verdict> by_similarity = verdicts_of(rows, &AnswerMeasures::similarity);
  for (const char* name : {"score: recall", "score: precision", "similarity: recall", "similarity: precision"}) {
    panel.curves.push_back({name, {}, false});
  }
  for (int percent = 0; percent < 100; percent += kThresholdStep_percent) {
    const PrecisionRecall of_score = precision_recall(by_score, percent / 100.);
    const PrecisionRecall of_similarity = precision_recall(by_similarity, percent / 100.);
    std::vector<std::string> cells = {fixed(percent / 100., 2)};
    add_cells(of_score, cells);
    add_cells(of_similarity, cells);
    table.add(cells);
    report.json["thresholds"].push_back({{"score", json_of(of_score)}, {"similarity", json_of(of_similarity)}});
    const std::array<double, 4> parts = {of_score.recall(), of_score.precision(), of_similarity.recall(),
                                         of_similarity.precision()};
    for (std::size_t k = 0; k < parts.size(); ++k) panel.curves[k].points.emplace_back(percent, 100 * parts[k]);
  }
  report.text += "\n" + table.text();
  return panel;
}

/// Adds the result of each measure at its best threshold to the report.
void add_best_thresholds(const std::vector<ScenesRow>& rows, Report& report) {
  TextTable table{{"best threshold of the", "at least", "precision %", "recall %", "F1 %"}};
  const std::array<std::pair<const char*, double AnswerMeasures::*>, 3> measures = {
      {{"score", &AnswerMeasures::score},
       {"similarity", &AnswerMeasures::similarity},
       {"margin", &AnswerMeasures::margin}}};
  for (const auto& [name, measure] : measures) {
    const PrecisionRecall counts = best_threshold(verdicts_of(rows, measure));
    std::vector<std::string> cells = {name, fixed(counts.least, 2)};
    add_cells(counts, cells);
    table.add(cells);
    report.json["best"][name] = json_of(counts);
  }
  report.text += "\n" + table.text();
}

}  // namespace

Report bench_scenes(const Setting& setting, const ScenesOptions& asked) {
  check_scenes(asked);
  const ScenesOptions options = whole_scenes(asked, setting.quick);
  const std::string plot = std::filesystem::path(setting.out).replace_extension().string();
  if (!plot.empty()) check_plot_can_be_written(plot);
  const ScenesCase run = make_scenes_case(options);
  const PadRecogniser recogniser(run.silhouettes.library);

  Report report;
  report.json = report_head("scenes", setting);
  report.json.update(case_json(run.silhouettes));
  report.json["left_out_of_library"] = options.left_out;
  report.json["rows"] = Json::array();
  ScenesShown shown;
  std::vector<ScenesRow> rows;
  for (const std::string& kind : options.kinds) {
    for (const int percent : options.hidden) {
      setting.progress(kind + ", " + std::to_string(percent) + " % hidden");
      rows.push_back({kind, percent, all_answers(run, recogniser, kind, percent)});
      shown.add(rows.back(), report.json["rows"]);
    }
  }
  report.text = shown.table.text();
  std::vector<Panel> panels = {shown.panel};
  if (left_out_kind(options.left_out) != LeftOut::none) {
    panels.push_back(add_thresholds(rows, report));
    add_best_thresholds(rows, report);
  }
  if (!plot.empty()) write_plot(panels, plot);
  report.text += "\n" + case_text(run.silhouettes);
  return report;
}

}  // namespace tessera::bench
