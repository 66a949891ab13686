#include "bench/replacing_case.h"

#include "core/base/error.h"
#include "files/regular_file.h"

namespace tessera::bench {
namespace {

constexpr const char* kAllowed = "; allowed: the JSON file of tessera bench replacing";

}  // namespace

std::uint64_t ReplacingCase::trials() const {
  std::uint64_t sum = 0;
  for (const MeasuredWindow& w : windows) sum += w.trials;
  return sum;
}

double ReplacingCase::work_s() const {
  double sum_s = 0;
  for (const MeasuredWindow& w : windows) sum_s += w.work_s;
  return sum_s;
}

Json to_json(const ReplacingCase& c) {
  Json json = {{"canvas_px", c.canvas_px}, {"pieces", c.pieces},     {"master_s", c.master_s},
               {"request_s", c.request_s}, {"unpack_s", c.unpack_s}, {"reply_s", c.reply_s},
               {"windows", Json::array()}};
  for (const MeasuredWindow& w : c.windows) {
    json["windows"].push_back({{"trials", w.trials},
                               {"work_s", w.work_s},
                               {"request_bytes", w.request_bytes},
                               {"reply_bytes", w.reply_bytes}});
  }
  return json;
}

ReplacingCase read_replacing_case(const std::string& path) {
  constexpr std::size_t kMostBytes = std::size_t(64) << 20;
  const Json report = Json::parse(read_regular_file(path, kMostBytes), nullptr, false);
  try {
    const Json& batch = report.at("batch");
    ReplacingCase c;
    c.canvas_px = batch.at("canvas_px");
    c.pieces = batch.at("pieces");
    c.master_s = batch.at("master_s");
    c.request_s = batch.at("request_s");
    c.unpack_s = batch.at("unpack_s");
    c.reply_s = batch.at("reply_s");
    for (const Json& w : batch.at("windows")) {
      c.windows.push_back({w.at("trials"), w.at("work_s"), w.at("request_bytes"), w.at("reply_bytes")});
    }
    if (c.windows.empty()) throw InputError(path + ": has no windows" + kAllowed);
    return c;
  } catch (const Json::exception& error) {
    throw InputError(path + ": " + error.what() + kAllowed);
  }
}

}  // namespace tessera::bench
