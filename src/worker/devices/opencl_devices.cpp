#include "worker/devices/opencl_devices.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <future>
#include <numeric>
#include <sstream>
#include <system_error>
#include <thread>

#include "core/base/count_text.h"
#include "core/base/process_limits.h"
#include "core/base/split_text.h"
#include "worker/devices/driver_faults.h"
#include "worker/devices/kernel_cache.h"
#include "worker/devices/opencl_runtime.h"

namespace tessera::worker {
namespace {

const char* kind_name(const cl::Device& device) {
  const cl_device_type type = device.getInfo<CL_DEVICE_TYPE>();
  return type & CL_DEVICE_TYPE_GPU ? "gpu" : type & CL_DEVICE_TYPE_CPU ? "cpu" : "accelerator";
}

/// The devices as a text: '0: cpu "pthread-...", 1: ...'.
std::string listed(const std::vector<cl::Device>& devices) {
  std::ostringstream text;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    text << (i ? ", " : "") << i << ": " << kind_name(devices[i]) << " \"" << devices[i].getInfo<CL_DEVICE_NAME>()
         << "\"";
  }
  return text.str();
}

/// The devices of a platform. OpenCL reports a platform without devices as an error; here the list is empty.
std::vector<cl::Device> devices_of(const cl::Platform& platform) {
  std::vector<cl::Device> devices;
  try {
    platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
  } catch (const cl::Error&) {
    devices.clear();
  }
  return devices;
}

std::vector<cl::Platform> platforms() {
  std::vector<cl::Platform> found;
  try {
    cl::Platform::get(&found);
  } catch (const cl::Error&) {
    found.clear();
  }
  return found;
}

/// Why there are no devices. PoCL finds none, without saying why, where it cannot write to the folder of its cache.
std::string why_no_devices(const std::vector<cl::Platform>& found) {
  if (found.empty()) {
    std::string faults;
    for (const std::string& fault : driver_list_faults()) faults += "; " + fault;
    return "no OpenCL platform is installed (Debian: package pocl-opencl-icd for CPUs; OCL_ICD_VENDORS, where it is "
           "set, names the folder of the list)" +
           faults + process_limits();
  }
  std::string names;
  for (const cl::Platform& platform : found) {
    names += (names.empty() ? "\"" : ", \"") + platform.getInfo<CL_PLATFORM_NAME>() + "\"";
  }
  return "the OpenCL platforms of this machine (" + names +
         ") have no devices; PoCL (\"Portable Computing Language\") has none where it cannot write its cache: HOME, or "
         "POCL_CACHE_DIR where it is set, must be a folder that can be written";
}

/// Starts as many threads at once as PoCL will for a CPU, and ends them. Throws EnvironmentError where the system gives too
/// few: PoCL would end the process by abort(3) with a message that names no limit. Our handler for that signal
/// (files/library_abort.h) could not help, because LLVM has just replaced it.
void check_threads_can_start() {
  const char* const most = std::getenv("POCL_MAX_PTHREAD_COUNT");
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  const unsigned count = most && std::atoi(most) > 0 ? std::min(cores, unsigned(std::atoi(most))) : cores;
  std::promise<void> all_started;
  const std::shared_future<void> end = all_started.get_future().share();
  std::vector<std::jthread> threads;
  try {
    while (threads.size() < count) threads.emplace_back([end] { end.wait(); });
  } catch (const std::system_error& error) {
    all_started.set_value();
    throw no_thread(error);
  }
  all_started.set_value();
}

/// The text that names the request: 'devices.use = "gpu"' or '--devices gpu'.
std::string request_text(const std::string& use, const std::string& option) {
  return option.empty() ? "devices.use = \"" + use + "\"" : option + " " + use;
}

std::vector<cl::Device> devices_of_kind(const std::vector<cl::Device>& all, const std::string& kind,
                                        const std::string& request) {
  std::vector<cl::Device> chosen;
  for (const cl::Device& device : all) {
    if (kind_name(device) == kind) chosen.push_back(device);
  }
  if (chosen.empty()) {
    throw EnvironmentError(request + ": this machine has no such OpenCL device; it has " + listed(all));
  }
  return chosen;
}

std::vector<cl::Device> devices_by_index(const std::vector<cl::Device>& all, const std::string& use,
                                         const std::string& request) {
  const auto refuse = [&](const std::string& found) {
    return InputError(
        request + ": " + found +
        "; allowed: \"all\", \"cpu\", \"gpu\" or distinct indices of this machine's OpenCL devices: " + listed(all));
  };
  std::vector<std::size_t> indices;
  for (const std::string_view part : split_outside(use, ',')) {
    const std::string item(part);
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(item.data(), item.data() + item.size(), index);
    if (error != std::errc() || end != item.data() + item.size()) throw refuse("\"" + item + "\" is no index");
    if (index >= all.size()) throw refuse("there is no device " + item);
    if (std::find(indices.begin(), indices.end(), index) != indices.end()) throw refuse(item + " is listed twice");
    indices.push_back(index);
  }
  std::vector<cl::Device> chosen;
  for (const std::size_t index : indices) chosen.push_back(all[index]);
  return chosen;
}

}  // namespace

std::vector<cl::Device> opencl_devices() {
  kernel_cache();
  std::vector<cl::Device> all;
  const std::vector<cl::Platform> found = platforms();
  check_threads_can_start();  // after the drivers were loaded, which take memory, too
  for (const cl::Platform& platform : found) {
    for (cl::Device& device : devices_of(platform)) all.push_back(std::move(device));
  }
  if (all.empty()) throw EnvironmentError(why_no_devices(found));
  return all;
}

DockingLanes lanes_for(const cl::Device& device) {
  return device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU ? DockingLanes::vectors : DockingLanes::items;
}

DeviceDescription describe(const cl::Device& device) {
  const cl::Platform platform(device.getInfo<CL_DEVICE_PLATFORM>());
  return {kind_name(device), device.getInfo<CL_DEVICE_NAME>(), platform.getInfo<CL_PLATFORM_NAME>(),
          device.getInfo<CL_DRIVER_VERSION>()};
}

std::vector<std::size_t> own_devices(std::size_t devices, const DeviceShare& share) {
  const std::size_t count = share.per_worker > 0 ? std::size_t(share.per_worker) : devices;
  const std::size_t first = share.per_worker > 0 ? count * std::size_t(share.worker) : 0;
  const std::size_t wanted = share.per_worker > 0 ? count * std::size_t(share.workers) : devices;
  if (wanted > devices) {
    throw InputError("devices.per_worker = " + std::to_string(share.per_worker) + ": " +
                     count_text(std::size_t(share.workers), "worker") + " of this node " +
                     by_count(std::size_t(share.workers), "needs", "need") + " " + count_text(wanted, "device") +
                     ", and it has " + std::to_string(devices) +
                     "; allowed: fewer ranks on a node (--ntasks-per-node, mpirun -N), or devices.per_worker = 0, "
                     "where all workers share all devices");
  }
  std::vector<std::size_t> own(count);
  std::iota(own.begin(), own.end(), first);
  return own;
}

std::vector<cl::Device> chosen_devices(const std::string& use, const DeviceShare& share, const std::string& option) {
  const std::vector<cl::Device> all = opencl_devices();
  const std::string request = request_text(use, option);
  const std::vector<cl::Device> named = use == "all"                   ? all
                                        : use == "cpu" || use == "gpu" ? devices_of_kind(all, use, request)
                                                                       : devices_by_index(all, use, request);
  std::vector<cl::Device> own;
  for (const std::size_t i : own_devices(named.size(), share)) own.push_back(named[i]);
  return own;
}

}  // namespace tessera::worker
