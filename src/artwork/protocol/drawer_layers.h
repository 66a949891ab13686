// The security layers around a drawer (drawers.h) that a kernel may lack or refuse, and their states.
#pragma once

#include <cstdint>
#include <string>

namespace tessera {

/// The state of a layer, from good to bad.
enum class LayerState : std::uint32_t {
  holds,
  missing,  // the kernel does not have it
  failed    // the kernel has it, but it does not hold
};

/// A part of a drawer's greeting.
struct DrawerLayers {
  LayerState files = LayerState::holds;         // confine_to_files, drawer_landlock.h
  LayerState system_calls = LayerState::holds;  // forbid_system_calls, drawer_sandbox.h
};

/// The worse of both states for each layer.
DrawerLayers worse_of(const DrawerLayers& a, const DrawerLayers& b);

/// Whether a layer has failed. A missing layer is no reason to warn: the user may not be able to change the kernel.
bool any_failed(const DrawerLayers& layers);

/// One line for people that says which layers do not hold; empty where all do.
std::string layers_note(const DrawerLayers& layers);

}  // namespace tessera
