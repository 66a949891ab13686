#include "comm/in_process_communicator.h"

#include <mutex>
#include <numeric>

namespace tessera::comm {

struct InProcessNetwork::Queue {
  std::mutex mutex;
  std::deque<Message> messages;
  std::optional<int> aborted;
};

InProcessNetwork::InProcessNetwork(int size) {
  for (int rank = 0; rank < size; ++rank) queues_.push_back(std::make_unique<Queue>());
}

InProcessNetwork::~InProcessNetwork() = default;

class InProcessCommunicator : public Communicator {
 public:
  InProcessCommunicator(InProcessNetwork& network, int rank)
      : network_(network),
        rank_(rank),
        node_ranks_(network.queues_.size()) {
    std::iota(node_ranks_.begin(), node_ranks_.end(), 0);
  }

  int rank() const override { return rank_; }
  int size() const override { return int(network_.queues_.size()); }
  const std::vector<int>& node_ranks() const override { return node_ranks_; }
  std::string place_of(int rank) const override { return "rank " + std::to_string(rank); }

  [[noreturn]] void abort(int exit_code) override {
    for (const auto& queue : network_.queues_) {
      const std::lock_guard lock(queue->mutex);
      queue->aborted = exit_code;
    }
    throw InProcessAbort{exit_code};
  }

 protected:
  void start_send(int to, Tag tag, SharedBytes bytes) override {
    InProcessNetwork::Queue& queue = *network_.queues_.at(std::size_t(to));
    const std::lock_guard lock(queue.mutex);
    queue.messages.push_back({rank_, tag, *bytes});
  }

  std::optional<Message> poll() override {
    InProcessNetwork::Queue& queue = *network_.queues_[std::size_t(rank_)];
    const std::lock_guard lock(queue.mutex);
    if (queue.aborted) throw InProcessAbort{*queue.aborted};
    if (queue.messages.empty()) return std::nullopt;
    Message message = std::move(queue.messages.front());
    queue.messages.pop_front();
    return message;
  }

  std::size_t under_way() const override { return 0; }

 private:
  InProcessNetwork& network_;
  int rank_;
  std::vector<int> node_ranks_;
};

std::unique_ptr<Communicator> InProcessNetwork::connect(int rank) {
  return std::make_unique<InProcessCommunicator>(*this, rank);
}

}  // namespace tessera::comm
