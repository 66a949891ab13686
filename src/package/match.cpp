#include "tessera/matching/match.h"

#include "core/recognition/curve_match.h"
#include "package/prepared_curves.h"
#include "package/translated_errors.h"

namespace tessera::matching {
namespace {

CurvePart own_part(const tessera::CurvePart& part, const PreparedCurves& prepared) {
  return {part.curve, prepared.own(part.from), prepared.own(part.to)};
}

Match own_match(const CurveMatch& found, const PreparedCurves& a, const PreparedCurves& b) {
  Match match;
  match.a_from_b = a.own_from_prepared * to_public(found.a_from_b) * b.own_from_prepared.inverse();
  for (const tessera::MatchedRun& run : found.runs) {
    match.runs.push_back({own_part(run.of_a, a), own_part(run.of_b, b), run.reversed});
  }
  match.part_of_a = found.part_of_a;
  match.part_of_b = found.part_of_b;
  match.similarity = found.similarity;
  match.score = found.score;
  return match;
}

PreparedCurves prepared_as(const std::string& name, const Outline& outline) {
  try {
    return prepared_curves(outline);
  } catch (const Error& error) {
    throw Error(name + ": " + error.what());
  }
}

}  // namespace

std::vector<Match> match(const Outline& a, const Outline& b, std::size_t most) {
  return with_errors_translated([&] {
    const PreparedCurves of_a = prepared_as("A", a);
    const PreparedCurves of_b = prepared_as("B", b);
    std::vector<Match> matches;
    for (const CurveMatch& found :
         matched_curves({of_a.curves, of_a.least_sigma}, {of_b.curves, of_b.least_sigma}, most)) {
      matches.push_back(own_match(found, of_a, of_b));
    }
    return matches;
  });
}

}  // namespace tessera::matching
