#include "worker/devices/device_list.h"

#include <algorithm>
#include <cstdio>

#include "core/base/count_text.h"
#include "core/base/kept_memory.h"
#include "worker/devices/arithmetic_probe.h"
#include "worker/devices/driver_faults.h"
#include "worker/devices/kernel_cache.h"
#include "worker/devices/opencl_devices.h"

namespace tessera::worker {
namespace {

/// Why a job cannot use the device: its compiler fails, or it computes wrongly. Empty where it can.
std::string fault_text(const cl::Device& device) {
  if (!device.getInfo<CL_DEVICE_AVAILABLE>()) return ", NOT AVAILABLE";
  try {
    check_arithmetic(DeviceSession(device, kernel_source, kernel_options(PadParameters().levels, lanes_for(device))));
  } catch (const EnvironmentError& error) {
    return ", NOT USABLE: " + std::string(error.what());
  }
  return "";
}

std::string device_line(std::size_t number, const cl::Device& device) {
  const DeviceDescription d = describe(device);
  return "  " + std::to_string(number) + ": " + d.kind + " \"" + d.name + "\", driver " + d.driver + ", " +
         count_text(device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>(), "compute unit") + ", " +
         gigabytes(device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>()) + " of memory, " +
         gigabytes(device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>()) + " in one buffer" + fault_text(device) + "\n";
}

std::string platform_line(const cl::Platform& platform) {
  return "platform \"" + platform.getInfo<CL_PLATFORM_NAME>() + "\", " + platform.getInfo<CL_PLATFORM_VERSION>() + "\n";
}

/// A text about a CPU's memory: what a job's processes take beside the memory that it offers as a device.
std::string kept_memory_text(const std::vector<cl::Device>& devices) {
  const bool any_cpu = std::any_of(devices.begin(), devices.end(), [](const cl::Device& device) {
    return device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU;
  });
  if (!any_cpu) return "";
  return "A CPU device uses the memory of the host, where each process of a job may also keep " +
         std::to_string(kKeptFreed_bytes / 1'000'000) + " MB\nthat it has freed (tessera plan counts them).\n";
}

std::string use_text(std::size_t devices) {
  const std::string what = devices == 1 ? "this device" : "all " + std::to_string(devices) + " devices";
  return "\nA job without [devices] uses " + what +
         " in every worker. devices.use = \"cpu\", \"gpu\" or numbers from the list, as in\n\"0,2\", chooses; "
         "devices.per_worker = N gives each worker of a node N of its own.\n";
}

std::string faults_text() {
  std::string text;
  for (const std::string& fault : driver_list_faults()) text += "\nNot found: " + fault + ".\n";
  return text;
}

}  // namespace

std::string device_list() {
  const std::vector<cl::Device> devices = opencl_devices();
  std::string text;
  cl_platform_id latest = nullptr;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const cl_platform_id platform = devices[i].getInfo<CL_DEVICE_PLATFORM>();
    if (platform != latest) text += platform_line(cl::Platform(platform));
    text += device_line(i, devices[i]);
    latest = platform;
  }
  return text + use_text(devices.size()) + kept_memory_text(devices) + kernel_cache_text(kernel_cache()) + "\n" +
         faults_text();
}

}  // namespace tessera::worker
