// A tessera refine that runs as a process of its own.
#pragma once

#include <sys/types.h>

#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "files/file_descriptor.h"

namespace tessera::serve {

class Refinement {
 public:
  /// Starts `tessera refine ARGUMENTS`; `program` is the path of tessera. Throws EnvironmentError.
  Refinement(const std::string& program, const std::vector<std::string>& arguments);
  /// Stops it and waits for its end.
  ~Refinement();
  Refinement(const Refinement&) = delete;
  Refinement& operator=(const Refinement&) = delete;

  struct State {
    bool runs = true;
    int exit_code = 0;      // once it no longer runs; of a process that a signal ended: 128 and the signal's number
    std::string last_line;  // what it printed last on stderr, without "tessera: "
  };
  State state() const;

  /// Asks it to end with a checkpoint. A second call asks it to end at once.
  void stop();

 private:
  void read_to_the_end();

  FileDescriptor output_{-1};
  pid_t pid_ = -1;
  mutable std::mutex mutex_;
  State state_;
  std::thread reader_;
};

}  // namespace tessera::serve
