#include "comm/teams/worker_team.h"

#include <utility>

#include "comm/encode.h"
#include "comm/messages.h"
#include "core/matching/composite_matcher.h"
#include "core/ranks/worker_tree.h"

namespace tessera::comm {
namespace {

/// A worker's part of the library and the parts of the workers below it, asked by messages (worker_server.h).
class RemotePart : public MatcherPart {
 public:
  RemotePart(Communicator& ranks, int worker)
      : ranks_(ranks),
        worker_(worker),
        shapes_(decode<ShapeRange>(ranks.receive(worker, Tag::hello))) {}

  ShapeRange shapes() const override { return shapes_; }
  std::vector<DistanceHistogram> take_count() override {
    return received<std::vector<DistanceHistogram>>(Tag::count_reply);
  }
  DockReply take_dock() override { return received<DockReply>(Tag::dock_reply); }
  void post_refine(const std::vector<Docking>& dockings) override {
    ranks_.send(worker_, Tag::refine_request, encode(dockings));
  }
  std::vector<RefinedDocking> take_refine() override {
    return received<std::vector<RefinedDocking>>(Tag::refine_reply);
  }
  void post_measure(const std::vector<Docking>& dockings) override {
    ranks_.send(worker_, Tag::measure_request, encode(dockings));
  }
  std::vector<DockingTerms> take_measure() override { return received<std::vector<DockingTerms>>(Tag::measure_reply); }

 private:
  template <class Answer>
  Answer received(Tag tag) {
    return decode<Answer>(ranks_.receive(worker_, tag));
  }

  Communicator& ranks_;
  int worker_;
  ShapeRange shapes_;
};

using RemoteParts = std::vector<std::unique_ptr<RemotePart>>;

/// The parts of the workers, then this rank's own part, if it has one.
std::vector<MatcherPart*> in_order(const RemoteParts& remote, Matcher* own) {
  std::vector<MatcherPart*> parts;
  for (const auto& part : remote) parts.push_back(part.get());
  if (own) parts.push_back(own);
  return parts;
}

/// A matcher that sends the same message to all workers and encodes it only once. The workers are asked, and their
/// answers awaited, before this rank's own devices: these go on computing meanwhile.
class WorkerTeam : public JoinedMatcher {
 public:
  /// `remote`: the parts of the `workers`. `own`: this rank's part, or null.
  WorkerTeam(Communicator& ranks, std::vector<int> workers, RemoteParts remote, std::unique_ptr<Matcher> own)
      : JoinedMatcher(in_order(remote, own.get())),
        ranks_(ranks),
        workers_(std::move(workers)),
        remote_(std::move(remote)),
        own_(std::move(own)) {}

  void start_field(int width, int height, Vec2 origin) override {
    ranks_.send(workers_, Tag::start_field, encode(FieldStart{width, height, origin}));
    if (own_) own_->start_field(width, height, origin);
  }
  void update_field(const std::vector<FieldPatch>& patches) override {
    ranks_.send(workers_, Tag::update_field, encode(patches));
    if (own_) own_->update_field(patches);
  }
  void limit(const StanceLimits& limits) override {
    ranks_.send(workers_, Tag::limit, encode(limits));
    if (own_) own_->limit(limits);
  }

 private:
  void post_count_to_all(const CountRequest& request) override {
    ranks_.send(workers_, Tag::count_request, encode(request));
    if (own_) own_->post_count(request);
  }
  void post_dock_to_all(const DockRequest& request) override {
    ranks_.send(workers_, Tag::dock_request, encode(request));
    if (own_) own_->post_dock(request);
  }

  Communicator& ranks_;
  std::vector<int> workers_;
  RemoteParts remote_;
  std::unique_ptr<Matcher> own_;
};

}  // namespace

std::unique_ptr<Matcher> gather_workers(Communicator& ranks) { return gather_workers(ranks, nullptr); }

std::unique_ptr<Matcher> gather_workers(Communicator& ranks, std::unique_ptr<Matcher> own) {
  const std::vector<int> workers = place_in_tree(ranks.rank(), ranks.size()).children;
  if (workers.empty()) return own;
  RemoteParts remote;
  for (const int worker : workers) remote.push_back(std::make_unique<RemotePart>(ranks, worker));
  return std::make_unique<WorkerTeam>(ranks, workers, std::move(remote), std::move(own));
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
