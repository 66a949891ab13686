
#include "cli/commands.h"
#include "terminal/terminal.h"
#include "worker/devices/device_list.h"

namespace tessera::cli {
namespace {

constexpr const char* kDevicesExamples =
    "Examples:\n"
    "  tessera devices                                            of this machine\n"
    "  srun -N 4 --ntasks-per-node=1 tessera devices              of each node of an allocation\n"
    "  tessera collage my.toml --set devices.use=0                computes on the first of the list\n"
    "Each device compiles the kernels and computes some hard cases; a device that fails is NOT USABLE, and its line "
    "says\n"
    "why. Drivers are named if their library cannot be loaded, or if no file lists it (as in containers).\n"
    "If no device is found the exit code is 1, and the message says what may help.";

}  // namespace

void add_devices_command(CLI::App& app, Command& selected) {
  CLI::App* devices =
      app.add_subcommand("devices", "List the OpenCL devices of this machine, and what a job would use");
  devices->footer(kDevicesExamples);
  devices->callback([&selected] {
    selected.run = [] {
      print_lines(worker::device_list());
      return 0;
    };
  });
}

}  // namespace tessera::cli
