// The end of a benchmark's main(): its exit code, and the message of an error.
#pragma once

#include <cstdio>
#include <exception>

#include "core/base/error.h"

namespace tessera::bench {

/// Calls run(). Returns 0; after an InputError 2, after any other exception 1, with its message on stderr.
template <class Run>
int exit_code_of(const char* program, const Run& run) {
  try {
    run();
    return 0;
  } catch (const InputError& error) {
    std::fprintf(stderr, "%s: %s\n", program, error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", program, error.what());
    return 1;
  }
}

}  // namespace tessera::bench
