// Why a rank cannot go on, in a form that travels: the exception on the worker becomes one on rank 0.
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

/// To be called in a catch block. InputError has exit code 2. What the system refused (memory, threads, a file that
/// nobody named) is told in its words; whatever else is not of core/base/error.h is marked as a bug.
Failure describe_current_exception();

/// Throws the InputError or EnvironmentError that tells of it.
[[noreturn]] void throw_failure(const Failure& failure);

}  // namespace tessera::comm
