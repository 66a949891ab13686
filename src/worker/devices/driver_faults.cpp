#include "worker/devices/driver_faults.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace tessera::worker {
namespace {

constexpr const char* kUsualFolder = "/etc/OpenCL/vendors";
constexpr std::array kDrivers = {"libnvidia-opencl.so.1", "libamdocl64.so", "libigdrcl.so"};

/// A device file that a maker's kernel driver makes when it finds a card, and the OpenCL library for that card.
struct Card {
  const char* maker;
  const char* file;
  const char* library;
  const char* cure;
};
constexpr std::array kCards = {
    Card{"NVIDIA", "nvidiactl", "libnvidia-opencl.so.1", "a container gets it by NVIDIA_DRIVER_CAPABILITIES=compute"},
    Card{"AMD", "kfd", "libamdocl64.so", "it is part of ROCm's OpenCL runtime"}};

/// A file of the loader's list and the library that it names. Where OCL_ICD_VENDORS is a library, it is both.
struct Entry {
  std::string file;
  std::string library;
};

Entry read_entry(const std::filesystem::path& file) {
  Entry entry{file.string(), ""};
  std::ifstream(file) >> entry.library;
  return entry;
}

std::vector<Entry> driver_list() {
  const char* const chosen = std::getenv("OCL_ICD_VENDORS");
  const std::filesystem::path place = chosen && *chosen ? chosen : kUsualFolder;
  std::error_code ignored;
  std::vector<Entry> entries;
  if (std::filesystem::is_directory(place, ignored)) {
    for (const auto& file : std::filesystem::directory_iterator(place, ignored)) {
      if (file.path().extension() == ".icd" && file.is_regular_file(ignored)) entries.push_back(read_entry(file));
    }
  } else if (place.extension() == ".icd") {
    entries.push_back(read_entry(place));
  } else if (chosen && *chosen) {
    entries.push_back({place.string(), place.string()});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.file < b.file; });
  return entries;
}

/// Why the library cannot be loaded. Empty where it can.
std::string load_fault(const std::string& library) {
  if (library.empty()) return "the file is empty";
  void* const loaded = dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (!loaded) return dlerror();
  dlclose(loaded);
  return "";
}

std::string stem_of(const std::string& library) { return library.substr(0, library.find(".so")); }

bool has_driver(const std::vector<Entry>& entries, const std::string& driver) {
  return std::any_of(entries.begin(), entries.end(),
                     [&](const Entry& entry) { return entry.library.find(stem_of(driver)) != std::string::npos; });
}

}  // namespace

std::vector<std::string> driver_list_faults(const std::filesystem::path& devices) {
  const std::vector<Entry> entries = driver_list();
  std::vector<std::string> faults;
  for (const Entry& entry : entries) {
    const std::string fault = load_fault(entry.library);
    if (fault.empty()) continue;
    faults.push_back(entry.file + " names the OpenCL library \"" + entry.library +
                     "\", which cannot be loaded: " + fault);
  }
  for (const std::string driver : kDrivers) {
    if (has_driver(entries, driver) || !load_fault(driver).empty()) continue;
    faults.push_back("this machine has the OpenCL library " + driver + ", but no file in " + kUsualFolder +
                     " names it, so that its devices are not found: OCL_ICD_VENDORS=" + driver + " chooses it");
  }
  for (const Card& card : kCards) {
    std::error_code ignored;
    const bool there = std::filesystem::exists(devices / card.file, ignored);
    if (!there || has_driver(entries, card.library) || load_fault(card.library).empty()) continue;
    faults.push_back("this machine has a card of " + std::string(card.maker) + " (" + (devices / card.file).string() +
                     "), but not the OpenCL library " + card.library + ": " + card.cure);
  }
  return faults;
}

std::string compiler_fault(const std::string& log, int code) {
  if (log.find_first_not_of(" \t\r\n") != std::string::npos) return log;
  return "code " + std::to_string(code) +
         ", and no log: the driver's compiler may be missing (NVIDIA: libnvidia-nvvm.so.4 and "
         "libnvidia-ptxjitcompiler.so.1; a container gets them by NVIDIA_DRIVER_CAPABILITIES=compute)";
}

}  // namespace tessera::worker
