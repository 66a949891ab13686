#include <memory>

#include "cli/commands.h"
#include "run/results/report_run.h"
#include "serve/serve_run.h"

namespace tessera::cli {
namespace {

constexpr const char* kServeExamples =
    "Examples:\n"
    "  tessera serve out/animals                 prints an address; open it in a browser on this machine\n"
    "  tessera serve out/animals --port 8123     at a fixed port, for a tunnel: ssh -N -L 8123:127.0.0.1:8123 HOST\n"
    "The page is that of tessera report. Marked pieces are refilled by a button; the new result appears on the page\n"
    "beside the old one, and stands on the disk as out/animals-2, -3 and so on, each with its marks.json. RESULT "
    "itself "
    "is\n"
    "not changed. Ctrl-C ends it; a refinement at work saves its state first. tessera serve RESULT shows all of them "
    "again.\n"
    "The address is a password: only who has it can see the page. Other computers cannot connect.";

}  // namespace

void add_serve_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<ServeArguments>();
  CLI::App* serve = app.add_subcommand("serve", "Look at a result in a browser, and refine it there");
  serve->footer(kServeExamples);
  serve->add_option("RESULT", arguments->folder, "The folder of the result")->required()->type_name("DIR");
  serve->add_option("--port", arguments->port, "Port of this machine to listen at; default: a free one")
      ->type_name("N")
      ->check(CLI::Range(1, 65535));
  serve
      ->add_option("--picture-mb", arguments->picture_mb,
                   "MB of the page for its picture, as in tessera report; default: " + std::to_string(kPicture_mb))
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  serve->callback([arguments, &selected] { selected.run = [arguments] { return run_serve(*arguments); }; });
}

}  // namespace tessera::cli
