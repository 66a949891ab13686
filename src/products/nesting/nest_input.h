// What is to be nested, whatever files it comes from.
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
  std::string other_name;  // that finds it, too: of a file with a single drawing its own or the file's; empty: none
  int number = 0;          // in the input, the first being 0
  int demand = 1;
  std::vector<double> angles_deg;  // of an instance; empty: those of the command
  double mm_per_shape = 0;         // of a library's shape: its unit; 0: not of a library
};

/// The sheets of an instance.
struct NestBin {
  double width = 0, height = 0;  // mm
  int stock = 0;                 // how many there are; 0: the instance does not say it
};

struct NestInput {
  std::string name;                 // of the file or folder
  std::vector<NestSource> sources;  // of different names
  double strip_height = 0;          // of an instance; 0: none
  std::optional<NestBin> bin;       // of an instance
  std::string library;              // the file, where the input is one
  std::string unit;                 // what one unit of the input was taken as, for people; empty: it says its own
  std::vector<std::string> notes;   // what was left out, for people
};

/// How many points all pieces have together.
std::size_t points_to_cut(const NestInput& input);

/// How an input is read.
struct NestReading {
  std::optional<double> px_per_inch;  // of SVGs; nothing: CSS's 96
  std::vector<std::string> left_out;  // names of an SVG's elements that are not cut
};

/// An instance (.json), an SVG (.svg, .svgz), a DXF, a library (.h5), or a folder of SVGs and DXFs. SVGs are
/// drawn in a process with limits (drawers.h). Throws InputError.
NestInput read_nest_input(const std::string& path, const NestReading& reading = {});

/// Sets the number of pieces of each name, by patterns with * and ?, the last that fits; 0 leaves it out. A pattern that
/// fits no name is looked for among the other names. Throws InputError where it fits none of these, either.
void set_demands(NestInput& input, const std::vector<std::pair<std::string, int>>& demands);

}  // namespace tessera
