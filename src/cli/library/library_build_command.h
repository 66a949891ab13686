// tessera library build: reads artwork files, writes a library file and a table of what could not be used.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "library/library_builder.h"
#include "program/command.h"

namespace tessera::cli {

struct BuildArguments {
  std::vector<std::string> sources;  // folders and files, as find_artwork takes them
  std::string output;                // the library file, replaced if it exists
  std::string glob;
  LibraryBuildSettings settings;
  bool quiet = false;  // prints neither progress nor what was left out
};

/// Builds the library and the list of what was left out. Throws InputError where a source or the output cannot be used,
/// and where no shape is found; EnvironmentError.
void build_library_file(const BuildArguments& arguments);

void add_library_build_command(CLI::App& library, Command& selected);

}  // namespace tessera::cli
