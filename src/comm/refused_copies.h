// Copies from the memory of one process to that of another, by which Open MPI passes large messages between ranks of a node.
#pragma once

namespace tessera::comm {

/// To be called before MPI and any thread begin. Where the kernel refuses such copies, as the filters of some containers
/// have it, Open MPI is told to do without: it looks at other limits than these, tries them all the same, and prints a
/// line for each message. What the user has set for it stays.
void do_without_refused_copies();

}  // namespace tessera::comm
