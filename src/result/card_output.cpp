#include "result/card_output.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/count_text.h"
#include "core/base/stop.h"
#include "result/card_lines.h"
#include "result/deformation_table.h"
#include "result/rank_table.h"
#include "text/digest_text.h"
#include "text/number_text.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

using Json = nlohmann::ordered_json;

struct StageShares {
  double prune = 0;
  double dock = 0;
  double objective = 0;
  double merge = 0;
};

StageShares stage_shares(const RunStatistics& run) {
  const double sum_s = run.prune_s + run.dock_s + run.objective_s + run.merge_s;
  if (sum_s <= 0) return {};
  return {run.prune_s / sum_s, run.dock_s / sum_s, run.objective_s / sum_s, run.merge_s / sum_s};
}

Json px(double v) { return rounded(v, 3); }
Json fraction(double v) { return rounded(v, 6); }
Json px_or_null(const std::optional<double>& v) { return v ? px(*v) : Json(); }
Json fraction_or_null(const std::optional<double>& v) { return v ? fraction(*v) : Json(); }

Json quality_json(const Quality& q) {
  const auto of_balance = [&](double SizeBalance::*part) { return q.balance ? fraction((*q.balance).*part) : Json(); };
  return {{"coverage_fraction", fraction(q.coverage)},
          {"overlap_fraction", fraction(q.overlap)},
          {"outside_fraction", fraction(q.outside)},
          {"pieces", q.pieces},
          {"distinct_shapes", q.distinct_shapes},
          {"effective_shapes", q.effective_shapes ? Json(rounded(*q.effective_shapes, 3)) : Json()},
          {"shared_boundary_fraction", fraction(q.shared_boundary)},
          {"scale_px",
           {{"min", px(q.scale_px_quantiles[0])},
            {"p10", px(q.scale_px_quantiles[1])},
            {"median", px(q.scale_px_quantiles[2])},
            {"p90", px(q.scale_px_quantiles[3])},
            {"max", px(q.scale_px_quantiles[4])}}},
          {"largest_gap_radius_px", px(q.largest_gap_px)},
          {"size_range_px", {{"min", px(q.size_range_px.min_px)}, {"max", px(q.size_range_px.max_px)}}},
          {"size_balance", of_balance(&SizeBalance::evenness)},
          {"dwarfs_fraction", of_balance(&SizeBalance::dwarfs)},
          {"nearest_copy_px", px_or_null(q.copies_px)},
          {"nearest_copy_fraction", fraction_or_null(q.copies_apart)},
          {"between_pieces_px", px_or_null(q.between_px)},
          {"alone_fraction", fraction(q.alone)},
          {"style_distance", q.style_distance ? Json(rounded(*q.style_distance, 3)) : Json()}};
}

/// The word for the reason of the end; empty while the run goes on.
std::string end_word(const RunStatistics& run) { return run.stopped_by ? std::string(stop_word(*run.stopped_by)) : ""; }

Json run_json(const RunStatistics& run, int trials_limit) {
  const StageShares share = stage_shares(run);
  const auto seconds = [](double v) { return rounded(v, 3); };
  const auto percent = [](double fraction) { return rounded(100 * fraction, 3); };
  return {{"candidates", run.shapes},
          {"pads_per_shape", rounded(run.pads_per_shape, 3)},
          {"iterations", run.rounds},
          {"target_samples", run.target_samples},
          {"docking_choices", run.docking_choices},
          {"dockings_evaluated", run.dockings_evaluated},
          {"dockings_refined", run.refined},
          {"pruned_percent", percent(run.pruned_fraction())},
          {"total_s", seconds(run.total_s)},
          {"last_tenth_percent", run.last_tenth ? Json(percent(*run.last_tenth)) : Json()},
          {"improve_s", seconds(run.improve_s)},
          {"trials", run.trials},
          {"trials_limit", trials_limit},
          {"trials_kept", run.trials_kept},
          {"prune_s", seconds(run.prune_s)},
          {"dock_s", seconds(run.dock_s)},
          {"ahead_s", seconds(run.ahead_s)},
          {"objective_s", seconds(run.objective_s)},
          {"merge_s", seconds(run.merge_s)},
          {"prune_share_percent", percent(share.prune)},
          {"dock_share_percent", percent(share.dock)},
          {"objective_share_percent", percent(share.objective)},
          {"merge_share_percent", percent(share.merge)},
          {"stopped_by", end_word(run)}};
}

Json provenance_json(const RunRecord& record) {
  Json ranks = Json::array();
  for (const RankSite& site : record.ranks) {
    Json devices = Json::array();
    for (const DeviceDescription& d : site.devices) {
      devices.push_back(
          {{"kind", d.kind}, {"name", d.name}, {"platform", d.platform}, {"driver", d.driver}, {"shapes", d.shapes}});
    }
    ranks.push_back({{"host", site.host}, {"devices", devices}});
  }
  return {{"version", record.version},           {"commit", record.commit},
          {"command_line", record.command_line}, {"job_file", record.job_file},
          {"library_file", record.library_file}, {"library_digest", digest_text(record.library_digest)},
          {"started_utc", record.started_utc},   {"ended_utc", record.ended_utc},
          {"resumed_from", record.resumed_from}, {"resumed_pieces", record.resumed_pieces},
          {"warnings", record.warnings},         {"ranks", ranks}};
}

Json growth_json(const std::vector<GrowthMoment>& growth) {
  Json seconds = Json::array(), coverage = Json::array();
  for (const GrowthMoment& moment : growth) {
    seconds.push_back(rounded(moment.seconds, 3));
    coverage.push_back(rounded(moment.coverage, 6));
  }
  return {{"s", seconds}, {"coverage_fraction", coverage}};
}

/// Groups digits: 12345678 becomes "12,345,678".
std::string grouped(std::uint64_t count) {
  std::string text = std::to_string(count);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, 1, ',');
  return text;
}

std::string scales_text(const Quality& q) {
  std::string text;
  for (const double scale : q.scale_px_quantiles) {
    if (!text.empty()) text += " / ";
    text += fixed(scale, 1);
  }
  return text + " px";
}

/// The text of shared boundary. Where padding keeps pieces apart, it says so, because there is nothing to share.
std::string shared_boundary_text(const Quality& q, float padding_px) {
  const std::string text = percent_text(q.shared_boundary, 1) + "  (within 2 px";
  return text + (padding_px > 0 ? "; padding keeps " + fixed(padding_px, 1) + " px)" : ")");
}

std::string pieces_text(const Quality& q) {
  const bool unknown = q.pieces > 0 && q.distinct_shapes == 0;
  return grouped(q.pieces) +
         (unknown ? ", of shapes without a name" : " of " + grouped(q.distinct_shapes) + " distinct shapes");
}

constexpr const char* kNoPieces = "there are no pieces";

std::string no_balance_text(const Quality& q) { return q.pieces > 0 ? "none, all sizes are alike" : kNoPieces; }

std::string balance_text(const Quality& q) {
  if (!q.balance) return no_balance_text(q);
  return fixed(q.balance->evenness, 2) + "  (1 = even; over " + fixed(q.size_range_px.min_px, 1) + " to " +
         fixed(q.size_range_px.max_px, 1) + " px)";
}

std::string dwarfs_text(const Quality& q) {
  if (!q.balance) return no_balance_text(q);
  return percent_text(q.balance->dwarfs, 1) + "  (of the pieces' area; below " +
         fixed(dwarfs_below_px(q.size_range_px), 1) + " px)";
}

std::string variety_text(const Quality& q) {
  if (!q.effective_shapes) return q.pieces > 0 ? "not known, shapes have no names" : kNoPieces;
  return "that of " + fixed(*q.effective_shapes, 1) + " shapes with equal shares of the area";
}

std::string copies_text(const Quality& q) {
  if (q.pieces == 0) return kNoPieces;
  if (!q.copies_px)
    return q.distinct_shapes > 0 ? "none: half of the pieces or more have no copy" : "not known, shapes have no names";
  return fixed(*q.copies_px, 1) + " px away  (median; " + percent_text(*q.copies_apart, 1) + " of the diagonal)";
}

std::string between_text(const Quality& q) {
  return q.between_px ? fixed(*q.between_px, 3) + " px  (the nearest two; 0: they touch)" : "fewer than two pieces";
}

std::string style_text(const Quality& q) {
  return q.style_distance ? fixed(*q.style_distance, 2) + "  (of two pieces, mean by area; 0 = one style)"
                          : "not known";
}

std::string quality_text(const Quality& q, float padding_px) {
  return std::string("Quality\n") + card_line("coverage", percent_text(q.coverage)) +
         card_line("overlap", percent_text(q.overlap, 3)) + card_line("outside", percent_text(q.outside, 3)) +
         card_line("pieces", pieces_text(q)) + card_line("variety", variety_text(q)) +
         card_line("shared boundary", shared_boundary_text(q, padding_px)) + card_line("scale", scales_text(q)) +
         card_line("", "(min / 10 % / median / 90 % / max)") +
         card_line("largest gap", fixed(q.largest_gap_px, 1) + " px  (radius)") +
         card_line("balance of sizes", balance_text(q)) + card_line("dwarfs", dwarfs_text(q)) +
         card_line("nearest copy", copies_text(q)) + card_line("between pieces", between_text(q)) +
         card_line("alone", percent_text(q.alone, 1) + "  (of the pieces; no other within 2 px)") +
         card_line("styles", style_text(q));
}

std::string last_tenth_text(const RunStatistics& run) {
  if (!run.last_tenth) return "";
  return card_line("  its last tenth",
                   (*run.last_tenth < 0 ? "" : "+") + fixed(100 * *run.last_tenth, 2) + " % of the canvas");
}

std::string improvement_text(const RunStatistics& run) {
  if (run.trials == 0) return "";
  return card_line("  of it improving", fixed(run.improve_s, 1) + " s, " + grouped(run.trials_kept) + " of " +
                                            grouped(run.trials) + by_count(run.trials, " trial kept", " trials kept"));
}

/// How the run ended: "full", "full, then 12 of 12 trials" or "coverage after 3 of 12 trials". Improving begins when the
/// canvas is full.
std::string end_text(const RunStatistics& run, int trials_limit) {
  if (run.trials == 0) return end_word(run);
  const std::uint64_t most = trials_limit > 0 ? std::uint64_t(trials_limit) : run.trials;
  const std::string limit = trials_limit > 0 ? " of " + grouped(most) : "";
  const bool then = run.stopped_by == StopReason::full || run.stopped_by == StopReason::used_up;
  return end_word(run) + (then ? ", then " : " after ") + grouped(run.trials) + limit +
         by_count(most, " trial", " trials");
}

/// The lines about matching; empty where the run matched nothing, because pieces only moved or were deformed.
std::string matching_text(const RunStatistics& run) {
  if (run.rounds == 0) return "";
  return card_line("PADs per shape", fixed(run.pads_per_shape, 1)) + card_line("iterations", grouped(run.rounds)) +
         card_line("docking choices", grouped(run.docking_choices)) +
         card_line("pruned", percent_text(run.pruned_fraction()));
}

std::string shares_text(const RunStatistics& run) {
  if (run.prune_s + run.dock_s + run.objective_s + run.merge_s <= 0) return "";
  const StageShares share = stage_shares(run);
  return card_line("prune / dock", percent_text(share.prune, 1) + " / " + percent_text(share.dock, 1)) +
         card_line("objective / merge", percent_text(share.objective, 1) + " / " + percent_text(share.merge, 1));
}

std::string run_text(const RunStatistics& run, int trials_limit) {
  return std::string("Run (the paper's Table 2)\n") +
         card_line("candidates", grouped(run.shapes) + "  (shapes in the library)") + matching_text(run) +
         card_line("total time", fixed(run.total_s, 1) + " s") + last_tenth_text(run) + improvement_text(run) +
         shares_text(run) + card_line("stopped by", end_text(run, trials_limit));
}

/// The missing shapes. Where there are many, only the first ones, so that the card can be read back.
Json missing_json(const std::vector<MissingShape>& missing) {
  constexpr std::size_t kShapes = 1000;
  Json shapes = Json::array();
  for (std::size_t i = 0; i < std::min(missing.size(), kShapes); ++i) {
    const MissingShape& m = missing[i];
    shapes.push_back({{"shape", m.name}, {"wanted", m.wanted}, {"standing", m.standing}});
  }
  return {{"pieces", pieces_of(missing)}, {"shapes", shapes}};
}

/// The first missing shapes; card.json has more.
std::string missing_lines(const std::vector<MissingShape>& missing) {
  constexpr std::size_t kShapes = 20;
  constexpr std::size_t kNameBytes = 32;
  if (missing.empty()) return "";
  std::string text = "Missing\n" + card_line("pieces", grouped(pieces_of(missing)) + " of " + grouped(missing.size()) +
                                                           " " + by_count(missing.size(), "shape", "shapes"));
  for (std::size_t i = 0; i < std::min(missing.size(), kShapes); ++i) {
    MissingShape shown = missing[i];
    shown.name = cut_utf8(shown.name, kNameBytes);
    text += card_line("", missing_text({shown}, 1));
  }
  const std::size_t more = missing.size() - std::min(missing.size(), kShapes);
  return more == 0 ? text : text + card_line("", "and " + grouped(more) + " more (card.json)");
}

}  // namespace

std::string card_json(const Quality& quality, const RunStatistics& run, const CardSettings& settings,
                      const RankStatistics& ranks, const RunRecord& record,
                      const std::optional<DeformationFigures>& deformation, const std::vector<MissingShape>& missing) {
  Json card{{"quality", quality_json(quality)}, {"run", run_json(run, settings.trials)}};
  if (!missing.empty()) card["missing"] = missing_json(missing);
  if (deformation) card["deformation"] = deformation_json(*deformation);
  if (!ranks.workers.empty()) card["ranks"] = ranks_json(ranks);
  if (!record.growth.empty()) card["growth"] = growth_json(record.growth);
  card["provenance"] = provenance_json(record);
  constexpr bool kAsciiOnly = false;
  return card.dump(2, ' ', kAsciiOnly, Json::error_handler_t::replace) + "\n";  // paths may be any bytes
}

std::string score_json(const std::optional<Quality>& quality, const std::optional<AfarNote>& afar) {
  Json score = Json::object();
  if (quality) {
    score["quality"] = quality_json(*quality);
    if (quality->pieces > 0 && quality->distinct_shapes == 0) score["quality"]["distinct_shapes"] = nullptr;
  }
  if (afar) score["from_afar"] = Json::parse(afar_json(*afar));
  return score.dump(2) + "\n";
}

std::string score_text(const std::optional<Quality>& quality, const std::optional<AfarNote>& afar) {
  return (quality ? quality_text(*quality, 0) : "") + (afar ? afar_text(*afar) : "");
}

std::string card_text(const Quality& quality, const RunStatistics& run, const CardSettings& settings,
                      const std::optional<DeformationFigures>& deformation, const std::vector<MissingShape>& missing) {
  return quality_text(quality, settings.padding_px) + missing_lines(missing) +
         (deformation ? deformation_text(*deformation) : "") + run_text(run, settings.trials);
}

}  // namespace tessera
