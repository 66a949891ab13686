// Tasks that threads do together: who has some does them, and who has nothing else to do helps.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <vector>

namespace tessera {

class SharedTasks {
 public:
  using Task = std::function<void(std::size_t)>;

  /// Calls task(0) to task(count - 1), each once, on this thread and those that help; returns when all have ended.
  /// Throws what a task threw; the others are done all the same. A task may share out others.
  void run(std::size_t count, const Task& task);

  /// Whether tasks are better divided finely.
  bool has_helpers() const;

  /// Helps whoever shares out tasks, until close().
  void help();
  void close();

 private:
  struct Job {
    const Task* task;
    std::size_t count;
    std::size_t next = 0;
    std::size_t ended = 0;
    std::exception_ptr error = nullptr;
  };

  Job* open_job() const;
  void work_on(Job& job, std::unique_lock<std::mutex>& lock);

  mutable std::mutex mutex_;  // of all that follows
  std::condition_variable changed_;
  std::vector<Job*> jobs_;  // of those who wait in run()
  std::size_t helpers_ = 0;
  bool closed_ = false;
};

}  // namespace tessera
