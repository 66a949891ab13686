#include "comm/heartbeat.h"

#include <algorithm>
#include <chrono>

#include "comm/communicator.h"

namespace tessera::comm {
namespace {

constexpr double kBeatsPerSilence = 10;
constexpr double kMostPeriod_s = 5;  // however long the allowed silence, so that busy times stay up to date

}  // namespace

HeartbeatSender::HeartbeatSender(Communicator& ranks, double silence_s)
    : ranks_(ranks),
      thread_([this, period_s = std::min(silence_s / kBeatsPerSilence, kMostPeriod_s)](const std::stop_token& stop) {
        send_until_stopped(stop, period_s);
      }) {}

void HeartbeatSender::send_until_stopped(const std::stop_token& stop, double period_s) {
  std::uint64_t activity = 0;
  double for_s = 0;
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    for_s = ranks_.activity() == activity ? for_s + period_s : 0;
    activity = ranks_.activity();
    ranks_.send_heartbeat({Communicator::is_waiting(activity), for_s});
    stopped_.wait_for(lock, stop, std::chrono::duration<double>(period_s), [] { return false; });
  }
}

}  // namespace tessera::comm
