// The ranks of a job and the messages between them: the one interface to the transport. MPI implements it, and, within
// one process, threads. All members belong to one thread of the rank, except those for heartbeats (heartbeat.h).
//
// Sending never waits for the receiver, and every wait takes in all messages that arrive, so that large messages cannot
// block two ranks in any order. A rank that cannot go on tells rank 0, whose next wait throws. Rank 0 ends the job by
// telling all ranks, whose next wait throws JobEnded (rank_program.h does both). A wait of rank 0 also ends, with
// core's Interrupted, when the job shall stop or a worker is lost.
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

/// Thrown by the waits of every rank except 0 when rank 0 has ended the job. It is not an error, so it is no
/// std::exception; do not catch it.
struct JobEnded {};

/// The way in which the ranks leave the job.
enum class Ending : std::uint8_t {
  orderly,  // all ranks wait for each other, then finalise MPI
  at_once,  // the launcher is killing the job and answers no MPI calls any more
};

class Communicator {
 public:
  virtual ~Communicator() = default;
  Communicator() = default;
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;

  virtual int rank() const = 0;
  virtual int size() const = 0;
  /// The ranks on this rank's node, ascending, itself included.
  virtual const std::vector<int>& node_ranks() const = 0;
  int local_rank() const;  // position in node_ranks()
  int local_size() const { return int(node_ranks().size()); }
  /// The name of this rank in messages for people: "rank 2 on node7".
  std::string place() const { return place_of(rank()); }
  virtual std::string place_of(int rank) const = 0;
  /// Ends all ranks at once, whatever they do.
  [[noreturn]] virtual void abort(int exit_code) = 0;

  /// Sends a message. Waits for nobody, unless more than kMostUnderWay bytes have not left yet. Messages of one tag
  /// from one rank to another arrive in order. A message has at most 2^31 - 1 bytes.
  void send(int to, Tag tag, Bytes bytes);
  /// Sends the same bytes to several ranks.
  void send(const std::vector<int>& to, Tag tag, Bytes bytes);
  /// Waits for the next message with this tag from rank `from`.
  Bytes receive(int from, Tag tag);
  /// Waits for the next message with any of the tags from rank `from`, in the order in which they were sent.
  Message receive_any(int from, std::initializer_list<Tag> tags);
  /// Waits until all messages have left.
  void flush();

  /// Returns the bytes of rank 0 on every rank.
  Bytes broadcast(Bytes bytes);
  /// Waits until every rank has called it.
  void barrier();

  /// Takes in what has arrived and throws as a wait does. To be called now and then during long computations.
  void check_arrivals();

  /// Makes every later wait throw Interrupted as soon as `shall_stop` returns a reason. The awaited replies may still
  /// arrive; the only thing left to do is to end the job.
  void interrupt_waits_when(StopQuestion shall_stop) { shall_stop_ = std::move(shall_stop); }
  /// Watches the workers; for rank 0, whose workers all have a HeartbeatSender with the same `silence_s`. From now on a wait that
  /// finds a worker lost (rank_watch.h) calls `report` with a line that names it and throws Interrupted. Every later
  /// wait throws as well, without another report.
  void watch_workers(double silence_s, std::function<void(const std::string& line)> report);
  /// Whether a wait of this rank was interrupted, so that a worker may still compute an answer, or end_soon() was called.
  bool wait_was_interrupted() const { return wait_was_interrupted_; }
  bool lost_a_worker() const { return lost_a_worker_; }
  /// Makes rank 0 end the job as fast as after an interrupted wait.
  void end_soon() { wait_was_interrupted_ = true; }

  const Traffic& traffic() const { return traffic_; }
  /// Time since the start that this rank spent in receive() until the messages came, and the processor time that the
  /// waiting took.
  double waited_s() const { return waited_s_; }
  double waited_processor_s() const { return waited_processor_s_; }

  // The rest of this part is for the thread of heartbeat.h.

  /// Sends a heartbeat to rank 0. The transport must allow sending from two threads.
  void send_heartbeat(const Heartbeat& beat);
  /// A counter that rises whenever the rank begins or ends a wait for a message: odd while it waits.
  std::uint64_t activity() const { return activity_.load(std::memory_order_relaxed); }
  static bool is_waiting(std::uint64_t activity) { return activity % 2 == 1; }

  // The end of a job; only rank_program.h calls these functions.

  /// Tells rank 0 that this rank cannot go on.
  void report_failure(const Failure& failure);
  /// Tells all other ranks to leave; for rank 0.
  void tell_end(Ending ending);
  /// Waits until all other ranks have said goodbye, then lets them leave; for rank 0. False where some did not within
  /// `patience_s`.
  bool wait_for_goodbyes(double patience_s);
  /// Waits until all messages have left. False where that took longer than `patience_s`.
  bool wait_until_sent(double patience_s);
  /// Waits for tell_end; for all ranks except 0. Unless that says `at_once`, it says goodbye and waits for permission
  /// to leave: until all ranks have said goodbye, a large message of another rank may need this rank's poll() to
  /// arrive.
  Ending wait_for_end();

  static constexpr std::size_t kMostUnderWay = std::size_t(128) << 20;

 protected:
  // The rank's own thread calls start_send and poll; the thread of its heartbeats calls start_send, too.

  /// Starts to send and keeps the bytes until they have left. Progress needs a poll() now and then.
  virtual void start_send(int to, Tag tag, SharedBytes bytes) = 0;
  /// A message that has arrived, if there is one. Also moves pending transfers on.
  virtual std::optional<Message> poll() = 0;
  /// Bytes of messages that have not left yet; 0 only if there are no such messages.
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
  std::optional<Failure> failure_;  // rank 0: the first one reported
  std::optional<Ending> end_;       // other ranks: as rank 0 told it
  int byes_ = 0;
  bool may_leave_ = false;
  StopQuestion shall_stop_;
  std::optional<RankWatch> watch_;  // on rank 0 with workers
  std::function<void(const std::string& line)> report_lost_;
  bool wait_was_interrupted_ = false;
  bool lost_a_worker_ = false;
  std::atomic<std::uint64_t> activity_{0};
  Traffic traffic_;
  double waited_s_ = 0;
  double waited_processor_s_ = 0;
};

/// Processor time of this process since its start, without the time that waiting for messages took.
inline double busy_processor_s(const Communicator& ranks) { return processor_time_s() - ranks.waited_processor_s(); }

}  // namespace tessera::comm
