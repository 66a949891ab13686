// Owners of Cairo's surfaces and contexts, which free them.
#pragma once

#include <cairo.h>

#include <memory>

namespace tessera {

struct DestroyCairo {
  void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
  void operator()(cairo_t* c) const { cairo_destroy(c); }
};
using CairoSurface = std::unique_ptr<cairo_surface_t, DestroyCairo>;
using CairoContext = std::unique_ptr<cairo_t, DestroyCairo>;

}  // namespace tessera
