// Protects forked processes, which have none of their parent's computing threads.
#pragma once

namespace tessera::matching {

/// To be called before threads are used. Throws Error in a process that was forked after the first call: it would wait for
/// ever for threads that it does not have.
void check_threads_are_own();

}  // namespace tessera::matching
