#include "bench/scaling_case.h"

#include "core/base/error.h"
#include "files/regular_file.h"

namespace tessera::bench {
namespace {

double value_at(const Json& json, const std::string& pointer, const std::string& name) {
  const Json::json_pointer at(pointer);
  if (!json.contains(at) || !json.at(at).is_number()) {
    throw InputError(name + ": no number at " + pointer + "; allowed: what tessera collage or bench scaling wrote");
  }
  return json.at(at).get<double>();
}

}  // namespace

ScalingCase scaling_case(const Json& ranks, std::uint32_t shapes, const std::string& name) {
  const auto value = [&](const std::string& pointer) { return value_at(ranks, pointer, name); };
  const auto master = [&](const std::string& stage) { return value("/master/" + stage + "/seconds"); };
  const auto average = [&](const std::string& stage) { return value("/worker/" + stage + "/average_s"); };
  ScalingCase c;
  c.workers = int(value("/workers"));
  c.asked = int(value("/asked_by_master"));
  c.shapes = shapes;
  c.loop_s = value("/loop_s");
  c.rounds = value("/rounds");
  c.pieces = value("/pieces");
  c.samples = value("/samples");
  c.objective_s = master("objective");
  c.merge_s = master("merge");
  c.questions_s = master("questions");
  c.other_s = master("other");
  c.ahead_s = master("ahead");
  c.waiting_s = master("waiting");
  c.master_processor_s = master("processor");
  c.count_s = average("count");
  c.dock_s = average("dock");
  c.refine_s = average("refine");
  c.measure_s = average("measure");
  c.field_s = average("field");
  c.messages_s = average("messages");
  for (const char* stage : {"count", "dock", "refine", "measure", "field", "messages"}) {
    c.busiest_s += value(std::string("/worker/") + stage + "/max_s");
  }
  c.processor_s = average("processor");
  c.greatest_processor_s = value("/worker/processor/max_s");
  c.counts = value("/worker/counts");
  c.docks = value("/worker/docks");
  c.refines = value("/worker/refines");
  c.measures = value("/worker/measures");
  c.field_messages = value("/master/sent_field_messages") / c.asked;
  c.bytes_to_worker = value("/master/sent_bytes") / c.asked;
  c.field_bytes_to_worker = value("/master/sent_field_bytes") / c.asked;
  c.bytes_from_worker = value("/worker/sent_bytes");
  return c;
}

std::vector<ScalingCase> read_scaling_cases(const std::string& path) {
  constexpr std::size_t kMostBytes = std::size_t(64) << 20;
  const Json report = Json::parse(read_regular_file(path, kMostBytes), nullptr, false);
  if (report.is_discarded() || !report.contains("cases") || report.at("cases").empty()) {
    throw InputError(path + ": has no cases; allowed: the JSON file of tessera bench scaling");
  }
  std::vector<ScalingCase> cases;
  for (const Json& entry : report.at("cases")) {
    cases.push_back(scaling_case(entry.at("ranks"), std::uint32_t(value_at(entry, "/shapes", path)), path));
  }
  return cases;
}

}  // namespace tessera::bench
