// The communicator of an MPI job. MPI must be initialised before (mpi_job.h).
#pragma once

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/request.hpp>
#include <list>
#include <mutex>

#include "comm/communicator.h"

namespace tessera::comm {

class MpiCommunicator : public Communicator {
 public:
  /// Connects all ranks of the job; all ranks must call it together. Messages of different objects do not mix.
  MpiCommunicator();

  int rank() const override { return world_.rank(); }
  int size() const override { return world_.size(); }
  const std::vector<int>& node_ranks() const override { return node_ranks_; }
  std::string place_of(int rank) const override;
  [[noreturn]] void abort(int exit_code) override;

 protected:
  void start_send(int to, Tag tag, SharedBytes bytes) override;
  std::optional<Message> poll() override;
  std::size_t under_way() const override;

 private:
  struct Leaving {
    SharedBytes bytes;
    boost::mpi::request request;
  };
  struct Arriving {
    Message message;
    boost::mpi::request request;
  };

  void forget_sent();
  void begin_to_receive();
  std::optional<Message> take_arrived();

  boost::mpi::communicator world_;
  std::vector<int> node_ranks_;
  std::vector<std::string> hosts_;  // by rank
  mutable std::mutex mutex_;        // guards MPI and the members below: MPI was told that one thread calls at a time
  std::vector<Leaving> leaving_;
  std::size_t under_way_ = 0;
  std::list<Arriving> arriving_;  // in the order in which they were sent
};

}  // namespace tessera::comm
