// Blocks the signals of a thread for a moment.
#pragma once

#include <pthread.h>

#include <csignal>

namespace tessera {

/// While it lives, its thread receives no signal; other threads of the process still do. Threads that start meanwhile block
/// signals for good.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsBlocked() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_;
};

}  // namespace tessera
