// A thread pool: its threads and the calling thread share the tasks.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace tessera {

class TaskPool {
 public:
  using Task = std::function<void(std::size_t)>;

  /// A pool for `breadth` cores, at least 1: this number of threads compute at a time, including the one that calls
  /// run(). The other threads start when they are first needed. If the system gives fewer threads, fewer share the
  /// tasks.
  explicit TaskPool(int breadth);
  /// No task may be running.
  ~TaskPool();
  TaskPool(const TaskPool&) = delete;
  TaskPool& operator=(const TaskPool&) = delete;

  int breadth() const { return breadth_; }
  /// Whether a thread would take a task at once: then it is better to divide work into small tasks.
  bool has_idle_thread() const;
  /// Ends all threads; from now on the pool is for `breadth` cores. No task may be running.
  void resize(int breadth);

  /// Calls task(0) to task(count - 1), each once and in any order, on this thread, which takes the first one, and on
  /// the pool's threads. Returns when all have ended. After an exception no further task begins, and the first
  /// exception is thrown again here. A task may itself call run(). Any thread may call this.
  void run(std::size_t count, const Task& task);

 private:
  struct Job {
    const Task& task;
    std::size_t count;  // smaller after an exception
    std::size_t next = 0;
    std::size_t ended = 0;
    std::exception_ptr error = nullptr;
  };

  void start_threads(std::size_t wanted);
  void end_threads();
  void work();
  void wait_for(const Job& job, std::unique_lock<std::mutex>& lock);
  void wait_for_change(std::unique_lock<std::mutex>& lock);
  Job* open_job_from(std::vector<Job*>::const_iterator first) const;
  void do_next(Job& job, std::unique_lock<std::mutex>& lock);

  int breadth_;
  mutable std::mutex mutex_;  // protects all members below
  std::condition_variable changed_;
  std::vector<Job*> jobs_;  // jobs whose callers wait in run(), the oldest first
  std::size_t idle_ = 0;
  bool closed_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace tessera
