// write_hostile_jobs COUNT: writes job_1.toml to job_COUNT.toml into the working directory, with the generator of tests/job/hostile_job.h.
// Some jobs name own.h5 as library and mask.svg as canvas, others a pipe, a device or a folder.
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "job/hostile_job.h"

int main(int argc, char** argv) {
  const std::vector<std::string> libraries = {"own.h5", "own.h5", "own.h5", "pipe", "/dev/zero", "folder", "none.h5"};
  const std::vector<std::string> canvases = {"", "", "", "mask.svg", "pipe", "/dev/zero", "folder", "none.svg"};
  const std::size_t count = argc == 2 ? std::strtoul(argv[1], nullptr, 10) : 0;
  for (std::size_t i = 1; i <= count; ++i) {
    tessera::test::HostileJob job(std::uint32_t(1000 + i));
    std::ofstream("job_" + std::to_string(i) + ".toml", std::ios::binary)
        << job.make(libraries[i % libraries.size()], canvases[i % canvases.size()]);
  }
}
