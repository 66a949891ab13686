#include "arrays.h"

namespace tessera::python {
namespace {

using matching::Error;
using matching::Point;

std::string shape_text(const Array& array) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i) text += (i ? ", " : "") + std::to_string(array.shape(i));
  return text + (array.ndim() == 1 ? ",)" : ")");
}

Array array_or_error(const py::handle& object, const std::string& name, const std::string& allowed) {
  Array array = Array::ensure(object);
  if (!array) {
    throw Error(name + ": found " + type_name(object) + ", which is no array of numbers; allowed: " + allowed);
  }
  return array;
}

/// Whether the object has rows, like a table or a list of lists. NumPy refuses lists of different lengths with a
/// ValueError; these count as rows here, because points_of() then names the curve.
bool has_rows(const py::object& object) {
  try {
    return py::module_::import("numpy").attr("ndim")(object).cast<int>() >= 2;
  } catch (const py::error_already_set& error) {
    if (!error.matches(PyExc_ValueError)) throw;
    return true;
  }
}

}  // namespace

std::string type_name(const py::handle& object) { return py::str(py::type::handle_of(object).attr("__name__")); }

std::vector<Point> points_of(const py::handle& object, const std::string& name) {
  const std::string allowed = "an array of the shape (N, 2)";
  const Array array = array_or_error(object, name, allowed);
  if (array.ndim() != 2 || array.shape(1) != 2) {
    throw Error(name + ": found an array of the shape " + shape_text(array) + ", allowed: " + allowed);
  }
  if (std::size_t(array.shape(0)) > matching::kMostPoints) {
    throw Error(name + ": found " + std::to_string(array.shape(0)) +
                " points, allowed: " + std::to_string(matching::kMostPoints) + " or fewer");
  }
  const auto numbers = array.unchecked<2>();
  std::vector<Point> points(std::size_t(array.shape(0)));
  for (py::ssize_t i = 0; i < array.shape(0); ++i) points[std::size_t(i)] = {numbers(i, 0), numbers(i, 1)};
  return points;
}

std::vector<std::vector<Point>> curves_of(const py::object& curves) {
  if (!py::isinstance<py::sequence>(curves) && !py::isinstance<py::array>(curves)) {
    throw Error("curves: found " + type_name(curves) + ", allowed: an array of the shape (N, 2), or a list of them");
  }
  const auto list = py::reinterpret_borrow<py::sequence>(curves);
  // One curve, whose items are points, or several, whose items are curves.
  if (list.size() > 0 && !has_rows(list[0])) return {points_of(curves, "curve 0")};
  if (list.size() > matching::kMostCurves) {
    throw Error("an outline of " + std::to_string(list.size()) +
                " curves, allowed: " + std::to_string(matching::kMostCurves) + " or fewer");
  }
  std::vector<std::vector<Point>> result;
  for (std::size_t i = 0; i < list.size(); ++i) result.push_back(points_of(list[i], "curve " + std::to_string(i)));
  return result;
}

Array array_of(const std::vector<Point>& points) {
  Array array({py::ssize_t(points.size()), py::ssize_t(2)});
  auto numbers = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < points.size(); ++i) {
    numbers(py::ssize_t(i), 0) = points[i].x;
    numbers(py::ssize_t(i), 1) = points[i].y;
  }
  return array;
}

Array array_of(const std::vector<double>& numbers) { return Array(py::ssize_t(numbers.size()), numbers.data()); }

std::vector<double> numbers_of(const py::handle& object, const std::string& name) {
  const Array array = array_or_error(object, name, "an array of numbers");
  return std::vector<double>(array.data(), array.data() + array.size());
}

}  // namespace tessera::python
