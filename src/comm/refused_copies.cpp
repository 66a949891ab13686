#include "comm/refused_copies.h"

#include <sys/uio.h>
#include <unistd.h>

#include <cstdlib>

namespace tessera::comm {
namespace {

/// Tries a copy from the process itself: a filter refuses it like any other.
bool may_copy() {
  char from = 1;
  char to = 0;
  const iovec source{&from, 1};
  const iovec target{&to, 1};
  return ::process_vm_readv(::getpid(), &target, 1, &source, 1, 0) == 1;
}

}  // namespace

void do_without_refused_copies() {
  constexpr int kKeepWhatIsSet = 0;
  if (!may_copy()) ::setenv("OMPI_MCA_btl_vader_single_copy_mechanism", "none", kKeepWhatIsSet);
}

}  // namespace tessera::comm
