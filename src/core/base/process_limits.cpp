#include "core/base/process_limits.h"

#include <sys/resource.h>

namespace tessera {
namespace {

std::string size_text(rlim_t bytes) {
  constexpr rlim_t kMebibyte = 1 << 20;
  return bytes < kMebibyte ? std::to_string(bytes >> 10) + " KiB" : std::to_string(bytes >> 20) + " MiB";
}

}  // namespace

std::string process_limits() {
  std::string text;
  const auto add = [&](auto resource, const std::string& before, const std::string& after) {
    rlimit limit{};
    if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
    text += (text.empty() ? "; limits of this process: " : ", ") + before + size_text(limit.rlim_cur) + after;
  };
  add(RLIMIT_FSIZE, "files of ", " (ulimit -f)");
  add(RLIMIT_AS, "", " of address space (ulimit -v)");
  add(RLIMIT_DATA, "", " of data (ulimit -d)");
  return text;
}

EnvironmentError no_thread(const std::system_error& error) {
  return EnvironmentError(std::string("cannot start a thread: ") + error.what() + process_limits());
}

}  // namespace tessera
