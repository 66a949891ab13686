#include <memory>
#include <string>

#include "cli/commands.h"
#include "job/key_reference.h"
#include "terminal/exit_codes.h"
#include "terminal/terminal.h"

namespace tessera::cli {
namespace {

constexpr const char* kKeysExamples =
    "Examples:\n"
    "  tessera keys                         all keys, table by table\n"
    "  tessera keys pieces                  those of the table [pieces]\n"
    "  tessera keys shapes                  what each of [[shapes]] may have\n"
    "  tessera keys pieces.scale_px         all about one key\n"
    "  tessera keys | grep -i colour        keys that have to do with colours\n"
    "  tessera keys --markdown > keys.md    as a page\n"
    "A job file gives a key as NAME = VALUE below its [TABLE]; --set TABLE.NAME=VALUE gives it on the command line.\n"
    "docs/job-format.md explains each table.";

struct KeysArguments {
  std::string name;
  bool markdown = false;
};

}  // namespace

void add_keys_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<KeysArguments>();
  CLI::App* keys = app.add_subcommand("keys", "List the keys of a job: type, unit, allowed values, default, meaning");
  keys->footer(kKeysExamples);
  keys->add_option("NAME", arguments->name, "A table or a key; default: all keys")->type_name("TABLE|KEY");
  keys->add_flag("--markdown", arguments->markdown, "Print Markdown");
  keys->callback([arguments, &selected] {
    selected.run = [arguments] {
      const ReferenceForm form = arguments->markdown ? ReferenceForm::markdown : ReferenceForm::text;
      print_lines(key_reference(arguments->name, form));
      return kDoneExitCode;
    };
  });
}

}  // namespace tessera::cli
