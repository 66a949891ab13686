#include "comm/teams/node_turn.h"

namespace tessera::comm {

void first_worker_of_node_first(Communicator& ranks, const std::function<void()>& action) {
  std::vector<int> workers = ranks.node_ranks();
  std::erase(workers, 0);
  const int first = workers.front();
  if (ranks.rank() != first) ranks.receive(first, Tag::turn);
  action();
  if (ranks.rank() != first) return;
  for (const int other : workers) {
    if (other != first) ranks.send(other, Tag::turn, {});
  }
}

}  // namespace tessera::comm
