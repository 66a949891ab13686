#include "comm/communicator.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <string>

#include "comm/encode.h"
#include "comm/idle_wait.h"
#include "comm/messages.h"
#include "core/base/error.h"
#include "core/base/stop.h"
#include "core/base/stopwatch.h"

namespace tessera::comm {
namespace {

SharedBytes shared(Bytes bytes) { return std::make_shared<const Bytes>(std::move(bytes)); }

/// Decodes a message of a job's end; empty where it cannot be read. Such messages come from any rank, even from one
/// whose program is a different one; that is no reason not to end.
template <class T>
std::optional<T> readable(const Bytes& bytes) {
  try {
    return decode<T>(bytes);
  } catch (const EnvironmentError&) {
    return std::nullopt;
  }
}

Failure unreadable_failure(const std::string& place) {
  return {kEnvironmentExitCode,
          place +
              " failed, and its message cannot be read; allowed: the same program on all ranks; install it anew on "
              "every node"};
}

}  // namespace

int Communicator::local_rank() const {
  const std::vector<int>& ranks = node_ranks();
  return int(std::find(ranks.begin(), ranks.end(), rank()) - ranks.begin());
}

void Communicator::post(int to, Tag tag, SharedBytes bytes) {
  traffic_.sent_by_tag[std::size_t(tag)].add(bytes->size());
  start_send(to, tag, std::move(bytes));
}

void Communicator::take_in_arrivals() {
  while (std::optional<Message> message = poll()) {
    traffic_.received_by_tag[std::size_t(message->tag)].add(message->bytes.size());
    switch (message->tag) {
      case Tag::failure:
        if (failure_) break;
        failure_ = readable<Failure>(message->bytes).value_or(unreadable_failure(place_of(message->from)));
        break;
      case Tag::end: end_ = readable<Ending>(message->bytes).value_or(Ending::orderly); break;
      case Tag::heartbeat:
        if (!watch_) break;
        if (const auto beat = readable<Heartbeat>(message->bytes)) watch_->heard(message->from, *beat);
        break;
      case Tag::bye: ++byes_; break;
      case Tag::leave: may_leave_ = true; break;
      default: inbox_.push_back(std::move(*message));
    }
  }
}

void Communicator::throw_if_over() const {
  if (end_) throw JobEnded{};
  if (failure_) throw_failure(*failure_);
}

void Communicator::check_arrivals() {
  take_in_arrivals();
  throw_if_over();
}

void Communicator::watch_workers(double silence_s, std::function<void(const std::string& line)> report) {
  if (size() > 1) watch_.emplace(size(), silence_s);
  report_lost_ = std::move(report);
}

void Communicator::throw_if_interrupted() {
  const std::optional<StopReason> reason = shall_stop_ ? shall_stop_() : std::nullopt;
  // A rank that was reported as lost stays lost, even if it sends again later.
  if (const auto lost = watch_ && !lost_a_worker_ ? watch_->lost() : std::nullopt) {
    lost_a_worker_ = true;
    report_lost_(lost->rank > 0 ? place_of(lost->rank) + " " + lost->what : lost->what);
  }
  wait_was_interrupted_ |= reason || lost_a_worker_;
  if (reason) throw Interrupted{*reason};
  if (lost_a_worker_) throw Interrupted{StopReason::lost_rank};
}

template <class Done>
void Communicator::wait_until(Done done) {
  struct Activity {
    std::atomic<std::uint64_t>& count;
    explicit Activity(std::atomic<std::uint64_t>& activity) : count(activity) { ++count; }
    ~Activity() { ++count; }
  } const activity(activity_);
  IdleWait wait;
  Stopwatch since_look;
  if (watch_) watch_->begin_wait();
  for (check_arrivals(); !done(); check_arrivals()) {
    if (watch_) watch_->waited(since_look.lap());
    throw_if_interrupted();
    wait.pause();
  }
}

void Communicator::send_heartbeat(const Heartbeat& beat) { start_send(0, Tag::heartbeat, shared(encode(beat))); }

void Communicator::send_shared(int to, Tag tag, SharedBytes bytes) {
  post(to, tag, std::move(bytes));
  wait_until([this] { return under_way() <= kMostUnderWay; });
}

void Communicator::send(int to, Tag tag, Bytes bytes) { send_shared(to, tag, shared(std::move(bytes))); }

void Communicator::send(const std::vector<int>& to, Tag tag, Bytes bytes) {
  const SharedBytes content = shared(std::move(bytes));
  for (const int rank : to) send_shared(rank, tag, content);
}

Message Communicator::receive_any(int from, std::initializer_list<Tag> tags) {
  const auto wanted = [&](const Message& m) {
    return m.from == from && std::find(tags.begin(), tags.end(), m.tag) != tags.end();
  };
  auto found = inbox_.end();
  const Stopwatch watch;
  const double processor_before_s = thread_processor_time_s();
  wait_until([&] {
    found = std::find_if(inbox_.begin(), inbox_.end(), wanted);
    return found != inbox_.end();
  });
  waited_s_ += watch.seconds();
  waited_processor_s_ += thread_processor_time_s() - processor_before_s;
  Message message = std::move(*found);
  inbox_.erase(found);
  return message;
}

Bytes Communicator::receive(int from, Tag tag) { return receive_any(from, {tag}).bytes; }

void Communicator::flush() {
  wait_until([this] { return under_way() == 0; });
}

Bytes Communicator::broadcast(Bytes bytes) {
  if (rank() != 0) return receive(0, Tag::broadcast);
  std::vector<int> others(std::size_t(size()) - 1);
  std::iota(others.begin(), others.end(), 1);
  send(others, Tag::broadcast, bytes);
  return bytes;
}

void Communicator::barrier() {
  if (rank() != 0) {
    send(0, Tag::barrier, {});
    receive(0, Tag::barrier);
    return;
  }
  for (int from = 1; from < size(); ++from) receive(from, Tag::barrier);
  for (int to = 1; to < size(); ++to) send(to, Tag::barrier, {});
}

void Communicator::report_failure(const Failure& failure) { post(0, Tag::failure, shared(encode(failure))); }

void Communicator::tell_end(Ending ending) {
  for (int to = 1; to < size(); ++to) post(to, Tag::end, shared(encode(ending)));
}

template <class Done>
bool Communicator::wait_patiently(Done done, double patience_s) {
  IdleWait wait;
  for (take_in_arrivals(); !done(); take_in_arrivals()) {
    if (wait.waited_s() > patience_s) return false;
    wait.pause();
  }
  return true;
}

bool Communicator::wait_for_goodbyes(double patience_s) {
  if (!wait_patiently([this] { return byes_ == size() - 1 && under_way() == 0; }, patience_s)) return false;
  for (int to = 1; to < size(); ++to) post(to, Tag::leave, shared({}));
  return wait_until_sent(patience_s);
}

bool Communicator::wait_until_sent(double patience_s) {
  return wait_patiently([this] { return under_way() == 0; }, patience_s);
}

Ending Communicator::wait_for_end() {
  constexpr double kForEver = std::numeric_limits<double>::infinity();
  wait_patiently([this] { return end_.has_value(); }, kForEver);
  if (*end_ == Ending::orderly) {
    wait_until_sent(kForEver);
    post(0, Tag::bye, shared({}));
    wait_patiently([this] { return may_leave_ && under_way() == 0; }, kForEver);
  }
  return *end_;
}

}  // namespace tessera::comm
