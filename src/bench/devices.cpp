#include "bench/devices.h"

#include "worker/devices/opencl_devices.h"

namespace tessera::bench {

Json report_head(const std::string& benchmark, const Setting& setting) {
  Json names = Json::array();
  for (const cl::Device& device : worker::chosen_devices(setting.devices)) {
    names.push_back(device.getInfo<CL_DEVICE_NAME>());
  }
  return {{"benchmark", benchmark}, {"quick", setting.quick}, {"devices", names}};
}

int compute_units(const std::string& devices_use) {
  int units = 0;
  for (const cl::Device& device : worker::chosen_devices(devices_use)) {
    units += int(device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>());
  }
  return units;
}

}  // namespace tessera::bench
