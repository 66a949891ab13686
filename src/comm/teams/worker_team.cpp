#include "comm/teams/worker_team.h"

#include "comm/encode.h"
#include "comm/messages.h"
#include "comm/teams/remote_matcher.h"
#include "core/matching/composite_matcher.h"
#include "core/ranks/worker_tree.h"

namespace tessera::comm {
namespace {

/// What all are told alike is written once. The others are asked and waited for before this rank's own devices: those
/// work on while its messages come and go.
class WorkerTeam : public CompositeMatcher {
 public:
  /// `parts`: those of the `workers`, then this rank's own, if it has one.
  WorkerTeam(Communicator& ranks, std::vector<int> workers, Matcher* own, std::vector<std::unique_ptr<Matcher>> parts)
      : CompositeMatcher(std::move(parts)),
        ranks_(ranks),
        workers_(std::move(workers)),
        own_(own) {}

  void start_field(int width, int height, Vec2 origin) override {
    ranks_.send(workers_, Tag::start_field, encode(FieldStart{width, height, origin}));
    if (own_) own_->start_field(width, height, origin);
  }
  void update_field(const FieldPatch& patch) override {
    ranks_.send(workers_, Tag::update_field, encode(patch));
    if (own_) own_->update_field(patch);
  }
  void limit(const StandingLimits& limits) override {
    ranks_.send(workers_, Tag::limit, encode(limits));
    if (own_) own_->limit(limits);
  }
  void post_count(const CountRequest& request) override {
    ranks_.send(workers_, Tag::count_request, encode(request));
    if (own_) own_->post_count(request);
  }
  void post_dock(const DockRequest& request) override {
    expect_docks(request.samples.size());
    ranks_.send(workers_, Tag::dock_request, encode(request));
    if (own_) own_->post_dock(request);
  }

 private:
  Communicator& ranks_;
  std::vector<int> workers_;
  Matcher* own_;
};

}  // namespace

std::unique_ptr<Matcher> gather_workers(Communicator& ranks) { return gather_workers(ranks, nullptr); }

std::unique_ptr<Matcher> gather_workers(Communicator& ranks, std::unique_ptr<Matcher> own) {
  const std::vector<int> workers = place_in_tree(ranks.rank(), ranks.size()).children;
  if (workers.empty()) return own;
  std::vector<std::unique_ptr<Matcher>> parts;
  for (const int worker : workers) {
    const auto shapes = decode<ShapeRange>(ranks.receive(worker, Tag::hello));
    parts.push_back(std::make_unique<RemoteMatcher>(ranks, worker, shapes));
  }
  Matcher* const devices = own.get();
  if (own) parts.push_back(std::move(own));
  return std::make_unique<WorkerTeam>(ranks, workers, devices, std::move(parts));
}

std::vector<WorkerTimes> gather_times(Communicator& ranks) {
  const std::vector<int> workers = place_in_tree(ranks.rank(), ranks.size()).children;
  ranks.send(workers, Tag::times_request, {});
  std::vector<WorkerTimes> times;
  for (const int worker : workers) {
    const auto below = decode<std::vector<WorkerTimes>>(ranks.receive(worker, Tag::times_reply));
    times.insert(times.end(), below.begin(), below.end());
  }
  return times;
}

}  // namespace tessera::comm
