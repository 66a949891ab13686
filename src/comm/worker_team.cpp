#include "comm/worker_team.h"

#include "comm/encode.h"
#include "comm/messages.h"
#include "comm/remote_matcher.h"
#include "core/composite_matcher.h"

namespace tessera::comm {
namespace {

/// What all workers are told alike is written once.
class WorkerTeam : public CompositeMatcher {
 public:
  WorkerTeam(Communicator& ranks, std::vector<std::unique_ptr<Matcher>> workers)
      : CompositeMatcher(std::move(workers)),
        ranks_(ranks) {}

  void start_field(int width, int height, Vec2 origin) override {
    ranks_.send_to_others(Tag::start_field, encode(FieldStart{width, height, origin}));
  }
  void update_field(const FieldPatch& patch) override { ranks_.send_to_others(Tag::update_field, encode(patch)); }
  void post_count(const CountRequest& request) override { ranks_.send_to_others(Tag::count_request, encode(request)); }
  void post_dock(const DockRequest& request) override {
    expect_docks(request.samples.size());
    ranks_.send_to_others(Tag::dock_request, encode(request));
  }

 private:
  Communicator& ranks_;
};

}  // namespace

std::unique_ptr<Matcher> gather_workers(Communicator& ranks) {
  std::vector<std::unique_ptr<Matcher>> workers;
  for (int worker = 1; worker < ranks.size(); ++worker) {
    const auto shapes = decode<ShapeRange>(ranks.receive(worker, Tag::hello));
    workers.push_back(std::make_unique<RemoteMatcher>(ranks, worker, shapes));
  }
  return std::make_unique<WorkerTeam>(ranks, std::move(workers));
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
