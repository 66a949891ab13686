#include "comm/teams/remote_matcher.h"

#include "comm/encode.h"
#include "comm/messages.h"

namespace tessera::comm {

RemoteMatcher::RemoteMatcher(Communicator& ranks, int worker, ShapeRange shapes)
    : ranks_(ranks),
      worker_(worker),
      shapes_(shapes) {}

void RemoteMatcher::start_field(int width, int height, Vec2 origin) {
  ranks_.send(worker_, Tag::start_field, encode(FieldStart{width, height, origin}));
}

void RemoteMatcher::update_field(const FieldPatch& patch) { ranks_.send(worker_, Tag::update_field, encode(patch)); }

void RemoteMatcher::limit(const StandingLimits& limits) { ranks_.send(worker_, Tag::limit, encode(limits)); }

void RemoteMatcher::post_count(const CountRequest& request) {
  ranks_.send(worker_, Tag::count_request, encode(request));
}

std::vector<DistanceHistogram> RemoteMatcher::take_count() {
  return decode<std::vector<DistanceHistogram>>(ranks_.receive(worker_, Tag::count_reply));
}

void RemoteMatcher::post_dock(const DockRequest& request) { ranks_.send(worker_, Tag::dock_request, encode(request)); }

DockReply RemoteMatcher::take_dock() { return decode<DockReply>(ranks_.receive(worker_, Tag::dock_reply)); }

void RemoteMatcher::post_refine(const std::vector<Docking>& dockings) {
  ranks_.send(worker_, Tag::refine_request, encode(dockings));
}

std::vector<RefinedDocking> RemoteMatcher::take_refine() {
  return decode<std::vector<RefinedDocking>>(ranks_.receive(worker_, Tag::refine_reply));
}

void RemoteMatcher::post_measure(const std::vector<Docking>& dockings) {
  ranks_.send(worker_, Tag::measure_request, encode(dockings));
}

std::vector<DockingTerms> RemoteMatcher::take_measure() {
  return decode<std::vector<DockingTerms>>(ranks_.receive(worker_, Tag::measure_reply));
}

}  // namespace tessera::comm
