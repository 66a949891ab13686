// The layers around a drawer (drawers.h) that a kernel may lack or refuse, and whether they hold.
#pragma once

#include <cstdint>
#include <string>

namespace tessera {

/// From good to bad.
enum class LayerState : std::uint32_t {
  holds,
  missing,  // the kernel does not have it
  failed    // the kernel has it, and it does not hold
};

/// Part of a drawer's greeting.
struct DrawerLayers {
  LayerState files = LayerState::holds;         // confine_to_files, drawer_landlock.h
  LayerState system_calls = LayerState::holds;  // forbid_system_calls, drawer_sandbox.h
};

/// Of each layer the worse state.
DrawerLayers worse_of(const DrawerLayers& a, const DrawerLayers& b);

/// A layer has failed. That one is missing is no reason to warn: the user may not be able to change the kernel.
bool any_failed(const DrawerLayers& layers);

/// One line for people that says what does not hold; empty where all do.
std::string layers_note(const DrawerLayers& layers);

}  // namespace tessera
