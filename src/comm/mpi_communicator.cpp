#include "comm/mpi_communicator.h"

#include <algorithm>
#include <boost/mpi/collectives/all_gather.hpp>
#include <boost/mpi/environment.hpp>
#include <boost/mpi/exception.hpp>
#include <boost/mpi/status.hpp>
#include <limits>
#include <optional>
#include <stdexcept>

#include "comm/watchdog.h"

namespace tessera::comm {
namespace {

namespace mpi = boost::mpi;

constexpr double kAbortPatience_s = 5;

std::vector<int> ranks_of_this_node(const mpi::communicator& world) {
  MPI_Comm shared = MPI_COMM_NULL;
  BOOST_MPI_CHECK_RESULT(MPI_Comm_split_type,
                         (MPI_Comm(world), MPI_COMM_TYPE_SHARED, world.rank(), MPI_INFO_NULL, &shared));
  const mpi::communicator node(shared, mpi::comm_take_ownership);
  std::vector<int> ranks;
  mpi::all_gather(node, world.rank(), ranks);
  return ranks;
}

// Counts an empty message as one byte, so that 0 bytes under way means that all messages have left.
std::size_t weight(const Bytes& bytes) { return bytes.size() + 1; }

/// A valid pointer even for empty bytes: Boost.MPI dereferences the pointer in any case.
template <class BytesOrConst>
auto content(BytesOrConst& bytes) {
  static char nothing = 0;
  return bytes.empty() ? &nothing : bytes.data();
}

}  // namespace

MpiCommunicator::MpiCommunicator()
    : world_(MPI_COMM_WORLD, mpi::comm_duplicate),
      node_ranks_(ranks_of_this_node(world_)) {
  mpi::all_gather(world_, mpi::environment::processor_name(), hosts_);
}

std::string MpiCommunicator::place_of(int rank) const {
  return "rank " + std::to_string(rank) + " on " + hosts_.at(std::size_t(rank));
}

void MpiCommunicator::abort(int exit_code) {
  std::optional<Watchdog> watchdog;  // ends the process if the launcher does not answer
  start_if_possible(watchdog, kAbortPatience_s, exit_code);
  mpi::environment::abort(exit_code);
  throw std::logic_error("MPI_Abort returned");
}

void MpiCommunicator::start_send(int to, Tag tag, SharedBytes bytes) {
  if (bytes->size() > std::size_t(std::numeric_limits<int>::max())) {
    throw std::length_error("a message of more than 2 GiB");
  }
  const std::lock_guard lock(mutex_);
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

std::size_t MpiCommunicator::under_way() const {
  const std::lock_guard lock(mutex_);
  return under_way_;
}

/// Begins to receive without waiting for the rest of a message: its sender may have stopped in the middle.
void MpiCommunicator::begin_to_receive() {
  while (const boost::optional<mpi::status> begun = world_.iprobe(mpi::any_source, mpi::any_tag)) {
    Arriving& arriving = arriving_.emplace_back();
    Message& message = arriving.message;
    message = {begun->source(), Tag(begun->tag()), Bytes(std::size_t(*begun->count<char>()))};
    arriving.request = world_.irecv(message.from, begun->tag(), content(message.bytes), int(message.bytes.size()));
  }
}

/// The first message that is complete, but never before an earlier one of the same sender.
std::optional<Message> MpiCommunicator::take_arrived() {
  std::vector<int> late;
  for (auto arriving = arriving_.begin(); arriving != arriving_.end(); ++arriving) {
    const int from = arriving->message.from;
    if (std::find(late.begin(), late.end(), from) != late.end()) continue;
    if (arriving->request.test()) {
      Message message = std::move(arriving->message);
      arriving_.erase(arriving);
      return message;
    }
    late.push_back(from);
  }
  return std::nullopt;
}

std::optional<Message> MpiCommunicator::poll() {
  const std::lock_guard lock(mutex_);
  forget_sent();
  begin_to_receive();
  return take_arrived();
}

}  // namespace tessera::comm
