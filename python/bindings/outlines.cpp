#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <tuple>

#include "arrays.h"
#include "module.h"

namespace tessera::python {
namespace {

using matching::Curve;
using matching::Outline;
using matching::Similarity;

Outline make_outline(const py::object& curves, bool closed, double smoothing) {
  std::vector<std::vector<matching::Point>> points = curves_of(curves);
  const py::gil_scoped_release released;  // many curves with many points take seconds
  Outline outline;
  if (closed) {
    outline = matching::make_outline(std::move(points));
  } else {
    for (std::vector<matching::Point>& curve : points) outline.curves.push_back({std::move(curve), false});
  }
  outline.smoothing = smoothing;
  check(outline);
  return outline;
}

std::vector<Array> arrays_of(const Outline& outline) {
  std::vector<Array> arrays;
  for (const Curve& curve : outline.curves) arrays.push_back(array_of(curve.points));
  return arrays;
}

std::vector<bool> closed_of(const Outline& outline) {
  std::vector<bool> closed;
  for (const Curve& curve : outline.curves) closed.push_back(curve.closed);
  return closed;
}

/// The state that pickle and copy keep of an Outline: the points of its curves, whether each is closed, the smoothing.
using OutlineState = std::tuple<py::list, std::vector<bool>, double>;

OutlineState state_of(const Outline& outline) {
  return {py::cast(arrays_of(outline)), closed_of(outline), outline.smoothing};
}

/// Restores the curves in their saved direction, which make_outline() might change.
Outline outline_of_state(const OutlineState& state) {
  const auto& [curves, closed, smoothing] = state;
  if (curves.size() != closed.size()) {
    throw matching::Error("the state of an Outline: found " + std::to_string(curves.size()) + " curves and " +
                          std::to_string(closed.size()) + " values of closed, allowed: as many");
  }
  Outline outline;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    outline.curves.push_back({points_of(curves[i], "curve " + std::to_string(i)), closed[i]});
  }
  outline.smoothing = smoothing;
  check(outline);
  return outline;
}

Outline mapped(Outline outline, const Similarity& map) {
  for (Curve& curve : outline.curves) {
    for (matching::Point& p : curve.points) p = map.apply(p);
  }
  outline.smoothing *= map.scale();
  check(outline);
  return outline;
}

std::string outline_text(const Outline& outline) {
  std::size_t points = 0;
  for (const Curve& curve : outline.curves) points += curve.points.size();
  return "<tessera.Outline: curves: " + std::to_string(outline.curves.size()) + ", points: " + std::to_string(points) +
         ">";
}

/// Applies a transform to one point, or to an array of the shape (N, 2); the result has the same shape.
Array applied(const Similarity& similarity, const py::object& object) {
  const Array given = Array::ensure(object);
  if (given && given.ndim() == 1 && given.size() == 2) {
    const matching::Point p = similarity.apply({given.at(0), given.at(1)});
    return array_of(std::vector<double>{p.x, p.y});
  }
  std::vector<matching::Point> points = points_of(object, "points");
  for (matching::Point& p : points) p = similarity.apply(p);
  return array_of(points);
}

std::string similarity_text(const Similarity& s) {
  return py::str("<tessera.Similarity: scale {:.6g}, turned by {:.6g} rad, moved by ({:.6g}, {:.6g})>")
      .format(s.scale(), s.rotation_rad(), s.tx, s.ty);
}

}  // namespace

void bind_outlines(py::module_& module) {
  py::class_<Similarity>(module, "Similarity", R"(A rotation, uniform scale and translation; it does not mirror.

It maps (x, y) to (a x - b y + tx, b x + a y + ty).)")
      .def(py::init([](double a, double b, double tx, double ty) {
             return Similarity{a, b, tx, ty};
           }),
           py::arg("a") = 1.0, py::arg("b") = 0.0, py::arg("tx") = 0.0, py::arg("ty") = 0.0)
      .def_readonly("a", &Similarity::a, "Scale times the cosine of the rotation.")
      .def_readonly("b", &Similarity::b, "Scale times the sine of the rotation.")
      .def_readonly("tx", &Similarity::tx, "In units of the target.")
      .def_readonly("ty", &Similarity::ty, "In units of the target.")
      .def_property_readonly("scale", &Similarity::scale, "Units of the target for one unit of the source.")
      .def_property_readonly("rotation_rad", &Similarity::rotation_rad,
                             "In (-pi, pi], from the x axis towards the y axis: clockwise where y points down.")
      .def("apply", &applied, py::arg("points"), "Maps one point, or an array of the shape (N, 2).")
      .def("inverse", &Similarity::inverse)
      .def(
          "__matmul__", [](const Similarity& outer, const Similarity& inner) { return outer * inner; },
          "First the right one, then the left one.")
      .def(py::pickle([](const Similarity& s) { return std::make_tuple(s.a, s.b, s.tx, s.ty); },
                      [](const std::tuple<double, double, double, double>& state) {
                        const auto& [a, b, tx, ty] = state;
                        return Similarity{a, b, tx, ty};
                      }))
      .def("__repr__", &similarity_text);

  py::class_<Outline>(module, "Outline", R"(Curves that belong together: the outlines of a silhouette, or open lines.

curves: an array of the shape (N, 2), or a list of such arrays, in any unit of length. The last point of a closed curve is
joined to the first and is not repeated.
closed: whether all of them are closed. Closed curves are turned so that the interior is on their left (the shoelace area
of an outer boundary is positive, that of a hole negative): a curve within an odd number of others is a hole.
smoothing: width (sigma) of the narrowest Gaussian that takes the noise of the points out, in the curves' units; 0:
1.5/1024 of the longer side of the box round all curves.

Raises Error where it is no outline: no curves, more than 1,000 curves or 4,194,304 points, fewer than 3 points of a closed
curve or 2 of an open one, coordinates that are not finite or beyond +-1e15, curves without length.)")
      .def(py::init(&make_outline), py::arg("curves"), py::kw_only(), py::arg("closed") = true,
           py::arg("smoothing") = 0.0)
      .def_property_readonly("curves", &arrays_of, "A list of arrays of the shape (N, 2): copies.")
      .def_property_readonly("closed", &closed_of, "A list that says of each curve whether it is closed.")
      .def_readonly("smoothing", &Outline::smoothing, "In the curves' units; 0: 1.5/1024 of their extent.")
      .def_property_readonly("length",
                             py::cpp_function(py::overload_cast<const Outline&>(&matching::length_of),
                                              py::call_guard<py::gil_scoped_release>()),
                             "The length of all curves together.")
      .def_property_readonly("area", py::cpp_function(&matching::area_of, py::call_guard<py::gil_scoped_release>()),
                             "What the closed curves enclose, holes taken off.")
      .def("mapped", &mapped, py::arg("similarity"), py::call_guard<py::gil_scoped_release>(),
           "The outline with all its points mapped.")
      .def(py::pickle(&state_of, &outline_of_state))
      .def("__repr__", &outline_text);

  module.def(
      "read_drawing",
      [](const std::filesystem::path& path, bool centre_lines) {
        const py::gil_scoped_release released;
        return matching::read_drawing(path.string(),
                                      centre_lines ? matching::Trace::centre_lines : matching::Trace::outlines);
      },
      py::arg("path"), py::kw_only(), py::arg("centre_lines") = false,
      R"(The outlines of an SVG, an image (PNG, JPEG, WebP, TIFF, BMP) or a mask.

path: the file.
centre_lines: the middles of strokes instead of the outlines of the silhouette.

Returns an Outline in px of an image or 1/96 inch of an SVG; y points down. A process of its own, tessera-drawer, reads the
file. Raises Error, which names the file.)");
}

}  // namespace tessera::python
