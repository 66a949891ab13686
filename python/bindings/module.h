// The parts of the module; each has a file of its own.
#pragma once

#include <pybind11/pybind11.h>

namespace tessera::python {

void bind_outlines(pybind11::module_& module);
void bind_pads(pybind11::module_& module);
void bind_matches(pybind11::module_& module);
void bind_libraries(pybind11::module_& module);
void bind_descriptors(pybind11::module_& module);

}  // namespace tessera::python
