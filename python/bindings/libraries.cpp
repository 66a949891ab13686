#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "module.h"
#include "pads.h"

namespace tessera::python {

using matching::KnownOutlines;
using matching::Library;
using matching::Outline;
using matching::Recognised;

// HDF5 serves one thread at a time, and other modules (h5py) call it while they hold the interpreter's lock. So the lock is
// held while a library is read. KnownOutlines(Library) reads and indexes lot by lot, so it holds the lock until it is done.
void bind_libraries(py::module_& module) {
  py::class_<Library>(module, "Library", R"(A library of shapes, as `tessera library build` makes it.

path: the file. Shapes are read when they are asked for. Raises Error, which names the file.)")
      .def(py::init([](const std::filesystem::path& path) { return Library(path.string()); }), py::arg("path"))
      .def("__len__", &Library::size)
      .def_property_readonly("names", &Library::names, "A list of all shapes' names, in their order.")
      .def("outline", &Library::outline, py::arg("shape"), R"(The Outline of a shape.

shape: its number, from 0. The outer curve comes first, with 512 points. The origin is the centroid of its area, and the
unit of length is the square root of that area.)")
      .def(
          "pads",
          [](const Library& library, std::size_t shape, int level) {
            return Pads{library.pads(shape, level), library.pad_levels()};
          },
          py::arg("shape"), py::arg("level") = 2, R"(The Pads of a shape's outer curve, as they are stored.

shape: its number, from 0. level: of the smoothing, 0 (the coarsest) to 4; Library.smoothing(level) is its width. Lengths
are in units of the outline.)")
      .def_static(
          "smoothing", &Library::smoothing, py::arg("level"),
          "Width (sigma) of a level's Gaussian, in units of the outlines: 0.177 for level 0, then half each time.")
      .def_property_readonly("pad_levels", &Library::pad_levels, "Levels of the stored PADs.")
      .def_property_readonly("pad_delta_tau_rad", &Library::pad_delta_tau_rad, "Their delta_tau.")
      .def("__repr__", [](const Library& l) { return "<tessera.Library: shapes: " + std::to_string(l.size()) + ">"; });

  py::class_<Recognised>(module, "Recognised", "A known outline that a query is, or is a part of.")
      .def_readonly("known", &Recognised::known, "Number of the known outline, from 0.")
      .def_readonly("similarity", &Recognised::similarity,
                    "How much of the query's length the known outline follows, and how closely: 0 to about 1.")
      .def_readonly(
          "score", &Recognised::score,
          "The same length as a part of the geometric mean of both lengths, 0 to about 1: tells known from unknown.")
      .def_readonly("query_from_known", &Recognised::query_from_known, "The Similarity that lays it onto the query.")
      .def("__repr__", [](const Recognised& r) {
        return py::str("<tessera.Recognised: known {}, similarity {:.3f}, score {:.3f}>")
            .format(r.known, r.similarity, r.score);
      });

  py::class_<KnownOutlines>(module, "KnownOutlines", R"(Known outlines with an index of their PADs.

known: a Library, or a list of Outline. Of each outline the closed curve with the largest area and its holes are known. An
outline takes about 80 KB of memory.)")
      .def(py::init<const Library&>(), py::arg("known"))
      .def(py::init<const std::vector<Outline>&>(), py::arg("known"), py::call_guard<py::gil_scoped_release>())
      .def("__len__", &KnownOutlines::size)
      .def("__repr__",
           [](const KnownOutlines& known) {
             return "<tessera.KnownOutlines: outlines: " + std::to_string(known.size()) + ">";
           })
      .def(
          "recognise",
          [](const KnownOutlines& known, const Outline& query, std::size_t most, std::optional<double> scale) {
            const py::gil_scoped_release released;
            return known.recognise(query, {most, scale});
          },
          py::arg("query"), py::kw_only(), py::arg("most") = 10, py::arg("scale") = py::none(),
          R"(Which known outlines the query is, or is a part of.

query: an Outline. It may be turned, of any size, clipped or partly hidden.
most: how many are told.
scale: query units for one unit of the known outlines (of a Library: for one px of its drawings), where it is known.

Returns a list of Recognised, the best first by similarity. A query whose best outline has a score below 0.4 is, as a rule, none of
them; of a small part of an outline take less. Open curves may run either way, all the same way. It computes on all cores; a
process that was forked after the first call gets an Error.)");
}

}  // namespace tessera::python
