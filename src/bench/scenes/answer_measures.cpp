#include "bench/scenes/answer_measures.h"

#include <algorithm>

#include "recognition/answer_score.h"

namespace tessera::bench {
namespace {

double margin_of(const std::vector<Recognition>& found, const SilhouetteLibrary& library, const Twins& twins) {
  const auto silhouette = [&](const Recognition& r) { return library.shapes[index_of(r.shape)].silhouette; };
  const auto second = std::find_if(found.begin(), found.end(), [&](const Recognition& r) {
    return !twins.are_twins(silhouette(r), silhouette(found.front()));
  });
  return double(found.front().similarity) - (second == found.end() ? 0 : double(second->similarity));
}

}  // namespace

AnswerMeasures answer_measures(const std::vector<Recognition>& found, const SilhouetteLibrary& library,
                               const Twins& twins) {
  if (found.empty()) return {};
  const Recognition& best = found.front();
  return {double(best.similarity), margin_of(found, library, twins),
          answer_score(best, library.shapes[index_of(best.shape)].outline)};
}

}  // namespace tessera::bench
