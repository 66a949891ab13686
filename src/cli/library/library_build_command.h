// tessera library build: artwork files in, a library file and a table of what could not be used out.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "library/library_builder.h"
#include "program/command.h"

namespace tessera::cli {

struct BuildArguments {
  std::vector<std::string> sources;  // as find_artwork takes them
  std::string output;                // the library file, replaced if it exists
  std::string glob;
  LibraryBuildSettings settings;
  bool quiet = false;  // neither progress nor what was left out
};

/// Builds the library and the list of what was left out. Throws InputError where a source or the output is of no use, and
/// where no shape is found; EnvironmentError.
void build_library_file(const BuildArguments& arguments);

void add_library_build_command(CLI::App& library, Command& selected);

}  // namespace tessera::cli
