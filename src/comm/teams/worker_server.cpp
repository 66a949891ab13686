#include "comm/teams/worker_server.h"

#include <stdexcept>

#include "comm/encode.h"
#include "comm/messages.h"
#include "comm/teams/replacer_team.h"
#include "comm/teams/worker_clock.h"
#include "comm/teams/worker_team.h"
#include "core/ranks/worker_tree.h"

namespace tessera::comm {
namespace {

void start_field(Matcher& matcher, const FieldStart& start) {
  matcher.start_field(start.width, start.height, start.origin);
}

std::vector<DistanceHistogram> count(Matcher& matcher, const CountRequest& request) {
  matcher.post_count(request);
  return matcher.take_count();
}

DockReply dock(Matcher& matcher, const DockRequest& request) {
  matcher.post_dock(request);
  return matcher.take_dock();
}

std::vector<RefinedDocking> refine(Matcher& matcher, const std::vector<Docking>& dockings) {
  matcher.post_refine(dockings);
  return matcher.take_refine();
}

std::vector<DockingTerms> measure(Matcher& matcher, const std::vector<Docking>& dockings) {
  matcher.post_measure(dockings);
  return matcher.take_measure();
}

std::vector<ReplacementOutcome> replace(Replacer& replacer, const std::vector<ReplacementWindow>& windows) {
  replacer.post_replace(windows);
  return replacer.take_replaced();
}

/// Answers a request with `ask` and adds the time to `stage`.
template <class Asked, class Question, class Answer>
Bytes measured_answer(const Message& request, Asked& asked, WorkerClock& clock, double WorkerTimes::*stage,
                      std::uint64_t WorkerTimes::*questions, Answer (*ask)(Asked&, const Question&)) {
  const auto question = decode<Question>(request.bytes);
  return encode(clock.measure(stage, questions, [&] { return ask(asked, question); }));
}

/// Times of the workers below and of this worker, in the order of the ranks.
std::vector<WorkerTimes> times_of(Communicator& ranks, WorkerClock& clock) {
  const WorkerTimes own = clock.end_loop();
  std::vector<WorkerTimes> times = gather_times(ranks);
  times.push_back(own);
  return times;
}

void answer(const Message& request, Communicator& ranks, Matcher& matcher, Replacer& replacer, WorkerClock& clock) {
  using Times = WorkerTimes;
  const int asker = request.from;
  switch (request.tag) {
    case Tag::start_field:
      clock.begin_field();
      start_field(matcher, decode<FieldStart>(request.bytes));
      break;
    case Tag::update_field: {
      const auto patches = decode<std::vector<FieldPatch>>(request.bytes);
      clock.measure(&Times::field_s, [&] { matcher.update_field(patches); });
      break;
    }
    case Tag::limit: matcher.limit(decode<StanceLimits>(request.bytes)); break;
    case Tag::count_request:
      ranks.send(asker, Tag::count_reply,
                 measured_answer(request, matcher, clock, &Times::count_s, &Times::counts, count));
      break;
    case Tag::dock_request:
      ranks.send(asker, Tag::dock_reply, measured_answer(request, matcher, clock, &Times::dock_s, &Times::docks, dock));
      break;
    case Tag::refine_request:
      ranks.send(asker, Tag::refine_reply,
                 measured_answer(request, matcher, clock, &Times::refine_s, &Times::refines, refine));
      break;
    case Tag::measure_request:
      ranks.send(asker, Tag::measure_reply,
                 measured_answer(request, matcher, clock, &Times::measure_s, &Times::measures, measure));
      break;
    case Tag::replace_request:
      ranks.send(asker, Tag::replace_reply,
                 measured_answer(request, replacer, clock, &Times::replace_s, &Times::replaces, replace));
      break;
    case Tag::times_request: ranks.send(asker, Tag::times_reply, encode(times_of(ranks, clock))); break;
    default: throw std::logic_error("a message that is no question: " + std::string(tag_name(request.tag)));
  }
}

}  // namespace

void serve(Communicator& ranks, std::unique_ptr<Matcher> own_matcher, std::unique_ptr<Replacer> own_replacer) {
  const std::unique_ptr<Matcher> matcher = gather_workers(ranks, std::move(own_matcher));
  const std::unique_ptr<Replacer> replacer = gather_replacers(ranks, std::move(own_replacer));
  const int asker = place_in_tree(ranks.rank(), ranks.size()).parent;
  ranks.send(asker, Tag::hello, encode(matcher->shapes()));
  ranks.send(asker, Tag::breadth, encode(replacer->breadth()));
  WorkerClock clock(ranks);
  for (;;) {
    const Message request = ranks.receive_any(
        asker, {Tag::start_field, Tag::update_field, Tag::limit, Tag::count_request, Tag::dock_request,
                Tag::refine_request, Tag::measure_request, Tag::replace_request, Tag::times_request});
    // While this rank computes it cannot move a large reply on, for which others may be waiting.
    ranks.flush();
    answer(request, ranks, *matcher, *replacer, clock);
  }
}

}  // namespace tessera::comm
