#include "cli/library/library_build_command.h"
#include "cli/library/library_extract_command.h"
#include "cli/library/library_info_command.h"
#include "cli/library/library_merge_command.h"
#include "cli/library/library_styles_command.h"
#include "cli/library/library_subset_command.h"

namespace tessera::cli {

void add_library_command(CLI::App& app, Command& selected) {
  CLI::App* library = app.add_subcommand(
      "library", "Build a library of shapes from artwork or photos, look into one, merge some, choose from one");
  library->require_subcommand(1);
  add_library_build_command(*library, selected);
  add_library_extract_command(*library, selected);
  add_library_info_command(*library, selected);
  add_library_merge_command(*library, selected);
  add_library_subset_command(*library, selected);
  add_library_styles_command(*library, selected);
}

}  // namespace tessera::cli
