// The state that all uses of libxml2 in a process share.
#pragma once

namespace tessera {

/// Makes libxml2's global state before a thread first uses libxml2; later calls do nothing. Without it libxml2 makes its
/// locks at first use without holding one: threads that were its first users together made two, and one thread then waited
/// for ever (16 cores, one run in six).
void make_libxml_state();

}  // namespace tessera
