#include "core/replacing/shared_tasks.h"

#include <algorithm>

namespace tessera {

void SharedTasks::run(std::size_t count, const Task& task) {
  std::unique_lock lock(mutex_);
  Job job{.task = &task, .count = count};
  if (helpers_ > 0) {
    jobs_.push_back(&job);
    changed_.notify_all();
  }
  work_on(job, lock);
  changed_.wait(lock, [&] { return job.ended == job.count; });
  std::erase(jobs_, &job);
  if (job.error) std::rethrow_exception(job.error);
}

bool SharedTasks::has_helpers() const {
  const std::lock_guard lock(mutex_);
  return helpers_ > 0;
}

void SharedTasks::help() {
  std::unique_lock lock(mutex_);
  ++helpers_;
  while (!closed_) {
    if (Job* job = open_job()) {
      work_on(*job, lock);
    } else {
      changed_.wait(lock);
    }
  }
  --helpers_;
}

void SharedTasks::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

SharedTasks::Job* SharedTasks::open_job() const {
  const auto open = std::find_if(jobs_.begin(), jobs_.end(), [](const Job* job) { return job->next < job->count; });
  return open == jobs_.end() ? nullptr : *open;
}

/// Until none of its tasks is left to begin. A job ends no sooner than the last of its tasks: nobody looks at it
/// afterwards.
void SharedTasks::work_on(Job& job, std::unique_lock<std::mutex>& lock) {
  while (job.next < job.count) {
    const std::size_t i = job.next++;
    lock.unlock();
    std::exception_ptr error;
    try {
      (*job.task)(i);
    } catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    if (error && !job.error) job.error = error;
    if (++job.ended == job.count) changed_.notify_all();
  }
}

}  // namespace tessera
