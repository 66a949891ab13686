#include "products/puzzle/solving_progress.h"

#include <algorithm>

#include "core/base/count_text.h"

namespace tessera {

SolvingProgress::Shown SolvingProgress::see(const PuzzleProgress& at) {
  if (at.laying && !laying_) {
    laying_ = true;
    most_ = 0;
  }
  if (at.laying && at.done < last_) ++arrangement_;
  if (at.laying) last_ = at.done;
  if (at.laying == laying_) most_ = std::max(most_, at.done);
  Shown shown{laying_ ? "laying" : "matching", most_, at.of, ""};
  if (!laying_) return shown;
  shown.note = at.laying ? count_text(at.done, "piece") : "matching again";
  if (arrangement_ > 1) shown.note = "arrangement " + std::to_string(arrangement_) + ": " + shown.note;
  return shown;
}

}  // namespace tessera
