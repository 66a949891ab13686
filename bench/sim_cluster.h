// A cluster that SimGrid simulates: hosts around a switch, a rank each, and messages between a rank and who asks it.
#pragma once

#include <simgrid/s4u.hpp>

#include "protocol_sim.h"

namespace tessera::bench {

simgrid::s4u::Host* host_of(int rank);

/// Questions to the rank, and its answers.
simgrid::s4u::Mailbox* inbox(int rank);
simgrid::s4u::Mailbox* outbox(int rank);

/// The caller's time passes: it works, or its cores do.
void pass(double seconds);
void send(simgrid::s4u::Mailbox* mailbox, double bytes);

/// Plays `master`, on rank 0's host, to its end. Only once in a process: SimGrid's engine cannot be started again.
void simulate(int ranks, const Cluster& cluster, const std::function<void()>& master);

}  // namespace tessera::bench
