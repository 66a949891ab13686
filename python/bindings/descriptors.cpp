#include <pybind11/stl.h>

#include "arrays.h"
#include "module.h"

namespace tessera::python {
namespace {

using matching::Description;
using matching::Descriptor;
using matching::Matrix;
using matching::Outline;

/// A Descriptor whose members are written in Python.
class PythonDescriptor : public Descriptor {
 public:
  std::string name() const override {
    const py::gil_scoped_acquire acquired;
    return py::cast<std::string>(called("name"));
  }

  Description describe(const Outline& outline) const override {
    const py::gil_scoped_acquire acquired;
    return numbers_of(called("describe", outline), "what describe() returned");
  }

  double distance(const Description& query, const Description& known) const override {
    const py::gil_scoped_acquire acquired;
    const py::object distance = called("distance", array_of(query), array_of(known));
    try {
      return distance.cast<double>();
    } catch (const py::cast_error&) {
      throw matching::Error("what distance() returned: found " + type_name(distance) + ", allowed: a number");
    }
  }

 private:
  template <class... Arguments>
  py::object called(const char* member, const Arguments&... arguments) const {
    const py::gil_scoped_acquire acquired;
    const py::function own = py::get_override(static_cast<const Descriptor*>(this), member);
    if (!own) {
      PyErr_Format(PyExc_NotImplementedError, "a Descriptor needs a member %s()", member);
      throw py::error_already_set();
    }
    return own(arguments...);
  }
};

/// Describes an outline without the interpreter's lock. A descriptor that is written in Python takes the lock again.
Array described(const Descriptor& descriptor, const Outline& outline) {
  Description description;
  {
    const py::gil_scoped_release released;
    description = descriptor.describe(outline);
  }
  return array_of(description);
}

double distance_of(const Descriptor& descriptor, const py::object& query, const py::object& known) {
  const Description of_query = numbers_of(query, "query");
  const Description of_known = numbers_of(known, "known");
  const py::gil_scoped_release released;
  return descriptor.distance(of_query, of_known);
}

Array matrix_of(const Descriptor& descriptor, const std::vector<Outline>& queries,
                const std::optional<std::vector<Outline>>& known) {
  Matrix matrix;
  {
    const py::gil_scoped_release released;
    matrix = distance_matrix(descriptor, queries, known ? *known : queries);
  }
  Array array({py::ssize_t(matrix.rows), py::ssize_t(matrix.columns)});
  std::copy(matrix.values.begin(), matrix.values.end(), array.mutable_data());
  return array;
}

}  // namespace

void bind_descriptors(py::module_& module) {
  py::class_<Descriptor, PythonDescriptor>(module, "Descriptor",
                                           R"(What describes outlines by numbers and compares them.

Derive from it to compare a descriptor of your own with PAD. Members:
name() -> str
describe(outline) -> an array of numbers, whose meaning only the descriptor knows
distance(query, known) -> how much two such arrays (shape (N,)) differ: a float, 0 for the same)")
      .def(py::init<>())
      .def("name", &Descriptor::name)
      .def("describe", &described, py::arg("outline"))
      .def("distance", &distance_of, py::arg("query"), py::arg("known"));

  module.def(
      "pad_descriptor",
      [](int levels, double delta_tau_rad, double smoothing, int samples) {
        return matching::make_pad_descriptor({levels, delta_tau_rad, smoothing, samples});
      },
      py::kw_only(), py::arg("levels") = 5, py::arg("delta_tau_rad") = 0.2, py::arg("smoothing") = 0.0,
      py::arg("samples") = 64, R"(The Descriptor of PADs; the settings are those of pads().

Its distance is the mean, over the query's PADs, of that to the nearest PAD that is known. Size does not count: two discs have
the distance 0; a disc and a square have 0.06, the square and the disc 0.19. A PAD counts 2, the largest distance, where it has
fewer than two levels on a side: on straight lines, on faint arcs, and near the ends of open curves. So does a query without PADs
(all of its curves are shorter than six widths of the smoothing), and a straight line has the distance 2 to itself, too.)");

  module.def("distance_matrix", &matrix_of, py::arg("descriptor"), py::arg("queries"), py::arg("known") = py::none(),
             R"(The distance of each query to each known outline.

queries: a list of N Outline. known: a list of M Outline; without it the queries themselves.

Returns an array of the shape (N, M). Each outline is described once.)");
}

}  // namespace tessera::python
