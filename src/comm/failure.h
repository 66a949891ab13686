// The reason why a rank cannot go on, as a message: rank 0 throws the exception of the worker again.
#pragma once

#include <string>

namespace tessera::comm {

inline constexpr int kEnvironmentExitCode = 1;
inline constexpr int kInputExitCode = 2;

struct Failure {
  int exit_code = kEnvironmentExitCode;
  std::string text;  // one line

  friend bool operator==(const Failure&, const Failure&) = default;
};

/// Describes the exception that is being handled; to be called in a catch block. InputError gets exit code 2. A refusal
/// of the system (memory, threads, a file without a name) is told in the system's words. Any other exception that is
/// not in core/base/error.h is marked as a bug.
Failure describe_current_exception();

/// Throws the InputError or EnvironmentError that the failure describes.
[[noreturn]] void throw_failure(const Failure& failure);

}  // namespace tessera::comm
