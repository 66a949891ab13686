// The ranks of a job and how they talk: the one interface to the transport, implemented by MPI and, within one process,
// by threads. Everything here belongs to one thread of the rank, but for its heartbeats (heartbeat.h).
//
// Sending never waits for the receiver, and whoever waits takes in whatever arrives, so that no order of large messages
// can lock two ranks up. A rank that cannot go on tells rank 0, whose next wait throws; rank 0 ends the job by telling
// all, whose next wait throws JobEnded (rank_program.h does both). A wait of rank 0 also ends, by core's Interrupted,
// when the job is to stop or a worker is lost.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "comm/failure.h"
#include "comm/message.h"
#include "comm/rank_watch.h"
#include "comm/traffic.h"
#include "core/base/processor_time.h"
#include "core/base/stop.h"

namespace tessera::comm {

/// Thrown by the waits of every rank but 0 when rank 0 ended the job. Not an error, hence no std::exception: let it
/// pass.
struct JobEnded {};

/// How the ranks leave.
enum class Ending : std::uint8_t {
  orderly,  // everyone waits for everyone, then MPI says its own farewell
  at_once,  // the launcher is killing the job and answers nobody any more
};

class Communicator {
 public:
  virtual ~Communicator() = default;
  Communicator() = default;
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;

  virtual int rank() const = 0;
  virtual int size() const = 0;
  /// The ranks that share this rank's node, ascending, itself included.
  virtual const std::vector<int>& node_ranks() const = 0;
  int local_rank() const;  // position in node_ranks()
  int local_size() const { return int(node_ranks().size()); }
  /// The rank as messages to people name it: "rank 2 on node7".
  std::string place() const { return place_of(rank()); }
  virtual std::string place_of(int rank) const = 0;
  /// Ends all ranks at once, without regard to what they do.
  [[noreturn]] virtual void abort(int exit_code) = 0;

  /// Returns without waiting for the receiver, unless kMostUnderWay bytes are already under way. Messages of one tag
  /// from one rank to another arrive in order. At most 2^31 - 1 bytes.
  void send(int to, Tag tag, Bytes bytes);
  /// Sends the same bytes to several ranks.
  void send(const std::vector<int>& to, Tag tag, Bytes bytes);
  /// The next message of that tag from rank `from`.
  Bytes receive(int from, Tag tag);
  /// The next message of any of the tags from rank `from`, in the order in which they were sent.
  Message receive_any(int from, std::initializer_list<Tag> tags);
  /// Waits until all that was sent has left.
  void flush();

  /// Gives rank 0's bytes on every rank.
  Bytes broadcast(Bytes bytes);
  /// Returns when every rank has come here.
  void barrier();

  /// Takes in what has arrived and throws as a wait does: for whoever computes for long.
  void look();

  /// From now on a wait for which `shall_stop` gives a reason throws Interrupted with it. The replies that
  /// were waited for may still come; the only thing left to do is to end the job.
  void interrupt_waits_when(StopQuestion shall_stop) { shall_stop_ = std::move(shall_stop); }
  /// Rank 0, whose workers all have a Heart with the same `silence_s`: from now on a wait that finds one of them lost
  /// (rank_watch.h) calls `report` with a line that names it and throws Interrupted. So does every later wait, without
  /// another report.
  void watch_workers(double silence_s, std::function<void(const std::string& line)> report);
  /// A wait of this rank was interrupted: somebody may still be at work on what it asked for; or there is no time left
  /// (hurry).
  bool gave_up_waiting() const { return gave_up_waiting_; }
  bool lost_a_worker() const { return lost_a_worker_; }
  /// Rank 0: the job is to end as soon as if a wait had been interrupted.
  void hurry() { gave_up_waiting_ = true; }

  const Traffic& traffic() const { return traffic_; }
  /// The time spent in receive since the start, until the messages came, and the processor time that looking for them
  /// took.
  double waited_s() const { return waited_s_; }
  double waited_processor_s() const { return waited_processor_s_; }

  // For the thread of heartbeat.h.

  /// Sends a heartbeat to rank 0. It needs a transport that sends from two threads.
  void send_heartbeat(const Heartbeat& beat);
  /// A number that changes whenever the rank begins to wait for a message, and when it goes on.
  std::uint64_t activity() const { return activity_.load(std::memory_order_relaxed); }
  static bool is_waiting(std::uint64_t activity) { return activity % 2 == 1; }

  // How a job ends; see rank_program.h, which alone calls these.

  /// Tells rank 0 that this rank cannot go on.
  void report_failure(const Failure& failure);
  /// Rank 0: tells all others to leave.
  void tell_end(Ending ending);
  /// Rank 0: waits until all others said goodbye, then lets them go. False where some did not within `patience_s`.
  bool see_off(double patience_s);
  /// Waits until all that was sent has left. False where it did not within `patience_s`.
  bool wait_until_sent(double patience_s);
  /// Another rank: waits for tell_end and, unless that is `at_once`, says goodbye and waits to be let go: until all
  /// have said it, a large message of theirs may need this rank's help to arrive.
  Ending wait_for_end();

  static constexpr std::size_t kMostUnderWay = std::size_t(128) << 20;

 protected:
  // start_send and poll are called by the rank's thread and start_send by that of its heartbeats, too.

  /// Keeps the bytes until they have left; they arrive as long as poll() is called now and then.
  virtual void start_send(int to, Tag tag, SharedBytes bytes) = 0;
  /// A message that has arrived, if there is one; helps along what is under way.
  virtual std::optional<Message> poll() = 0;
  /// Bytes of messages that have not left yet; zero only if there are none.
  virtual std::size_t under_way() const = 0;

 private:
  void post(int to, Tag tag, SharedBytes bytes);
  void send_shared(int to, Tag tag, SharedBytes bytes);
  void take_in_arrivals();
  void throw_if_over() const;
  void throw_if_interrupted();
  template <class Done>
  void wait_until(Done done);
  template <class Done>
  bool wait_patiently(Done done, double patience_s);

  std::deque<Message> inbox_;
  std::optional<Failure> failure_;  // rank 0: the first that was reported
  std::optional<Ending> end_;       // others: as told by rank 0
  int byes_ = 0;
  bool may_leave_ = false;
  StopQuestion shall_stop_;
  std::optional<RankWatch> watch_;  // rank 0, with workers
  std::function<void(const std::string& line)> report_lost_;
  bool gave_up_waiting_ = false;
  bool lost_a_worker_ = false;
  std::atomic<std::uint64_t> activity_{0};
  Traffic traffic_;
  double waited_s_ = 0;
  double waited_processor_s_ = 0;
};

/// The processor time of this process since its start, without what waiting for messages took.
inline double busy_processor_s(const Communicator& ranks) { return processor_time_s() - ranks.waited_processor_s(); }

}  // namespace tessera::comm
