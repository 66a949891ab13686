#include <unistd.h>

#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>

#include "cli/commands.h"
#include "core/base/error.h"
#include "files/own_program.h"

namespace tessera::cli {
namespace {

constexpr const char* kBench = "bench";

}  // namespace

void add_bench_command(CLI::App& app) {
  app.add_subcommand(kBench, "Measure this machine against the paper and the alternatives")
      ->footer("tessera bench --help names the benchmarks.");
}

bool asks_for_bench(int argc, char** argv) { return argc > 1 && std::string_view(argv[1]) == kBench; }

void become_bench(char** argv) {
  const std::string program = program_beside_own("tessera-bench");
  argv[1] = const_cast<char*>(program.c_str());  // execv does not change it
  ::execv(program.c_str(), argv + 1);
  if (errno == ENOENT)
    throw EnvironmentError("the program tessera-bench, which measures, is missing: looked for " + program +
                           "; scripts/build.sh --without-tests tessera-bench builds it, cmake --install installs it");
  throw EnvironmentError("cannot start " + program + ": " + std::generic_category().message(errno));
}

}  // namespace tessera::cli
