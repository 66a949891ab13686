#include "cli/library/library_styles_command.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cli/library/library_info_command.h"
#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/style/style_groups.h"
#include "library/storage/library_file.h"
#include "library/style_reference.h"
#include "library/style_sheet.h"
#include "terminal/terminal.h"
#include "text/number_text.h"
#include "text/utf8_text.h"

namespace tessera::cli {
namespace {

constexpr char kLibraryStylesExamples[] =
    "Examples:\n"
    "  tessera library styles clipart.h5                        what styles there are\n"
    "  tessera library styles clipart.h5 --sheet styles.png     see them: a group after the other\n"
    "  tessera library styles clipart.h5 --names | grep '^3'    the drawings of group 3, the typical one first\n"
    "  tessera library subset clipart.h5 --style-like owl --closest 200 -o owls_style.h5\n"
    "A job keeps a collage in one style by [style] in docs/job-format.md.";

struct StylesArguments {
  std::string library;
  std::string sheet;
  std::size_t groups = kStyleGroups;
  bool names = false;
};

/// The styles of a library's drawings, with the drawings' names.
struct Styles {
  std::vector<std::string> names;
  std::vector<StyleFeatures> features;
  std::vector<StylePlace> places;
};

Styles styles_of(const LibraryFile& library) {
  constexpr std::size_t kHeadsAtATime = 1024;
  Styles styles;
  for (std::size_t at = 0; at < library.size(); at += kHeadsAtATime) {
    for (const ShapeHead& head : library.heads(at, std::min(library.size(), at + kHeadsAtATime))) {
      if (!head.style.known()) throw InputError(unknown_style_text(library.path(), head.name));
      styles.names.push_back(head.name);
      styles.features.push_back(head.style);
      styles.places.push_back(style_place(head.style));
    }
  }
  return styles;
}

void print_table(const Styles& styles, const std::vector<StyleGroup>& groups) {
  print_line("group  drawings  line width %%  outlined %%  colours  chroma  texture  shaded %%  detail %%  typical");
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::vector<std::uint32_t>& members = groups[g].members;
    const auto mean = [&](float StyleFeatures::*number) {
      double sum = 0;
      for (const std::uint32_t i : members) sum += double(styles.features[i].*number);
      return sum / double(members.size());
    };
    print_line("%5zu  %8zu  %12.1f  %10.0f  %7.1f  %6.0f  %7.2f  %8.0f  %8.0f  %s", g + 1, members.size(),
               100 * mean(&StyleFeatures::line_width), 100 * mean(&StyleFeatures::outlined),
               std::exp2(mean(&StyleFeatures::palette)), mean(&StyleFeatures::chroma), mean(&StyleFeatures::texture),
               100 * mean(&StyleFeatures::shading), 100 * mean(&StyleFeatures::detail),
               styles.names[members.front()].c_str());
  }
}

void print_names(const Styles& styles, const std::vector<StyleGroup>& groups) {
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const StylePlace& typical = styles.places[groups[g].members.front()];
    for (const std::uint32_t i : groups[g].members) {
      const std::string distance = fixed(double(style_distance(styles.places[i], typical)), 2);
      print_lines(std::to_string(g + 1) + "\t" + distance + "\t" + printable_utf8(styles.names[i]) + "\n");
    }
  }
}

int run(const StylesArguments& arguments) {
  check_sheet(arguments.sheet);
  const LibraryFile library(arguments.library);
  const Styles styles = styles_of(library);
  const std::vector<StyleGroup> groups = style_groups(styles.places, arguments.groups);
  if (arguments.names) {
    print_names(styles, groups);
    return 0;
  }
  print_table(styles, groups);
  if (arguments.sheet.empty()) return 0;
  const std::size_t shown = write_style_sheet(library, groups, arguments.sheet);
  print_lines("\n");
  print_line("%s: %s", arguments.sheet.c_str(), count_text(shown, "shape").c_str());
  return 0;
}

}  // namespace

void add_library_styles_command(CLI::App& library, Command& selected) {
  const auto arguments = std::make_shared<StylesArguments>();
  CLI::App* styles = library.add_subcommand("styles", "Sort a library's drawings by style");
  styles->footer(kLibraryStylesExamples);
  styles->add_option("LIBRARY", arguments->library, "The library file")->required()->type_name("LIB.h5");
  styles->add_option("--groups", arguments->groups, "Number of groups of similar style")
      ->check(CLI::Range(1, 64))
      ->capture_default_str()
      ->type_name("N");
  styles->add_option("--sheet", arguments->sheet, "Write a picture of the groups (PNG)")->type_name("SHEET.png");
  styles
      ->add_flag("--names", arguments->names,
                 "Print one line for each drawing instead: group, style distance from its typical one, name")
      ->excludes("--sheet");
  styles->callback([arguments, &selected] { selected.run = [arguments] { return run(*arguments); }; });
}

}  // namespace tessera::cli
