#include "master/loop_end.h"

namespace tessera::master {

bool LoopEnd::has_all_pieces(std::size_t pieces) const {
  return limits_.pieces > 0 && pieces >= std::size_t(limits_.pieces);
}

bool LoopEnd::is_covered(double covered_px2) const {
  return covered_px2 >= double(limits_.coverage) * canvas_.area_px2;
}

bool LoopEnd::reached_limit(double covered_px2) {
  const bool covered = is_covered(covered_px2);
  const bool late = limits_.seconds > 0 && run_s() >= limits_.seconds;
  if (covered || late) end_by(late ? StopReason::seconds : StopReason::coverage);
  return covered || late;
}

bool LoopEnd::end_at_limit_of_filling(std::size_t pieces, double covered_px2) {
  if (!has_all_pieces(pieces)) return reached_limit(covered_px2);
  end_by(StopReason::pieces);
  return true;
}

void LoopEnd::check_stop() {
  if (const std::optional<StopReason> reason = observer_.stop_requested()) {
    asked_to_stop_ = true;
    throw Interrupted{*reason};
  }
}

}  // namespace tessera::master
