#include "pads.h"

#include <limits>

#include "module.h"

namespace tessera::python {

Array Pads::positions() const {
  std::vector<matching::Point> points;
  for (const matching::Pad& pad : pads) points.push_back(pad.position);
  return array_of(points);
}

Array Pads::arclengths(std::vector<double> matching::Pad::*side) const {
  Array array({py::ssize_t(pads.size()), py::ssize_t(levels)});
  auto numbers = array.mutable_unchecked<2>();
  for (std::size_t row = 0; row < pads.size(); ++row) {
    const std::vector<double>& lengths = pads[row].*side;
    for (std::size_t level = 0; level < std::size_t(levels); ++level) {
      numbers(py::ssize_t(row), py::ssize_t(level)) =
          level < lengths.size() ? lengths[level] : std::numeric_limits<double>::quiet_NaN();
    }
  }
  return array;
}

namespace {

using matching::Pad;

Array distances(const Pads& p, const Pads& q) {
  Array array({py::ssize_t(p.pads.size()), py::ssize_t(q.pads.size())});
  double* at = array.mutable_data();
  const py::gil_scoped_release released;
  for (const Pad& one : p.pads) {
    for (const Pad& other : q.pads) *at++ = pad_distance(one, other);
  }
  return array;
}

Pads pads_of_outline(const matching::Outline& outline, int levels, double delta_tau_rad, double smoothing,
                     int samples) {
  const py::gil_scoped_release released;
  return {pads_of(outline, {levels, delta_tau_rad, smoothing, samples}), levels};
}

}  // namespace

void bind_pads(py::module_& module) {
  py::class_<Pads>(module, "Pads", R"(PADs at N points of an outline, as arrays.

Around a point of a curve, level i reaches so far to the left and to the right that the integral of the absolute curvature
over each side is 2^i delta_tau. A PAD holds these arclengths (Kwan et al. 2016, section 3.2).)")
      .def("__len__", [](const Pads& p) { return p.pads.size(); })
      .def_property_readonly("position", &Pads::positions, "Shape (N, 2): the points, on the smoothed curves.")
      .def_property_readonly(
          "curve", [](const Pads& p) { return p.column([](const Pad& pad) { return double(pad.curve); }); },
          "Shape (N,): number of the curve in the outline.")
      .def_property_readonly(
          "along", [](const Pads& p) { return p.column([](const Pad& pad) { return pad.along; }); },
          "Shape (N,): arclength from the curve's first point, in its units.")
      .def_property_readonly(
          "left", [](const Pads& p) { return p.arclengths(&Pad::left); },
          "Shape (N, levels): arclengths in the curve's units; NaN where an open curve ends before.")
      .def_property_readonly(
          "right", [](const Pads& p) { return p.arclengths(&Pad::right); },
          "Shape (N, levels): the same on the other side.")
      .def_property_readonly(
          "convexity", [](const Pads& p) { return p.column([](const Pad& pad) { return double(pad.convexity); }); },
          "Shape (N,): +1 where the interior bulges out, -1 where it is drawn in, 0 where the curve is flat.")
      .def("distances", &distances, py::arg("other"), R"(Distances of these N PADs to M others: shape (N, M).

The largest difference of an element (Equation 1 of the paper), 0 to 2, by the levels that both have. Infinite where they
have fewer than two levels of a side in common.)");

  module.def("pads", &pads_of_outline, py::arg("outline"), py::kw_only(), py::arg("levels") = 5,
             py::arg("delta_tau_rad") = 0.2, py::arg("smoothing") = 0.0, py::arg("samples") = 64,
             R"(The PADs along an outline.

levels: 2 to 6. delta_tau_rad: turning of level 0 on each side, 0.01 to 1.
smoothing: width (sigma) of the Gaussian that smooths the curves first, in their units; 0: a hundredth of their length. PADs
agree where both curves were smoothed by the same part of their size.
samples: number of PADs, evenly along all curves.

Returns Pads. Raises Error where a setting is out of its range.)");
}

}  // namespace tessera::python
