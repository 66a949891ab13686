// Ranks that are threads of one process: for tests, and for a run without MPI.
#pragma once

#include <memory>

#include "comm/communicator.h"

namespace tessera::comm {

/// The message queues between the ranks; must outlive all communicators.
class InProcessNetwork {
 public:
  explicit InProcessNetwork(int size);
  ~InProcessNetwork();

  /// Makes the communicator for the thread of rank `rank`; call it at most once for each rank.
  std::unique_ptr<Communicator> connect(int rank);

 private:
  friend class InProcessCommunicator;
  struct Queue;

  std::vector<std::unique_ptr<Queue>> queues_;  // per receiving rank
};

/// Thrown by abort() of such a rank, and then by whatever the other ranks call next.
struct InProcessAbort {
  int exit_code = 0;
};

}  // namespace tessera::comm
