#include "core/base/task_pool.h"

#include <algorithm>
#include <system_error>

namespace tessera {

TaskPool::TaskPool(int breadth) : breadth_(std::max(1, breadth)) {}

TaskPool::~TaskPool() { end_threads(); }

void TaskPool::resize(int breadth) {
  end_threads();
  breadth_ = std::max(1, breadth);
}

void TaskPool::run(std::size_t count, const Task& task) {
  if (count < 2 || breadth_ == 1) {
    for (std::size_t i = 0; i < count; ++i) task(i);
    return;
  }
  std::unique_lock lock(mutex_);
  start_threads(std::min(count, std::size_t(breadth_)) - 1);
  Job job{.task = task, .count = count};
  jobs_.push_back(&job);
  for (std::size_t k = 1; k < std::min(count, threads_.size() + 1); ++k) changed_.notify_one();
  while (job.next < job.count) do_next(job, lock);
  wait_for(job, lock);
  std::erase(jobs_, &job);
  if (job.error) std::rethrow_exception(job.error);
}

/// Starts threads until there are `wanted`. If the system gives no more, the next run() tries again.
void TaskPool::start_threads(std::size_t wanted) {
  try {
    while (threads_.size() < wanted) threads_.emplace_back([this] { work(); });
  } catch (const std::system_error&) {
  }
}

void TaskPool::end_threads() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
  closed_ = false;
}

void TaskPool::work() {
  std::unique_lock lock(mutex_);
  while (!closed_) {
    if (Job* job = open_job_from(jobs_.begin())) {
      do_next(*job, lock);
    } else {
      wait_for_change(lock);
    }
  }
}

/// Waits for the job, and meanwhile works on jobs that were posted later: mostly small parts of this job's own tasks.
/// An older job's task may be a large one, which would delay this job's caller.
void TaskPool::wait_for(const Job& job, std::unique_lock<std::mutex>& lock) {
  while (job.ended < job.count) {
    if (Job* later = open_job_from(std::find(jobs_.begin(), jobs_.end(), &job))) {
      do_next(*later, lock);
    } else {
      wait_for_change(lock);
    }
  }
}

void TaskPool::wait_for_change(std::unique_lock<std::mutex>& lock) {
  ++idle_;
  changed_.wait(lock);
  --idle_;
}

bool TaskPool::has_idle_thread() const {
  const std::lock_guard lock(mutex_);
  return idle_ > 0;
}

TaskPool::Job* TaskPool::open_job_from(std::vector<Job*>::const_iterator first) const {
  const auto open = std::find_if(first, jobs_.end(), [](const Job* job) { return job->next < job->count; });
  return open == jobs_.end() ? nullptr : *open;
}

/// Runs the next task of the job. After the last of its tasks ended, the job is not touched again, as its caller may
/// have destroyed it.
void TaskPool::do_next(Job& job, std::unique_lock<std::mutex>& lock) {
  const std::size_t i = job.next++;
  lock.unlock();
  std::exception_ptr error;
  try {
    job.task(i);
  } catch (...) {
    error = std::current_exception();
  }
  lock.lock();
  if (error && !job.error) {
    job.error = error;
    job.count = job.next;
  }
  if (++job.ended == job.count) changed_.notify_all();
}

}  // namespace tessera
