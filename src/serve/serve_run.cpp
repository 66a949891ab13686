#include "serve/serve_run.h"

#include <pwd.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "comm/stop_signals.h"
#include "run/results/report_run.h"
#include "serve/address_output.h"
#include "serve/http_server.h"
#include "serve/request_guard.h"
#include "serve/service.h"
#include "serve/token.h"
#include "terminal/exit_codes.h"
#include "terminal/terminal.h"

namespace tessera {
namespace {

/// "user@host", as ssh wants it.
std::string login() {
  char host[256] = {};
  const passwd* user = ::getpwuid(::geteuid());
  return (user ? user->pw_name : "USER") + std::string("@") +
         (::gethostname(host, sizeof host - 1) == 0 ? host : "HOST");
}

void print_how_to(int port) {
  const std::string number = std::to_string(port);
  print_line("from another computer, first, there: ssh -N -L %s:127.0.0.1:%s %s", number.c_str(), number.c_str(),
             login().c_str());
  print_line("Ctrl-C ends it; all results stay on the disk");
  check_printed();
}

/// Returns once a signal has come and a refinement that ran then has saved its state.
void serve_until_signalled(serve::Service& service) {
  constexpr std::chrono::milliseconds kPause(50);
  bool asked = false, asked_again = false;
  while (!asked || service.refines()) {
    for (const std::string& line : service.news()) print_message(line);
    const bool stops = comm::stop_signalled(), stops_at_once = comm::stop_signalled_again();
    if ((stops && !asked) || (stops_at_once && !asked_again)) service.close();
    asked = stops;
    asked_again = stops_at_once;
    std::this_thread::sleep_for(kPause);
  }
  for (const std::string& line : service.news()) print_message(line);
}

}  // namespace

int run_serve(const ServeArguments& arguments) {
  serve::Service service(arguments.folder, tile_bytes(arguments.picture_mb > 0 ? arguments.picture_mb : kPicture_mb));
  const std::string token = serve::random_token();
  comm::install_stop_handlers();
  const serve::HttpServer server(
      arguments.port, [&](const serve::HttpRequest& request) { return serve::refusal(request, token); },
      [&](const serve::HttpRequest& request) {
        return service.answer(request, serve::path_below_token(request, token));
      });
  const serve::AddressOutput address(arguments.folder,
                                     "http://127.0.0.1:" + std::to_string(server.port()) + "/" + token + "/");
  print_how_to(server.port());
  serve_until_signalled(service);
  return kDoneExitCode;
}

}  // namespace tessera
