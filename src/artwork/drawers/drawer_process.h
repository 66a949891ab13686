// One drawer process (drawers.h), seen from its parent.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "artwork/protocol/drawer_protocol.h"

namespace tessera {

class DrawerProcess {
 public:
  /// `program`: DrawerSettings::program.
  DrawerProcess(std::size_t bytes_per_process, double seconds_to_start, std::string program)
      : bytes_per_process_(bytes_per_process),
        seconds_to_start_(seconds_to_start),
        program_(std::move(program)) {}
  ~DrawerProcess() { end(); }
  DrawerProcess(const DrawerProcess&) = delete;
  DrawerProcess& operator=(const DrawerProcess&) = delete;

  bool started() const { return socket_ >= 0; }
  /// Starts the process and returns which layers of its sandbox hold. Throws EnvironmentError. The process dies at the
  /// latest with the thread that calls this.
  DrawerLayers start();
  /// The answer of a started process. Nullopt where there is none: the process was ended, and failure() says why.
  std::optional<DrawingAnswer> ask(const DrawingRequest& request, double seconds);
  const std::string& failure() const { return failure_; }
  bool took_too_long() const { return took_too_long_; }
  /// Ends the process, if it is started, and waits for it.
  void end();
  /// Ends the process from another thread, so that its ask() fails soon.
  void kill();

 private:
  DrawerLayers greet(const std::string& program);
  std::string refusal(DrawerGreeting& greeting);
  void allow_cpu_time(double seconds);
  bool send(const void* data, std::size_t bytes, double& left_s);
  bool receive(void* data, std::size_t bytes, double& left_s);
  bool wait_for(short events, double& left_s);
  bool exchange(const DrawingRequest& request, DrawingAnswer& answer, double& left_s);

  std::size_t bytes_per_process_;
  double seconds_to_start_;
  std::string program_;
  std::mutex mutex_;  // guards pid_: a process that was waited for must not be killed
  pid_t pid_ = -1;
  int socket_ = -1;
  int status_ = 0;  // status of the last ended process, from waitpid
  bool took_too_long_ = false;
  std::string failure_;
};

}  // namespace tessera
