#include "bench/concepts/weighed_matcher.h"

#include <utility>

#include "comm/encode.h"
#include "comm/messages.h"

namespace tessera::bench::concepts {
namespace {

template <class Message>
void weigh_question(QuestionWeight& weight, const Message& message) {
  ++weight.asked;
  weight.sent_bytes += comm::encode(message).size();
}

template <class Message>
Message weighed_answer(QuestionWeight& weight, Message message) {
  weight.answered_bytes += comm::encode(message).size();
  return message;
}

}  // namespace

void WeighedMatcher::update_field(const std::vector<FieldPatch>& patches) {
  weigh_question(weight_.field, patches);
  matcher_->update_field(patches);
}

void WeighedMatcher::post_count(const CountRequest& request) {
  weigh_question(weight_.count, request);
  matcher_->post_count(request);
}

std::vector<DistanceHistogram> WeighedMatcher::take_count() {
  return weighed_answer(weight_.count, matcher_->take_count());
}

void WeighedMatcher::post_dock(const DockRequest& request) {
  weigh_question(weight_.dock, request);
  matcher_->post_dock(request);
}

DockReply WeighedMatcher::take_dock() { return weighed_answer(weight_.dock, matcher_->take_dock()); }

void WeighedMatcher::post_refine(const std::vector<Docking>& dockings) {
  weigh_question(weight_.refine, dockings);
  matcher_->post_refine(dockings);
}

std::vector<RefinedDocking> WeighedMatcher::take_refine() {
  return weighed_answer(weight_.refine, matcher_->take_refine());
}

void WeighedMatcher::post_measure(const std::vector<Docking>& dockings) {
  weigh_question(weight_.measure, dockings);
  matcher_->post_measure(dockings);
}

std::vector<DockingTerms> WeighedMatcher::take_measure() {
  return weighed_answer(weight_.measure, matcher_->take_measure());
}

}  // namespace tessera::bench::concepts
