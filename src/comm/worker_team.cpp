#include "comm/worker_team.h"

#include "comm/encode.h"
#include "comm/messages.h"
#include "comm/remote_matcher.h"
#include "core/composite_matcher.h"

namespace tessera::comm {

std::unique_ptr<Matcher> gather_workers(Communicator& ranks) {
  std::vector<std::unique_ptr<Matcher>> workers;
  for (int worker = 1; worker < ranks.size(); ++worker) {
    const auto shapes = decode<ShapeRange>(ranks.receive(worker, Tag::hello));
    workers.push_back(std::make_unique<RemoteMatcher>(ranks, worker, shapes));
  }
  return std::make_unique<CompositeMatcher>(std::move(workers));
}

std::vector<WorkerTimes> gather_times(Communicator& ranks) {
  for (int worker = 1; worker < ranks.size(); ++worker) ranks.send(worker, Tag::times_request, {});
  std::vector<WorkerTimes> times;
  for (int worker = 1; worker < ranks.size(); ++worker) {
    times.push_back(decode<WorkerTimes>(ranks.receive(worker, Tag::times_reply)));
  }
  return times;
}

}  // namespace tessera::comm
