#include "program/parsed_command.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "terminal/exit_codes.h"
#include "terminal/terminal.h"

namespace tessera {
namespace {

/// The command line as far as it was understood: "tessera library build".
std::string understood_command(const CLI::App& app) {
  std::string text = app.get_name();
  for (const CLI::App* sub : app.get_subcommands()) text += " " + understood_command(*sub);
  return text;
}

std::vector<const CLI::App*> with_all_below(const CLI::App& app) {
  std::vector<const CLI::App*> all = {&app};
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    const std::vector<const CLI::App*> below = with_all_below(*sub);
    all.insert(all.end(), below.begin(), below.end());
  }
  return all;
}

/// Finds an option that was taken for a value: CLI11 takes whatever follows "--out", even the next option. The message,
/// or empty where nothing is wrong.
std::string swallowed_option(const CLI::App& app, const std::vector<std::string>& words) {
  const std::vector<const CLI::App*> commands = with_all_below(app);
  const auto is_option = [&](const std::string& text) {
    return text.starts_with('-') && std::find(words.begin(), words.end(), text) != words.end() &&
           std::any_of(commands.begin(), commands.end(),
                       [&](const CLI::App* command) { return command->get_option_no_throw(text) != nullptr; });
  };
  for (const CLI::App* command : commands) {
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_positional()) continue;
      const std::vector<std::string> values = option->results();
      const auto swallowed = std::find_if(values.begin(), values.end(), is_option);
      if (swallowed == values.end()) continue;
      const std::string name = option->get_name();
      return name + ": found the option " + *swallowed +
             ", allowed: a value; for a value that begins like an option: " + name + "=" + *swallowed;
    }
  }
  return "";
}

/// A better message where a value is not a number: CLI11 says neither what is wrong nor what is allowed.
std::string conversion_problem(const std::string& problem) {
  constexpr std::string_view kBeginning = "Could not convert: ", kBetween = " = ";
  const std::size_t between = problem.find(kBetween);
  if (!problem.starts_with(kBeginning) || between == problem.npos) return problem;
  const std::string option = problem.substr(kBeginning.size(), between - kBeginning.size());
  const std::string value = problem.substr(between + kBetween.size());
  double number = 0;
  const bool is_number = CLI::detail::lexical_cast(value, number);
  return option + ": found " + value + ", allowed: a " + (is_number ? "whole number that is not too large" : "number");
}

/// The message for an error of CLI11. `words`: the command line.
std::string parse_problem(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& words) {
  if (const std::string problem = swallowed_option(app, words); !problem.empty()) return problem;
  const std::vector<std::string> not_understood = app.remaining(true);
  const bool lacks_command = dynamic_cast<const CLI::RequiredError*>(&error) && !not_understood.empty();
  return lacks_command ? "unknown command or option " + not_understood.front() : conversion_problem(error.what());
}

/// The --time-limit of the given sub-command, if any.
std::optional<std::string> given_time_limit(const CLI::App& app) {
  for (const CLI::App* sub : app.get_subcommands()) {
    const CLI::Option* limit = sub->get_option_no_throw("--time-limit");
    return limit && limit->count() > 0 ? std::optional(limit->results().back()) : given_time_limit(*sub);
  }
  return std::nullopt;
}

/// The arguments for CLI11, last first. After an empty "--time-limit=" CLI11 would take the next argument, perhaps the
/// job file, for the value.
std::vector<std::string> reversed_arguments(int argc, char** argv) {
  constexpr std::string_view kEmptyLimit = "--time-limit=";
  std::vector<std::string> arguments;
  for (int i = argc - 1; i > 0; --i) {
    if (argv[i] == kEmptyLimit) arguments.push_back("");
    arguments.push_back(argv[i] == kEmptyLimit ? "--time-limit" : argv[i]);
  }
  return arguments;
}

}  // namespace

Command parsed_command(CLI::App& app, Command& selected, int argc, char** argv) {
  const std::vector<std::string> words(argv, argv + argc);
  try {
    app.parse(reversed_arguments(argc, argv));
    if (const std::string problem = swallowed_option(app, words); !problem.empty()) throw CLI::ParseError(problem, 1);
    selected.time_limit = given_time_limit(app);
    return selected;
  } catch (const CLI::ParseError& error) {  // CLI11 reports --help and --version as errors, too
    if (error.get_exit_code() != 0)
      throw InputError(parse_problem(app, error, words) + " (see " + understood_command(app) + " --help)");
    std::ostringstream help;
    app.exit(error, help);
    return {.run = [text = help.str()] {
      print_lines(text);
      return kDoneExitCode;
    }};
  }
}

}  // namespace tessera
