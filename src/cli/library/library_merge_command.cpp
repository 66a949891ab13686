#include "cli/library/library_merge_command.h"

#include <memory>
#include <string>

#include "cli/library/library_output.h"

namespace tessera::cli {
namespace {

constexpr char kLibraryMergeExamples[] =
    "Examples:\n"
    "  tessera library merge animals.h5 birds.h5 -o zoo.h5\n"
    "Nothing is traced again. A shape with the outline and colour of an earlier one is left out and listed; shapes "
    "with the\n"
    "same outline in other colours are variants of the first. A name that exists already gets the folder of its "
    "artwork:\n"
    "\"cat (birds)\". The libraries must have been built with the same --pad-levels and --delta-tau. A job can also "
    "read\n"
    "several libraries without merging them: library.files in docs/job-format.md.";

struct MergeArguments {
  LibraryChoice choice;
  std::string output;
};

int run(const MergeArguments& arguments) {
  copy_to_library(arguments.choice, arguments.output);
  return 0;
}

}  // namespace

void add_library_merge_command(CLI::App& library, Command& selected) {
  const auto arguments = std::make_shared<MergeArguments>();
  CLI::App* merge = library.add_subcommand("merge", "Make one library of several");
  merge->footer(kLibraryMergeExamples);
  merge->add_option("LIBRARY", arguments->choice.files, "The libraries, two or more, in the order of their shapes")
      ->required()
      ->expected(2, -1)
      ->type_name("LIB.h5");
  merge->add_option("-o,--output", arguments->output, "The library file to write, replaced if it exists")
      ->required()
      ->type_name("OUT.h5");
  merge->callback([arguments, &selected] { selected.run = [arguments] { return run(*arguments); }; });
}

}  // namespace tessera::cli
