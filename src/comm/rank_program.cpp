#include "comm/rank_program.h"

#include "comm/failure.h"
#include "comm/stop_signals.h"

namespace tessera::comm {
namespace {

constexpr double kLeavePatience_s = 10;  // a worker may be in the middle of a request
constexpr double kGivenUpPatience_s =
    2;  // it may be in the middle of a launch; the time limit is near, or the user waits
constexpr double kAtOncePatience_s = 0.1;  // out of the two seconds that mpirun leaves

int run_first(Communicator& ranks, const RankProgram& program) {
  try {
    return program.run(ranks);
  } catch (...) {
    const Failure failure = describe_current_exception();
    program.report_error(failure.text);
    return failure.exit_code;
  }
}

double leave_patience_s(const Communicator& ranks) {
  if (ranks.lost_a_worker()) return 0;
  return ranks.wait_was_interrupted() ? kGivenUpPatience_s : kLeavePatience_s;
}

RankResult end_job(Communicator& ranks, int exit_code, Ending ending) {
  ranks.tell_end(ending);
  if (ending == Ending::at_once) {
    ranks.wait_until_sent(kAtOncePatience_s);
  } else if (!ranks.wait_for_goodbyes(leave_patience_s(ranks))) {
    ranks.abort(exit_code);
  }
  return {exit_code, ending};
}

void run_other(Communicator& ranks, const RankProgram& program) {
  try {
    program.run(ranks);
  } catch (const JobEnded&) {
  } catch (...) {
    Failure failure = describe_current_exception();
    failure.text = ranks.place() + ": " + failure.text;
    ranks.report_failure(failure);
  }
}

}  // namespace

RankResult run_rank(Communicator& ranks, const RankProgram& program) {
  if (ranks.rank() != 0) {
    run_other(ranks, program);
    return {0, ranks.wait_for_end()};
  }
  const int exit_code = run_first(ranks, program);
  return end_job(ranks, exit_code, launcher_ends_job() ? Ending::at_once : Ending::orderly);
}

}  // namespace tessera::comm
