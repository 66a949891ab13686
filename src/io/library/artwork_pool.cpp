#include "io/library/artwork_pool.h"

#include <poll.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "io/library/worker_process.h"

namespace tessera::io {
namespace {

using Clock = WorkerProcess::Clock;

/// How far the work may run ahead of a slow input: that many results are held in memory.
constexpr std::size_t kAhead = 256;
constexpr int kPollMilliseconds = 100;

class Pool {
 public:
  Pool(const std::vector<std::string>& inputs, const PoolWork& work, const PoolSettings& settings)
      : inputs_(inputs),
        work_(work),
        settings_(settings) {
    const std::size_t wanted = std::min<std::size_t>(std::max(1, settings.processes), inputs.size());
    for (std::size_t i = 0; i < wanted; ++i) workers_.emplace_back(work, settings);
  }

  bool finished() const { return consumed_ == inputs_.size(); }

  void give_inputs() {
    const std::size_t end = std::min(inputs_.size(), consumed_ + kAhead);
    for (WorkerProcess& worker : workers_) {
      if (worker.busy() || given_ == end) continue;
      worker.give(given_, inputs_[given_], Clock::now() + allowed_time());
      ++given_;
    }
  }

  void collect() {
    std::vector<pollfd> watched;
    for (const WorkerProcess& worker : workers_) watched.push_back({worker.descriptor(), POLLIN, 0});
    ::poll(watched.data(), watched.size(), kPollMilliseconds);  // ends early for a signal, too
    for (std::size_t i = 0; i < workers_.size(); ++i) {
      if (watched[i].revents != 0) receive_from(workers_[i]);
      if (workers_[i].busy() && Clock::now() > workers_[i].deadline()) give_up_on(workers_[i]);
    }
  }

  void hand_over(const PoolConsumer& consume) {
    for (auto at = waiting_.find(consumed_); at != waiting_.end(); at = waiting_.find(consumed_)) {
      PoolResult result = std::move(at->second);
      waiting_.erase(at);
      consume(consumed_, std::move(result));
      ++consumed_;
    }
  }

 private:
  Clock::duration allowed_time() const {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(settings_.seconds_per_input));
  }

  void receive_from(WorkerProcess& worker) {
    const bool busy = worker.busy();
    const std::size_t input = busy ? worker.input() : 0;
    PoolResult result;
    const WorkerProcess::Answer answer = worker.receive(result);
    if (answer == WorkerProcess::Answer::complete) waiting_[input] = std::move(result);
    if (answer == WorkerProcess::Answer::dead) {
      const std::string reason = worker.end();
      if (busy) waiting_[input] = {false, {}, reason};
      worker = WorkerProcess(work_, settings_);
    }
  }

  void give_up_on(WorkerProcess& worker) {
    const auto seconds = std::to_string(std::lround(std::ceil(settings_.seconds_per_input)));
    waiting_[worker.input()] = {false, {}, "took longer than " + seconds + " s"};
    worker = WorkerProcess(work_, settings_);
  }

  const std::vector<std::string>& inputs_;
  const PoolWork& work_;
  const PoolSettings& settings_;
  std::vector<WorkerProcess> workers_;
  std::map<std::size_t, PoolResult> waiting_;  // finished, but an earlier one is not
  std::size_t given_ = 0;
  std::size_t consumed_ = 0;
};

}  // namespace

bool work_in_processes(const std::vector<std::string>& inputs, const PoolWork& work, const PoolConsumer& consume,
                       const PoolSettings& settings, const std::function<bool()>& interrupted) {
  Pool pool(inputs, work, settings);
  while (!pool.finished()) {
    if (interrupted()) return false;
    pool.give_inputs();
    pool.collect();
    pool.hand_over(consume);
  }
  return true;
}

}  // namespace tessera::io
