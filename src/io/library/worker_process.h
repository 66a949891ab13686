// One child process of the pool (artwork_pool.h), seen from its parent.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include "io/library/artwork_pool.h"

namespace tessera::io {

class WorkerProcess {
 public:
  using Clock = std::chrono::steady_clock;

  /// Forks; throws EnvironmentError. The child answers inputs with `work` until it is killed.
  WorkerProcess(const PoolWork& work, const PoolSettings& settings);
  ~WorkerProcess();  // kills
  WorkerProcess(WorkerProcess&& other) noexcept;
  WorkerProcess& operator=(WorkerProcess&& other) noexcept;

  bool busy() const { return input_.has_value(); }
  std::size_t input() const { return *input_; }
  Clock::time_point deadline() const { return deadline_; }
  int descriptor() const { return socket_; }

  void give(std::size_t index, const std::string& input, Clock::time_point deadline);
  enum class Answer { incomplete, complete, dead };
  /// Call when descriptor() is readable. The result is for input(); after `complete` the worker is idle again.
  Answer receive(PoolResult& result);
  /// Ends a process that does not answer, or collects a dead one; says how it ended.
  std::string end();

 private:
  pid_t pid_ = -1;
  int socket_ = -1;
  std::optional<std::size_t> input_;
  Clock::time_point deadline_;
  std::string received_;
};

}  // namespace tessera::io
