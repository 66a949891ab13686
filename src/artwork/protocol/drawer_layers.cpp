#include "artwork/protocol/drawer_layers.h"

#include <algorithm>

namespace tessera {
namespace {

std::string note_of(LayerState state, const std::string& mechanism, const std::string& consequence) {
  if (state == LayerState::holds) return "";
  return mechanism + (state == LayerState::missing ? ", which this kernel lacks, " : ", which failed here, ") +
         consequence;
}

}  // namespace

DrawerLayers worse_of(const DrawerLayers& a, const DrawerLayers& b) {
  return {std::max(a.files, b.files), std::max(a.system_calls, b.system_calls)};
}

bool any_failed(const DrawerLayers& layers) {
  return layers.files == LayerState::failed || layers.system_calls == LayerState::failed;
}

std::string layers_note(const DrawerLayers& layers) {
  const std::string files = note_of(layers.files, "Landlock", "does not limit which files foreign drawings can read");
  const std::string calls = note_of(layers.system_calls, "seccomp", "does not limit what foreign drawings can do");
  return files + (files.empty() || calls.empty() ? "" : "; ") + calls;
}

}  // namespace tessera
