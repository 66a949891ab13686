#include "comm/mpi_communicator.h"

#include <boost/mpi/collectives/all_gather.hpp>
#include <boost/mpi/environment.hpp>
#include <boost/mpi/exception.hpp>
#include <boost/mpi/status.hpp>
#include <limits>
#include <stdexcept>

namespace tessera::comm {
namespace {

namespace mpi = boost::mpi;

std::vector<int> ranks_of_this_node(const mpi::communicator& world) {
  MPI_Comm shared = MPI_COMM_NULL;
  BOOST_MPI_CHECK_RESULT(MPI_Comm_split_type,
                         (MPI_Comm(world), MPI_COMM_TYPE_SHARED, world.rank(), MPI_INFO_NULL, &shared));
  const mpi::communicator node(shared, mpi::comm_take_ownership);
  std::vector<int> ranks;
  mpi::all_gather(node, world.rank(), ranks);
  return ranks;
}

// A message without content still counts, so that "nothing under way" means that all have left.
std::size_t weight(const Bytes& bytes) { return bytes.size() + 1; }

/// Boost.MPI dereferences the pointer even where there is nothing to send.
template <class BytesOrConst>
auto content(BytesOrConst& bytes) {
  static char nothing = 0;
  return bytes.empty() ? &nothing : bytes.data();
}

}  // namespace

MpiCommunicator::MpiCommunicator()
    : world_(MPI_COMM_WORLD, mpi::comm_duplicate), node_ranks_(ranks_of_this_node(world_)) {}

std::string MpiCommunicator::place() const {
  return "rank " + std::to_string(rank()) + " on " + mpi::environment::processor_name();
}

void MpiCommunicator::abort(int exit_code) {
  mpi::environment::abort(exit_code);
  throw std::logic_error("MPI_Abort returned");
}

void MpiCommunicator::start_send(int to, Tag tag, SharedBytes bytes) {
  if (bytes->size() > std::size_t(std::numeric_limits<int>::max())) {
    throw std::length_error("a message of more than 2 GiB");
  }
  Leaving leaving{std::move(bytes), {}};
  leaving.request = world_.isend(to, int(tag), content(*leaving.bytes), int(leaving.bytes->size()));
  under_way_ += weight(*leaving.bytes);
  leaving_.push_back(std::move(leaving));
}

void MpiCommunicator::forget_sent() {
  std::erase_if(leaving_, [this](Leaving& leaving) {
    if (!leaving.request.test()) return false;
    under_way_ -= weight(*leaving.bytes);
    return true;
  });
}

std::optional<Message> MpiCommunicator::poll() {
  forget_sent();
  const boost::optional<mpi::status> arrived = world_.iprobe(mpi::any_source, mpi::any_tag);
  if (!arrived) return std::nullopt;
  Message message{arrived->source(), Tag(arrived->tag()), Bytes(std::size_t(*arrived->count<char>()))};
  world_.recv(message.from, arrived->tag(), content(message.bytes), int(message.bytes.size()));
  return message;
}

}  // namespace tessera::comm
