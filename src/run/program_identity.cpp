#include "run/program_identity.h"

#include <span>
#include <string_view>

#include "core/base/digest.h"
#include "core/base/error.h"
#include "core/base/version.h"
#include "text/digest_text.h"
#include "text/utf8_text.h"
#include "worker/devices/kernel_options.h"

namespace tessera {
namespace {

std::string kernel_digest() {
  Digest digest;
  digest.add_all(std::span<const char>(std::string_view(worker::kernel_source)));
  return digest_text(digest.value());
}

}  // namespace

std::string program_identity() {
  return std::string("tessera ") + program_version() + ", commit " + program_commit() + ", kernels " + kernel_digest();
}

void announce_program(comm::Communicator& ranks, const std::string& program) {
  ranks.broadcast({program.begin(), program.end()});
}

void check_program(comm::Communicator& ranks, const std::string& program) {
  const comm::Bytes bytes = ranks.broadcast({});
  const std::string masters(bytes.begin(), bytes.end());
  if (program == masters) return;
  throw EnvironmentError("this rank runs " + program + ", the master " + printable_utf8(cut_utf8(masters, 200)) +
                         "; allowed: the same program on all ranks; install it anew on every node");
}

}  // namespace tessera
