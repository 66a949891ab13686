#include "result/folder/run_record.h"

#include "core/base/count_text.h"

namespace tessera {

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
