// Converts NumPy arrays to the library's points and numbers, and back.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "tessera/matching/matching.h"

namespace tessera::python {

namespace py = pybind11;
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The name of an object's class, for messages.
std::string type_name(const py::handle& object);

/// The points of an array of the shape (N, 2); an Error names `name`.
std::vector<matching::Point> points_of(const py::handle& array, const std::string& name);

/// The curves of one array of the shape (N, 2), or of several.
std::vector<std::vector<matching::Point>> curves_of(const py::object& curves);

/// An array of the shape (N, 2).
Array array_of(const std::vector<matching::Point>& points);

/// A one-dimensional array.
Array array_of(const std::vector<double>& numbers);

/// The numbers of an array of any shape, flattened.
std::vector<double> numbers_of(const py::handle& array, const std::string& name);

}  // namespace tessera::python
