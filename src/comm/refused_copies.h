// Copies between the memories of two processes: Open MPI passes large messages between ranks of one node this way.
#pragma once

namespace tessera::comm {

/// Tells Open MPI not to use such copies where the kernel refuses them, as filters of some containers do. Open MPI does
/// not notice these filters, tries the copies anyway, and prints a line for each message. Settings of the user stay. To
/// be called before MPI and any thread start.
void do_without_refused_copies();

}  // namespace tessera::comm
