#include "serve/serve_run.h"

#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <mutex>
#include <thread>

#include "comm/stop_signals.h"
#include "core/base/error.h"
#include "run/results/report_run.h"
#include "serve/http_server.h"
#include "serve/request_guard.h"
#include "serve/service.h"
#include "serve/token.h"
#include "terminal/exit_codes.h"
#include "terminal/terminal.h"

namespace tessera {
namespace {

/// Throws InputError where stdout is a file that other users of the machine may read, as that of a Slurm job often is: the
/// address is a password.
void check_output_is_private() {
  struct stat status = {};
  if (::fstat(STDOUT_FILENO, &status) != 0 || !S_ISREG(status.st_mode) || (status.st_mode & (S_IRGRP | S_IROTH)) == 0) {
    return;
  }
  throw InputError(
      "stdout: found a file that other users may read, and the address of the page is a password; allowed: a terminal, "
      "or a file of your own (umask 077; tessera serve ... >FILE)");
}

std::string host_name() {
  char name[256] = {};
  return ::gethostname(name, sizeof name - 1) == 0 ? name : "HOST";
}

void print_address(int port, const std::string& token) {
  const std::string number = std::to_string(port);
  print_line("open in a browser on this machine:");
  print_line("  http://127.0.0.1:%s/%s/", number.c_str(), token.c_str());
  print_line("from another computer, first: ssh -N -L %s:127.0.0.1:%s %s", number.c_str(), number.c_str(),
             host_name().c_str());
  print_line("Ctrl-C ends it; all results stay on the disk");
  print_now();
}

/// Until the user ends the server and a refinement that runs has saved its state.
void wait_for_end(serve::Service& service) {
  constexpr std::chrono::milliseconds kPause(50);
  bool asked = false, asked_again = false;
  while (!asked || service.refines()) {
    service.look_after_refinement();
    const bool stops = comm::stop_signalled(), stops_at_once = comm::stop_signalled_again();
    if ((stops && !asked) || (stops_at_once && !asked_again)) service.close();
    asked = stops;
    asked_again = stops_at_once;
    std::this_thread::sleep_for(kPause);
  }
}

}  // namespace

int run_serve(const ServeArguments& arguments) {
  check_output_is_private();
  std::mutex printing;
  const auto tell = [&](const std::string& line) {
    const std::lock_guard lock(printing);
    print_message(line);
  };
  serve::Service service(arguments.folder, tile_bytes(arguments.picture_mb > 0 ? arguments.picture_mb : kPicture_mb),
                         tell);
  const std::string token = serve::random_token();
  comm::install_stop_handlers();
  const serve::HttpServer server(
      arguments.port, [&](const serve::HttpRequest& request) { return serve::refusal(request, token); },
      [&](const serve::HttpRequest& request) {
        return service.answer(request, serve::path_below_token(request, token));
      });
  print_address(server.port(), token);
  wait_for_end(service);
  return kDoneExitCode;
}

}  // namespace tessera
