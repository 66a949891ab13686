// Ranks that are threads of one process: for tests, where the same things must hold as under MPI.
#pragma once

#include <memory>

#include "comm/communicator.h"

namespace tessera::comm {

/// The queues between the ranks; lives as long as any of its communicators.
class InProcessNetwork {
 public:
  explicit InProcessNetwork(int size);
  ~InProcessNetwork();

  /// Makes the communicator of the thread that plays `rank`, at most one for each.
  std::unique_ptr<Communicator> connect(int rank);

 private:
  friend class InProcessCommunicator;
  struct Queue;

  std::vector<std::unique_ptr<Queue>> queues_;  // per receiving rank
};

/// abort() of such a rank throws this, and so does whatever the others do next.
struct InProcessAbort {
  int exit_code = 0;
};

}  // namespace tessera::comm
