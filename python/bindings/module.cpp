#include "module.h"

#include "tessera/matching/matching.h"

PYBIND11_MODULE(_tessera, module) {
  using namespace tessera::python;
  module.doc() = "The compiled part of the module tessera.";
  // Classes and signatures show their public names: tessera.Outline.
  const pybind11::object own_name = module.attr("__name__");
  module.attr("__name__") = "tessera";
  pybind11::register_exception<tessera::matching::Error>(module, "Error", PyExc_ValueError).attr("__doc__") =
      "Input that is of no use, or a machine that failed. The message says what was found and what is allowed.";
  module.attr("__version__") = tessera::matching::version();
  bind_outlines(module);
  bind_pads(module);
  bind_matches(module);
  bind_libraries(module);
  bind_descriptors(module);
  module.attr("__name__") = own_name;
}
