#include "comm/matcher_server.h"

#include <stdexcept>

#include "comm/encode.h"
#include "comm/messages.h"

namespace tessera::comm {
namespace {

constexpr int kMaster = 0;

void start_field(Matcher& matcher, const FieldStart& start) {
  matcher.start_field(start.width, start.height, start.origin);
}

void answer(const Message& request, Communicator& ranks, Matcher& matcher) {
  switch (request.tag) {
    case Tag::start_field: start_field(matcher, decode<FieldStart>(request.bytes)); break;
    case Tag::update_field: matcher.update_field(decode<FieldPatch>(request.bytes)); break;
    case Tag::count_request:
      matcher.post_count(decode<CountRequest>(request.bytes));
      ranks.send(kMaster, Tag::count_reply, encode(matcher.take_count()));
      break;
    case Tag::dock_request:
      matcher.post_dock(decode<DockRequest>(request.bytes));
      ranks.send(kMaster, Tag::dock_reply, encode(matcher.take_dock()));
      break;
    case Tag::refine_request:
      matcher.post_refine(decode<std::vector<Docking>>(request.bytes));
      ranks.send(kMaster, Tag::refine_reply, encode(matcher.take_refine()));
      break;
    default: throw std::logic_error("a message that is no question: " + std::string(tag_name(request.tag)));
  }
}

}  // namespace

void serve(Communicator& ranks, Matcher& matcher) {
  ranks.send(kMaster, Tag::hello, encode(matcher.shapes()));
  for (;;) {
    const Message request = ranks.receive_any(
        kMaster, {Tag::start_field, Tag::update_field, Tag::count_request, Tag::dock_request, Tag::refine_request});
    // While this rank computes it cannot help a large reply along, which the master may be waiting for.
    ranks.flush();
    answer(request, ranks, matcher);
  }
}

}  // namespace tessera::comm
