#include <gtest/gtest.h>

#include <thread>

#include "comm/in_process_communicator.h"
#include "on_all_ranks.h"

namespace tessera::comm::test {
namespace {

void run_one(Communicator& ranks, const std::function<void(Communicator&)>& body) {
  try {
    try {
      body(ranks);
    } catch (const InProcessAbort&) {
    } catch (const std::exception& error) {
      ADD_FAILURE() << ranks.place() << ": " << error.what();
    } catch (const JobEnded&) {
      ADD_FAILURE() << ranks.place() << " was told to leave";
    }
    if (testing::Test::HasFailure()) ranks.abort(1);
  } catch (const InProcessAbort&) {
  }
}

}  // namespace

void on_all_ranks(const std::function<void(Communicator&)>& body) {
  for (const int size : {1, 2, 3, 4, 12}) {
    SCOPED_TRACE(std::to_string(size) + " ranks");
    InProcessNetwork network(size);
    std::vector<std::jthread> threads;
    for (int rank = 0; rank < size; ++rank) {
      threads.emplace_back([&network, &body, rank] { run_one(*network.connect(rank), body); });
    }
  }
}

}  // namespace tessera::comm::test
