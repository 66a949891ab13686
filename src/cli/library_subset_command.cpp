#include "cli/library_subset_command.h"

#include <memory>
#include <string>

#include "cli/library_output.h"
#include "core/base/error.h"

namespace tessera::cli {
namespace {

constexpr char kExamples[] =
    "Examples:\n"
    "  tessera library subset animals.h5 --include 'cat*' 'dog*' --exclude '*bird*' -o pets.h5\n"
    "  tessera library info animals.h5 --names                       what the names are\n"
    "GLOB is a pattern as the shell has them, compared with the whole name, case told: * any characters, ? one, [ab] "
    "one\n"
    "of these. Quote it, or the shell takes it for files. A job can also choose by itself: library.include and\n"
    "library.exclude in docs/job-format.md.";

struct CopyArguments {
  io::LibraryChoice choice;
  std::string output;
};

int run(const CopyArguments& arguments) {
  if (arguments.choice.names.empty())
    throw InputError("library subset: nothing is chosen; needed: --include or --exclude");
  copy_to_library(arguments.choice, arguments.output);
  return 0;
}

}  // namespace

void add_library_subset_command(CLI::App& library, Command& selected) {
  const auto arguments = std::make_shared<CopyArguments>();
  CLI::App* subset = library.add_subcommand("subset", "Make a library of some shapes of another");
  subset->footer(kExamples);
  subset->add_option("LIBRARY", arguments->choice.files, "The library file")
      ->required()
      ->expected(1)
      ->type_name("LIB.h5");
  subset->add_option("--include", arguments->choice.names.include, "Shapes with such names; default: all")
      ->type_name("GLOB");
  subset->add_option("--exclude", arguments->choice.names.exclude, "But not those with such names")->type_name("GLOB");
  subset->add_option("-o,--output", arguments->output, "The library file to write, replaced if it exists")
      ->required()
      ->type_name("OUT.h5");
  subset->callback([arguments, &selected] { selected.run = [arguments] { return run(*arguments); }; });
}

}  // namespace tessera::cli
