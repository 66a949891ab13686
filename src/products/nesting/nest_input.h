// The input of a nesting, from any kind of file.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "products/nesting/drawings/nest_contours.h"
#include "products/nesting/layout/nest_problem.h"

namespace tessera {

struct NestSource {
  NestDrawing drawing;
  // another name for patterns: in a file with one drawing, the drawing's or the file's; empty: none
  std::string other_name;
  int number = 0;  // number in the input, from 0
  int demand = 1;
  std::vector<double> angles_deg;  // of an instance; empty: those of the command
  double mm_per_shape = 0;         // unit of a library's shape; 0: not from a library
};

/// The sheets of an instance.
struct NestBin {
  double width = 0, height = 0;  // mm
  int stock = 0;                 // how many there are; 0: the instance does not say
};

struct NestInput {
  std::string name;                 // of the file or folder
  std::vector<NestSource> sources;  // with different names
  double strip_height = 0;          // of an instance; 0: none
  std::optional<NestBin> bin;       // of an instance
  std::string library;              // the library file, if that is the input
  std::string unit;                 // the assumed unit of the input, for people; empty: the input names its own
  std::vector<std::string> notes;   // what was left out, for people
};

/// The number of points of all pieces together.
std::size_t points_to_cut(const NestInput& input);

/// Options for reading an input.
struct NestReading {
  std::optional<double> px_per_inch;  // of SVGs; empty: CSS's 96
  std::vector<std::string> left_out;  // names of an SVG's elements that are not cut
};

/// Reads an instance (.json), an SVG (.svg, .svgz), a DXF, a library (.h5), or a folder of SVGs and DXFs. SVGs are drawn in
/// a process with limits (drawers.h). Throws InputError.
NestInput read_nest_input(const std::string& path, const NestReading& reading = {});

/// Sets the number of pieces by patterns of names (* and ?). The last pattern that fits a name counts; 0 leaves it out. A
/// pattern that fits no name is compared with the other names. Throws InputError where it fits none of these, either.
void set_demands(NestInput& input, const std::vector<std::pair<std::string, int>>& demands);

}  // namespace tessera
