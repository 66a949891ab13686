// The ranks of an MPI job. MPI must be initialised (mpi_guard.h).
#pragma once

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/request.hpp>

#include "comm/communicator.h"

namespace tessera::comm {

class MpiCommunicator : public Communicator {
 public:
  /// All ranks of the job; made by all of them together. Its messages do not mix with those of another one.
  MpiCommunicator();

  int rank() const override { return world_.rank(); }
  int size() const override { return world_.size(); }
  const std::vector<int>& node_ranks() const override { return node_ranks_; }
  std::string place() const override;
  [[noreturn]] void abort(int exit_code) override;

 protected:
  void start_send(int to, Tag tag, SharedBytes bytes) override;
  std::optional<Message> poll() override;
  std::size_t under_way() const override { return under_way_; }

 private:
  struct Leaving {
    SharedBytes bytes;
    boost::mpi::request request;
  };

  void forget_sent();

  boost::mpi::communicator world_;
  std::vector<int> node_ranks_;
  std::vector<Leaving> leaving_;
  std::size_t under_way_ = 0;
};

}  // namespace tessera::comm
