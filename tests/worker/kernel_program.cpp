// kernel_program FOLDER: writes the kernels' source and build options, as the program compiles them for devices whose work items are lanes.
// The files are kernels.cl, and options_N.txt for each match.levels N.
#include <fstream>

#include "core/settings/tuning.h"
#include "worker/devices/kernel_options.h"

int main(int count, char** arguments) {
  using namespace tessera;
  if (count != 2) return 2;
  const std::string folder = arguments[1];
  std::ofstream(folder + "/kernels.cl") << worker::kernel_source;
  for (int levels = 2; levels <= kMaxPadLevels; ++levels) {
    std::ofstream(folder + "/options_" + std::to_string(levels) + ".txt")
        << worker::kernel_options(levels, worker::DockingLanes::items) << "\n";
  }
}
