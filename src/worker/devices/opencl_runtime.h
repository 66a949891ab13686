// A thin layer over OpenCL's C++ binding: errors that name the failed call and the device, and buffers that know their
// length. It knows nothing about shapes.
#pragma once

#include <CL/opencl.hpp>
#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "worker/devices/device_memory.h"

namespace tessera::worker {

/// The error in one line, with the call's name, the code and the device.
EnvironmentError opencl_error(const cl::Error& error, const std::string& device);

/// Runs `calls` and turns an OpenCL error into an EnvironmentError.
template <class Calls>
auto checked(const std::string& device, Calls&& calls) {
  try {
    return calls();
  } catch (const cl::Error& error) {
    throw opencl_error(error, device);
  }
}

/// Called between the launches of a question while its answer is waited for, usually many times a second. Where it throws,
/// the wait ends and the session must not be used again.
using BetweenLaunches = std::function<void()>;

/// A device with a built program and its queue, which is in order: every command sees the results of the commands before
/// it.
class DeviceSession {
 public:
  /// Throws EnvironmentError with the build log where the source does not compile.
  DeviceSession(const cl::Device& device, const std::string& source, const std::string& build_options,
                BetweenLaunches between_launches = {});

  const std::string& name() const { return name_; }
  const cl::Context& context() const { return context_; }
  const cl::CommandQueue& queue() const { return queue_; }
  const cl::Program& program() const { return program_; }
  const cl::Device& device() const { return device_; }
  std::uint32_t compute_units() const { return compute_units_; }
  /// Hands the posted commands to the device, without waiting.
  void flush() const;
  /// Waits until all posted commands are done.
  void finish() const;
  /// Notes that `launch` was posted.
  void add_launch(cl::Event launch) const { launches_.push_back(std::move(launch)); }
  /// Waits until all posted launches are done.
  void wait_for_launches() const;
  /// Whether all posted launches are done, so that wait_for_launches() returns at once.
  bool launches_are_done() const;

 private:
  cl::Device device_;
  std::string name_;
  std::uint32_t compute_units_ = 0;
  cl::Context context_;
  cl::CommandQueue queue_;
  cl::Program program_;
  BetweenLaunches between_launches_;
  mutable std::deque<cl::Event> launches_;  // posted, not yet known to be done
};

/// A buffer on a device. `T` is a number or a struct of kernels/records.h.
template <class T>
class DeviceBuffer {
 public:
  explicit DeviceBuffer(const DeviceSession& session) : session_(&session) {}
  DeviceBuffer(const DeviceSession& session, const std::vector<T>& content) : session_(&session) { write(content); }

  /// Makes room for at least `count` elements; the content may be lost. A buffer that grows becomes at least half as large
  /// again.
  void reserve(std::size_t count) {
    if (count <= capacity_ && capacity_ > 0) return;
    capacity_ = std::max({count, capacity_ + capacity_ / 2, std::size_t(1)});  // OpenCL knows no empty buffers
    checked(session_->name(), [&] {
      buffer_ = cl::Buffer();  // the old one first: both together may not fit
      buffer_ = make_device_buffer(session_->context(), session_->device(), capacity_ * sizeof(T));
    });
  }

  /// Writes the first content.size() elements. Returns when `content` may change again.
  void write(const std::vector<T>& content) {
    reserve(content.size());
    write_at(0, content);
  }

  /// Writes elements from number `first` on; there must be room for them. Returns when `content` may change again.
  void write_at(std::size_t first, const std::vector<T>& content) {
    if (content.empty()) return;
    checked(session_->name(), [&] {
      session_->queue().enqueueWriteBuffer(buffer_, CL_TRUE, first * sizeof(T), content.size() * sizeof(T),
                                           content.data());
    });
  }

  /// Like write(), but without waiting: takes the content over and frees it when it is written.
  void post(std::vector<T> content) {
    reserve(content.size());
    post_at(0, std::move(content));
  }

  /// Like write_at(), but without waiting: takes the content over and frees it when it is written.
  void post_at(std::size_t first, std::vector<T> content) {
    if (content.empty()) return;
    auto given = std::make_unique<std::vector<T>>(std::move(content));
    checked(session_->name(), [&] {
      cl::Event written;
      session_->queue().enqueueWriteBuffer(buffer_, CL_FALSE, first * sizeof(T), given->size() * sizeof(T),
                                           given->data(), nullptr, &written);
      const auto free = [](cl_event, cl_int, void* done) { delete static_cast<std::vector<T>*>(done); };
      // if this throws, the memory is lost, but not freed too early
      written.setCallback(CL_COMPLETE, free, given.release());
    });
  }

  /// Posts the content of `places` places of equal length, from place number `first` on. The call with `first` 0 makes
  /// room for all `all_places` places.
  void post_part(std::vector<T> content, std::size_t first, std::size_t places, std::size_t all_places) {
    const std::size_t of_a_place = content.size() / places;
    if (first == 0) reserve(all_places * of_a_place);
    post_at(first * of_a_place, std::move(content));
  }

  /// Sets the first `count` elements to zero, without waiting.
  void clear(std::size_t count) {
    reserve(count);
    if (count == 0) return;
    checked(session_->name(),
            [&] { session_->queue().enqueueFillBuffer(buffer_, std::uint32_t(0), 0, count * sizeof(T)); });
  }

  /// Reads the first `count` elements, after all posted launches are done.
  std::vector<T> read(std::size_t count) const {
    session_->wait_for_launches();
    std::vector<T> content(count);
    if (count == 0) return content;
    checked(session_->name(),
            [&] { session_->queue().enqueueReadBuffer(buffer_, CL_TRUE, 0, count * sizeof(T), content.data()); });
    return content;
  }

  const cl::Buffer& get() const { return buffer_; }

 private:
  const DeviceSession* session_;
  cl::Buffer buffer_;
  std::size_t capacity_ = 0;
};

}  // namespace tessera::worker
