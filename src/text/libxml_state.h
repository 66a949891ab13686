// The global state of libxml2, shared by all its uses in a process.
#pragma once

namespace tessera {

/// Makes libxml2's global state; call it before a thread first uses libxml2. Later calls do nothing. Otherwise libxml2
/// makes its locks at first use, without holding one: two threads may then make two locks, and one waits for ever (16
/// cores, one run in six).
void make_libxml_state();

}  // namespace tessera
