#include "result/rank_table.h"

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/base/count_text.h"
#include "text/number_text.h"

namespace tessera {
namespace {

using Json = nlohmann::ordered_json;

double percent(double part, double whole) { return whole > 0 ? 100 * part / whole : 0; }

double bytes_a_round(const RankStatistics& ranks, std::uint64_t bytes, std::size_t workers) {
  return double(bytes) / double(std::max<std::uint64_t>(1, ranks.rounds)) / double(std::max<std::size_t>(1, workers));
}

double bytes_to_a_worker(const RankStatistics& ranks) {
  return bytes_a_round(ranks, ranks.master.sent.bytes, std::size_t(ranks.asked));
}

std::uint64_t sent_by_workers(const RankStatistics& ranks) {
  std::uint64_t bytes = 0;
  for (const WorkerTimes& worker : ranks.workers) bytes += worker.sent.bytes;
  return bytes;
}

std::string row(const std::string& label, const std::array<std::string, 5>& cells) {
  char text[100];
  std::snprintf(text, sizeof text, "  %-22s%10s%11s%10s%10s%13s", label.c_str(), cells[0].c_str(), cells[1].c_str(),
                cells[2].c_str(), cells[3].c_str(), cells[4].c_str());
  std::string line = text;
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string spread_row(const std::string& label, const Spread& s, double loop_s) {
  return row(label, {fixed(s.min, 3), fixed(s.average, 3), fixed(s.max, 3), fixed(percent(s.average, loop_s), 1) + " %",
                     fixed(s.imbalance_percent(), 1) + " %"});
}

std::string worker_rows(const RankStatistics& ranks) {
  std::string text;
  const auto add = [&](const std::string& label, double WorkerTimes::*seconds) {
    const Spread spread = spread_of(ranks.workers, [&](const WorkerTimes& w) { return w.*seconds; });
    text += spread_row(label, spread, ranks.master.loop_s);
  };
  for (const auto& stage : kWorkerStages) add("worker: " + std::string(stage.name), stage.seconds);
  add("(processor time)", &WorkerTimes::processor_s);
  return text;
}

std::string master_rows(const MasterTimes& master) {
  std::string text;
  const auto add = [&](const std::string& label, double seconds) {
    text += row(label, {"", fixed(seconds, 3), "", fixed(percent(seconds, master.loop_s), 1) + " %", ""});
  };
  for (const auto& stage : kMasterStages) add("master: " + std::string(stage.name), master.*stage.seconds);
  add("(processor time)", master.processor_s);
  return text;
}

std::string message_rows(const RankStatistics& ranks) {
  char text[300];
  const Spread messages = spread_of(ranks.workers, [](const WorkerTimes& w) { return double(w.sent.messages); });
  const Spread megabytes = spread_of(ranks.workers, [](const WorkerTimes& w) { return double(w.sent.bytes) / 1e6; });
  std::snprintf(text, sizeof text,
                "  master sends    %9.0f messages  %9.3f MB  %9.0f B/round/worker\n"
                "  a worker sends  %9.0f messages  %9.3f MB  %9.0f B/round/worker\n",
                double(ranks.master.sent.messages), double(ranks.master.sent.bytes) / 1e6, bytes_to_a_worker(ranks),
                messages.average, megabytes.average,
                bytes_a_round(ranks, sent_by_workers(ranks), ranks.workers.size()));
  return text;
}

Json spread_json(const Spread& s, double loop_s) {
  return {{"min_s", rounded(s.min, 6)},
          {"average_s", rounded(s.average, 6)},
          {"max_s", rounded(s.max, 6)},
          {"share_percent", rounded(percent(s.average, loop_s), 3)},
          {"imbalance_percent", rounded(s.imbalance_percent(), 3)}};
}

Json workers_json(const RankStatistics& ranks) {
  Json json;
  const auto seconds = [&](double WorkerTimes::*member) {
    return spread_json(spread_of(ranks.workers, [&](const WorkerTimes& w) { return w.*member; }), ranks.master.loop_s);
  };
  const auto average = [&](auto figure) { return rounded(spread_of(ranks.workers, figure).average, 1); };
  for (const auto& stage : kWorkerStages) json[stage.name] = seconds(stage.seconds);
  json["processor"] = seconds(&WorkerTimes::processor_s);
  json["counts"] = average([](const WorkerTimes& w) { return double(w.counts); });
  json["docks"] = average([](const WorkerTimes& w) { return double(w.docks); });
  json["refines"] = average([](const WorkerTimes& w) { return double(w.refines); });
  json["measures"] = average([](const WorkerTimes& w) { return double(w.measures); });
  json["replaces"] = average([](const WorkerTimes& w) { return double(w.replaces); });
  json["sent_messages"] = average([](const WorkerTimes& w) { return double(w.sent.messages); });
  json["sent_bytes"] = average([](const WorkerTimes& w) { return double(w.sent.bytes); });
  return json;
}

Json master_json(const MasterTimes& master) {
  Json json;
  const auto add = [&](std::string_view name, double seconds) {
    json[name] = {{"seconds", rounded(seconds, 6)}, {"share_percent", rounded(percent(seconds, master.loop_s), 3)}};
  };
  for (const auto& stage : kMasterStages) add(stage.name, master.*stage.seconds);
  add("serial", master.serial_s());
  add("processor", master.processor_s);
  json["sent_messages"] = master.sent.messages;
  json["sent_bytes"] = master.sent.bytes;
  json["sent_field_messages"] = master.sent_fields.messages;
  json["sent_field_bytes"] = master.sent_fields.bytes;
  return json;
}

}  // namespace

std::string ranks_text(const RankStatistics& ranks) {
  if (ranks.workers.empty()) return "";
  return "Ranks: a master and " + count_text(ranks.workers.size(), "worker") +
         (std::size_t(ranks.asked) < ranks.workers.size() ? ", " + std::to_string(ranks.asked) + " asked by it" : "") +
         ", " + count_text(std::size_t(ranks.rounds), "round") + ", " + fixed(ranks.master.loop_s, 3) + " s\n" +
         row("", {"min s", "average s", "max s", "share", "imbalance"}) + worker_rows(ranks) +
         master_rows(ranks.master) + message_rows(ranks);
}

Json ranks_json(const RankStatistics& ranks) {
  return {
      {"workers", ranks.workers.size()},
      {"asked_by_master", ranks.asked},
      {"rounds", ranks.rounds},
      {"samples", ranks.target_samples},
      {"loop_s", rounded(ranks.master.loop_s, 6)},
      {"worker", workers_json(ranks)},
      {"master", master_json(ranks.master)},
      {"bytes_to_a_worker_a_round", rounded(bytes_to_a_worker(ranks), 1)},
      {"bytes_from_a_worker_a_round", rounded(bytes_a_round(ranks, sent_by_workers(ranks), ranks.workers.size()), 1)}};
}

}  // namespace tessera
