#include "cli/library/library_subset_command.h"

#include <memory>
#include <string>

#include "cli/library/library_output.h"
#include "core/base/error.h"

namespace tessera::cli {
namespace {

constexpr char kLibrarySubsetExamples[] =
    "Examples:\n"
    "  tessera library subset animals.h5 --include 'cat*' --include 'dog*' --exclude '*bird*' -o pets.h5\n"
    "  tessera library subset clipart.h5 --style-like owl --closest 200 -o like_the_owl.h5\n"
    "  tessera library info animals.h5 --names                       what the names are\n"
    "  tessera library styles clipart.h5 --sheet styles.png          what styles there are\n"
    "GLOB is a pattern like those of the shell, compared with the whole name: * any characters, ? one, [ab] one of "
    "these;\n"
    "upper and lower case differ. A name that is the pattern letter by letter wins. Quote the pattern, or the shell "
    "takes\n"
    "it for files. A job can also choose shapes: library.include and library.exclude in docs/job-format.md.";

struct SubsetArguments {
  LibraryChoice choice;
  std::string output;
};

int run(const SubsetArguments& arguments) {
  const StyleChoice& style = arguments.choice.style;
  if (arguments.choice.names.empty() && style.like.empty())
    throw InputError("library subset: nothing is chosen; needed: --include, --exclude or --style-like");
  if (!style.like.empty() && !style.closest && !style.within)
    throw InputError("--style-like: found alone; needed: --closest or --style-within");
  copy_to_library(arguments.choice, arguments.output);
  return 0;
}

}  // namespace

void add_library_subset_command(CLI::App& library, Command& selected) {
  const auto arguments = std::make_shared<SubsetArguments>();
  CLI::App* subset = library.add_subcommand("subset", "Make a library of some shapes of another");
  subset->footer(kLibrarySubsetExamples);
  subset
      ->add_option_function<std::string>(
          "LIBRARY", [arguments](const std::string& file) { arguments->choice.files = {file}; }, "The library file")
      ->required()
      ->type_name("LIB.h5");
  const auto add_globs = [&](const char* option, std::vector<std::string>& globs, const char* meaning) {
    return subset->add_option(option, globs, meaning)->type_name("GLOB")->allow_extra_args(false)->take_all();
  };
  add_globs("--include", arguments->choice.names.include, "Shapes with such names; may be repeated; default: all");
  add_globs("--exclude", arguments->choice.names.exclude, "Leave out shapes with such names; may be repeated");
  StyleChoice& style = arguments->choice.style;
  CLI::Option* like = add_globs("--style-like", style.like,
                                "Shapes drawn like this one; may be repeated; auto: the style that prevails");
  subset->add_option("--closest", style.closest, "Number of shapes, the nearest in style")
      ->needs(like)
      ->check(CLI::Range(1, 4'000'000))
      ->type_name("N");
  subset->add_option("--style-within", style.within, "Shapes up to this style distance: 1 is similar, 4 is different")
      ->needs(like)
      ->check(CLI::Range(0., 100.))
      ->type_name("D");
  subset->add_option("-o,--output", arguments->output, "The library file to write, replaced if it exists")
      ->required()
      ->type_name("OUT.h5");
  subset->callback([arguments, &selected] { selected.run = [arguments] { return run(*arguments); }; });
}

}  // namespace tessera::cli
