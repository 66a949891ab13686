#include "run/results/ranking_run.h"

#include <algorithm>

#include "comm/stop_signals.h"
#include "core/base/error.h"
#include "files/atomic_file.h"
#include "files/output_folder.h"
#include "files/output_lock.h"
#include "render/ranking.h"
#include "report/campaign_page.h"
#include "result/folder/folder_name.h"
#include "run/results/found_cards.h"
#include "run/results/report_run.h"
#include "terminal/terminal.h"
#include "text/number_text.h"
#include "text/text_table.h"

namespace tessera {
namespace {

std::string output_folder(const RankingArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  return arguments.folders.size() == 1 ? arguments.folders.front() : "out/ranking";
}

std::string table_text(const std::vector<RankedResult>& results) {
  std::vector<std::string> head = {"result",   "rank",    "score",   "coverage %", "overlap %", "outside %",
                                   "shared %", "pieces",  "shapes",  "by area",    "gap px",    "balance",
                                   "dwarfs %", "copy px", "alone %", "time s"};
  const bool show_a_picture =
      std::any_of(results.begin(), results.end(), [](const RankedResult& r) { return r.card.afar.has_value(); });
  if (show_a_picture) head.insert(head.end(), {"CIEDE2000", "SSIM"});
  TextTable table(head);
  for (const RankedResult& result : results) {
    const Quality& q = result.card.quality;
    const auto percent = [](double fraction, int decimals) { return fixed(100 * fraction, decimals); };
    std::vector<std::string> row = {result.card.folder + (is_unfinished(result.card) ? " (unfinished)" : ""),
                                    std::to_string(result.rank),
                                    fixed(result.score, 2),
                                    percent(q.coverage, 2),
                                    percent(q.overlap, 3),
                                    percent(q.outside, 3),
                                    percent(q.shared_boundary, 1),
                                    std::to_string(q.pieces),
                                    std::to_string(q.distinct_shapes),
                                    q.effective_shapes ? fixed(*q.effective_shapes, 1) : "-",
                                    fixed(q.largest_gap_px, 1),
                                    q.balance ? fixed(q.balance->evenness, 2) : "-",
                                    q.balance ? percent(q.balance->dwarfs, 1) : "-",
                                    q.copies_px ? fixed(*q.copies_px, 0) : "-",
                                    result.card.age < CardAge::picture ? "-" : percent(q.alone, 1),
                                    fixed(result.card.total_s, 1)};
    if (show_a_picture) {
      const std::optional<SeenFromAfar>& afar = result.card.afar;
      row.push_back(afar ? fixed(afar->at_100_px.colour_difference, 2) : "-");
      row.push_back(afar ? fixed(afar->at_100_px.structure, 3) : "-");
    }
    table.add(row);
  }
  return table.text();
}

}  // namespace

void check_ranking_can_be_written(const std::string& folder) {
  for (const char* name : {"ranking.csv", "ranking.json", "ranking.png", "ranking.html"})
    check_can_be_written(folder + "/" + name);
}

int run_ranking(const RankingArguments& arguments) {
  comm::end_stop_handlers();  // of a campaign's collages: a ranking is soon made again
  const RankingWeights weights = ranking_weights(arguments.weights);
  const std::vector<RankedResult> results = ranked(found_cards(arguments.folders), weights);
  for (const std::string& line : lacking_measures(results, weights)) print_warning(line);
  const std::string out = output_folder(arguments);
  const OutputFolder folder(out);
  const OutputLock lock(out + "/ranking.lock",
                        out);  // a campaign, or a run that goes on, may have the folder's own
  check_ranking_can_be_written(out);
  const RankingFiles files = ranking_files(results, weights);
  const Page page = campaign_page(folder_name(out), results, weights, tile_bytes(kCampaignPictures_mb));
  {
    const comm::StopDelay delay;  // the files of a ranking belong together
    write_ranking(out, files);
    write_report_file(out + "/ranking.html", page);
  }
  print_lines(table_text(results) + score_formula(weights) + "\n\n");
  print_line("written to %s: ranking.csv, ranking.json, ranking.png, ranking.html", out.c_str());
  return 0;
}

}  // namespace tessera
