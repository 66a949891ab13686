#include "comm/teams/remote_replacer.h"

#include "comm/encode.h"
#include "comm/messages.h"

namespace tessera::comm {

RemoteReplacer::RemoteReplacer(Communicator& ranks, int worker, int breadth)
    : ranks_(ranks),
      worker_(worker),
      breadth_(breadth) {}

void RemoteReplacer::post_replace(std::vector<ReplacementWindow> windows) {
  ranks_.send(worker_, Tag::replace_request, encode(windows));
}

std::vector<ReplacementOutcome> RemoteReplacer::take_replaced() {
  return decode<std::vector<ReplacementOutcome>>(ranks_.receive(worker_, Tag::replace_reply));
}

}  // namespace tessera::comm
