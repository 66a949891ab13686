// A forked process has none of the threads that its parent computes with.
#pragma once

namespace tessera::matching {

/// To be called before threads are used. Throws Error in a process that was forked after the first call: waiting for
/// threads that are not there would never end.
void check_threads_are_own();

}  // namespace tessera::matching
