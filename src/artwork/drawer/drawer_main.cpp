// tessera-drawer: answers requests on descriptor kDrawerSocket, one after the other, until the socket closes. Only
// DrawerProcess starts it, with two arguments: the memory that it may use, in bytes, and the process id of its parent.
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <exception>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "artwork/drawer/drawing_service.h"
#include "artwork/protocol/drawer_protocol.h"
#include "artwork/sandbox/drawer_files.h"
#include "artwork/sandbox/drawer_landlock.h"
#include "artwork/sandbox/drawer_sandbox.h"

namespace tessera {
namespace {

/// Ends the process without clean-up: the kernel frees everything, and a failed decoder may have left any state.
[[noreturn]] void end_at_once() { ::_exit(kDrawerGaveUp); }

void read_all(void* data, std::size_t bytes) {
  char* to = static_cast<char*>(data);
  while (bytes > 0) {
    const ssize_t got = ::read(kDrawerSocket, to, bytes);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) end_at_once();
    to += got;
    bytes -= std::size_t(got);
  }
}

void write_all(const void* data, std::size_t bytes) {
  const char* from = static_cast<const char*>(data);
  while (bytes > 0) {
    const ssize_t sent = ::write(kDrawerSocket, from, bytes);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) end_at_once();
    from += sent;
    bytes -= std::size_t(sent);
  }
}

template <class Text>
Text read_bytes(std::size_t count) {
  Text text(count, {});
  read_all(text.data(), count);
  return text;
}

void answer_next_request() {
  RequestHeader header{};
  read_all(&header, sizeof header);
  DrawingRequest request{.kind = header.kind,
                         .longest_side_px = header.longest_side_px,
                         .width_pt = header.width_pt,
                         .px_per_inch = header.px_per_inch,
                         .tracing = {.pad = {.levels = header.pad_levels, .delta_tau = header.pad_delta_tau},
                                     .rules = {.edge_opacity = header.edge_opacity,
                                               .keep_rectangles = header.keep_rectangles != 0,
                                               .fill_holes = header.fill_holes != 0,
                                               .opaque = header.opaque != 0}}};
  request.path = read_bytes<std::string>(header.path_bytes);
  request.scope_id = read_bytes<std::string>(header.scope_id_bytes);
  request.warp = read_bytes<std::vector<std::uint8_t>>(header.warp_bytes);
  const auto bytes = read_bytes<std::vector<std::uint8_t>>(header.bytes);
  request.bytes = bytes;
  const DrawingAnswer answer = answer_or_reason(request);
  write_all(&answer.header, sizeof answer.header);
  write_all(answer.payload.data, answer.header.bytes);
}

/// Answers requests. A panic of librsvg unwinds the stack; noexcept ends it here.
[[noreturn]] void serve(const DrawerLayers& layers) noexcept {
  const DrawerGreeting greeting{this_build(), layers};
  write_all(kDrawerMark.data(), kDrawerMark.size());
  write_all(&greeting, sizeof greeting);
  while (true) answer_next_request();
}

}  // namespace
}  // namespace tessera

int main(int argc, char** argv) {
  using namespace tessera;
  std::set_terminate(end_at_once);
  if (argc != 3) end_at_once();
  cv::setNumThreads(1);  // several processes work at a time
  limit_process(std::strtoull(argv[1], nullptr, 10));
  if (::getppid() != std::atol(argv[2])) end_at_once();  // the parent had died before PR_SET_PDEATHSIG was set
  DrawerLayers layers;
  layers.files = confine_to_files(files_of_decoders());
  layers.system_calls = forbid_system_calls();
  serve(layers);
}
