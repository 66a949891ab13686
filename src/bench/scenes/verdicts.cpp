#include "bench/scenes/verdicts.h"

namespace tessera::bench {

PrecisionRecall precision_recall(std::span<const Verdict> verdicts, double least) {
  PrecisionRecall counts{least};
  for (const Verdict& verdict : verdicts) {
    if (verdict.known) ++counts.known;
    if (!verdict.told || verdict.measure < least) continue;
    ++counts.given;
    if (verdict.right) ++counts.right;
  }
  return counts;
}

PrecisionRecall best_threshold(std::span<const Verdict> verdicts) {
  PrecisionRecall best;
  for (const Verdict& verdict : verdicts) {
    if (!verdict.told) continue;
    const PrecisionRecall counts = precision_recall(verdicts, verdict.measure);
    if (counts.f1() > best.f1() || (counts.f1() == best.f1() && counts.least > best.least)) best = counts;
  }
  return best;
}

}  // namespace tessera::bench
