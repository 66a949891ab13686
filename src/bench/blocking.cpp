#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>

#include "bench/benchmarks.h"
#include "bench/blocking/clipped_curves.h"
#include "bench/blocking/pad_recogniser.h"
#include "bench/blocking/silhouette_case.h"
#include "bench/blocking/success.h"
#include "bench/devices.h"
#include "bench/line_plot.h"
#include "core/base/error.h"
#include "core/base/processor_time.h"
#include "core/base/rank_pool.h"
#include "text/number_text.h"
#include "text/text_table.h"

namespace tessera::bench {
namespace {

constexpr int kMostBlocked_percent = 95;
constexpr std::size_t kQuickQueries = 10;

void check_blocks(const std::vector<int>& blocks) {
  for (const int percent : blocks) {
    if (percent < 0 || percent > kMostBlocked_percent) {
      throw InputError("--blocks: found " + std::to_string(percent) + "; allowed: 0 to 95 %");
    }
  }
}

using RecogniserMaker = std::function<std::unique_ptr<Recogniser>(const SilhouetteLibrary&)>;

/// Functions that make the named recognisers, in the same order. Throws InputError where a name is not allowed.
std::vector<RecogniserMaker> chosen_recognisers(const std::vector<std::string>& names) {
  std::vector<RecogniserMaker> chosen;
  for (const std::string& name : names) {
    std::string allowed = "pad";
    const std::size_t before = chosen.size();
    if (name == "pad") {
      chosen.push_back([](const SilhouetteLibrary& library) { return std::make_unique<PadRecogniser>(library); });
    }
    for (std::size_t i = 0; const auto& descriptor : all_descriptors()) {
      if (descriptor->name() == name) {
        chosen.push_back([i](const SilhouetteLibrary& library) {
          return make_descriptor_recogniser(std::move(all_descriptors()[i]), library);
        });
      }
      allowed += ", " + descriptor->name();
      ++i;
    }
    if (chosen.size() == before) throw InputError("--descriptors: found \"" + name + "\"; allowed: " + allowed);
  }
  return chosen;
}

/// The options with defaults for those that are not given.
BlockingOptions whole_blocking(BlockingOptions options, bool quick) {
  if (options.blocks.empty()) {
    options.blocks = quick ? std::vector<int>{0, 50} : std::vector<int>{0, 10, 20, 30, 40, 50, 60, 70, 80, 90};
  }
  if (options.descriptors.empty()) options.descriptors = {"pad"};
  if (options.queries == 0 && quick) options.queries = kQuickQueries;
  return options;
}

/// Makes the query of a silhouette. The same silhouette and percentage give the same query.
ClippedQuery make_query(const SilhouetteCase& run, std::size_t silhouette, int blocked_percent) {
  Draws draws(mix_bits(run.options.seed) ^ (std::uint64_t(silhouette) << 8) ^ std::uint64_t(blocked_percent));
  const Clipping clipping{blocked_percent / 100., run.options.edge_removed};
  const View view = random_view(run.options, draws);
  return told_query(clipped_curves(run.silhouettes[silhouette].mask, clipping, view, draws), view, run.options);
}

/// The counts of one recogniser at one percentage, over all queries.
struct BlockingRow {
  std::string descriptor;
  int blocked_percent = 0;
  std::size_t queries = 0;
  std::vector<Success> successes;  // one for each query
  double query_s = 0;              // processor time, mean

  double percent(bool Success::*kind) const {
    const auto count = std::count_if(successes.begin(), successes.end(), [&](const Success& s) { return s.*kind; });
    return 100. * double(count) / double(successes.size());
  }
};

BlockingRow recognise_all(const SilhouetteCase& run, const Recogniser& recogniser, int blocked_percent) {
  BlockingRow row{recogniser.name(), blocked_percent, run.queries(), std::vector<Success>(run.queries()), 0};
  std::vector<double> times_s(row.queries);
  parallel_for(row.queries, [&](std::size_t i) {
    const std::size_t silhouette = run.silhouette_of(i);
    const ClippedQuery query = make_query(run, silhouette, blocked_percent);
    if (query.curves.empty()) return;
    const double start_s = thread_processor_time_s();
    const std::vector<std::uint32_t> found = recogniser.recognise(query);
    times_s[i] = thread_processor_time_s() - start_s;
    row.successes[i] = success_of(found, silhouette, run.library, run.twins);
  });
  for (const double s : times_s) row.query_s += s / double(row.queries);
  return row;
}

/// The table and the plot of the report, to which each row is added.
struct BlockingShown {
  TextTable table{
      {"descriptor", "hidden %", "queries", "itself %", "or a twin %", "in first 10 %", "nothing %", "ms a query"}};
  Panel panel{"Recognised: itself or a twin", "hidden, % of the width", "% of queries", false, 100, {}, false};

  void add(const BlockingRow& row, Json& rows) {
    const double nothing = 100 - row.percent(&Success::told);
    table.add({row.descriptor, std::to_string(row.blocked_percent), std::to_string(row.queries),
               fixed(row.percent(&Success::itself), 1), fixed(row.percent(&Success::twin), 1),
               fixed(row.percent(&Success::among), 1), fixed(nothing, 1), fixed(1000 * row.query_s, 1)});
    rows.push_back({{"descriptor", row.descriptor},
                    {"blocked_percent", row.blocked_percent},
                    {"queries", row.queries},
                    {"itself_percent", rounded(row.percent(&Success::itself))},
                    {"twin_percent", rounded(row.percent(&Success::twin))},
                    {"among_ten_percent", rounded(row.percent(&Success::among))},
                    {"nothing_percent", rounded(nothing)},
                    {"query_s", tessera::rounded(row.query_s, 6)}});
    if (panel.curves.empty() || panel.curves.back().name != row.descriptor) {
      panel.curves.push_back({row.descriptor, {}, false});
    }
    panel.curves.back().points.emplace_back(row.blocked_percent, row.percent(&Success::twin));
  }
};

}  // namespace

Report bench_blocking(const Setting& setting, const BlockingOptions& asked) {
  check(asked);
  check_blocks(asked.blocks);
  const BlockingOptions options = whole_blocking(asked, setting.quick);
  const std::vector<RecogniserMaker> makers = chosen_recognisers(options.descriptors);
  const std::string plot = std::filesystem::path(setting.out).replace_extension().string();
  if (!plot.empty()) check_plot_can_be_written(plot);
  const SilhouetteCase run = read_silhouette_case(options);

  Report report;
  report.json = report_head("blocking", setting);
  report.json.update(case_json(run));
  report.json["rows"] = Json::array();
  BlockingShown shown;
  for (const RecogniserMaker& make : makers) {
    const std::unique_ptr<Recogniser> recogniser = make(run.library);
    for (const int percent : options.blocks) {
      setting.progress(recogniser->name() + ", " + std::to_string(percent) + " % hidden");
      shown.add(recognise_all(run, *recogniser, percent), report.json["rows"]);
    }
  }
  if (!plot.empty()) write_plot({shown.panel}, plot);
  report.text = shown.table.text() + "\nClipped from the left. " + case_text(run);
  return report;
}

}  // namespace tessera::bench
