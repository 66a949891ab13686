#include "result/run_record.h"

#include <cinttypes>
#include <cstdio>

#include "core/base/count_text.h"

namespace tessera {

std::string digest_text(std::uint64_t digest) {
  char text[17];
  std::snprintf(text, sizeof text, "%016" PRIx64, digest);
  return text;
}

std::string devices_text(const std::vector<DeviceDescription>& devices) {
  if (devices.empty()) return "no devices";
  std::string text;
  for (const DeviceDescription& device : devices) {
    if (!text.empty()) text += ", ";
    text += device.kind + " \"" + device.name + "\" of " + device.platform + ", driver " + device.driver + ": " +
            count_text(std::size_t(device.shapes), "shape");
  }
  return text;
}

}  // namespace tessera
