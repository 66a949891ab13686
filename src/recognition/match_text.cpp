#include "recognition/match_text.h"

#include <nlohmann/json.hpp>

#include "text/json_text.h"
#include "text/number_text.h"
#include "text/pose.h"
#include "text/text_table.h"

namespace tessera {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kPartDecimals = 4;
constexpr int kLengthDecimals = 2;
constexpr int kPoseDecimals = 4;

Json part_json(const CurvePart& part) {
  return {
      {"curve", part.curve}, {"from", rounded(part.from, kLengthDecimals)}, {"to", rounded(part.to, kLengthDecimals)}};
}

Json pose_json(const Similarity& a_from_b) {
  return {{"scale", rounded(a_from_b.scale(), kPoseDecimals)},
          {"rotation_deg", rounded(rotation_deg(a_from_b), kLengthDecimals)},
          {"x", rounded(a_from_b.tx, kLengthDecimals)},
          {"y", rounded(a_from_b.ty, kLengthDecimals)}};
}

Json match_json(const CurveMatch& match) {
  Json runs = Json::array();
  for (const MatchedRun& run : match.runs) {
    runs.push_back({{"a", part_json(run.of_a)}, {"b", part_json(run.of_b)}, {"reversed", run.reversed}});
  }
  return {{"score", rounded(match.score, kPartDecimals)},
          {"similarity", rounded(match.similarity, kPartDecimals)},
          {"part_of_a", rounded(match.part_of_a, kPartDecimals)},
          {"part_of_b", rounded(match.part_of_b, kPartDecimals)},
          {"a_from_b", pose_json(match.a_from_b)},
          {"runs", runs}};
}

std::string percent(float part) { return fixed(100 * double(part), 1) + " %"; }

}  // namespace

std::string match_table(const std::vector<CurveMatch>& matches) {
  TextTable table({"match", "score", "similarity", "of A", "of B", "runs", "scale", "turned by", "B's origin in A"});
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const CurveMatch& match = matches[k];
    table.add({std::to_string(k + 1), fixed(match.score, 3), fixed(match.similarity, 3), percent(match.part_of_a),
               percent(match.part_of_b), std::to_string(match.runs.size()), significant(match.a_from_b.scale(), 4),
               fixed(rotation_deg(match.a_from_b), 1) + " deg",
               fixed(match.a_from_b.tx, 1) + ", " + fixed(match.a_from_b.ty, 1)});
  }
  return table.text();
}

std::string match_json(const std::string& path_a, const std::string& path_b, const std::vector<CurveMatch>& matches) {
  Json list = Json::array();
  for (const CurveMatch& match : matches) list.push_back(match_json(match));
  return "{\n\"a\": " + json_path_text(path_a) + ",\n\"b\": " + json_path_text(path_b) +
         ",\n\"matches\": " + list.dump(2) + "\n}\n";
}

}  // namespace tessera
