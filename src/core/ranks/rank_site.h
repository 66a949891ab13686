// The machine on which a rank of a job runs, for the records of a run. It never affects the picture.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tessera {

/// An OpenCL device, as its driver describes it.
struct DeviceDescription {
  std::string kind;  // "cpu", "gpu" or "accelerator"
  std::string name;
  std::string platform;
  std::string driver;        // its version
  std::uint32_t shapes = 0;  // number of shapes of the library that it searches

  friend bool operator==(const DeviceDescription&, const DeviceDescription&) = default;
};

struct RankSite {
  std::string host;
  std::vector<DeviceDescription> devices;  // the devices that the rank computes on; a master with workers has none

  friend bool operator==(const RankSite&, const RankSite&) = default;
};

}  // namespace tessera
