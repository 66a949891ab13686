// Options whose argument is a list with commas: --size 1200,900. A list of CLI11 would also take the arguments that
// follow, such as the next option or the input file; these options take one argument.
#pragma once

#include <CLI/CLI.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/split_text.h"

namespace tessera {

struct ListOption {
  std::string type_name;      // shown in help and errors as what is allowed: "W,H"
  std::size_t count = 0;      // number of values; 0: one or more, and the option may be repeated
  CLI::Validator value = {};  // checks each value
};

/// Appends the values of `text`. Throws CLI::ValidationError where `text` is not such a list.
template <class Value>
void append_list(const std::string& option, const std::string& text, const ListOption& kind,
                 std::vector<Value>& values) {
  const auto refuse = [&] { throw CLI::ValidationError(option, "found " + text + ", allowed: " + kind.type_name); };
  const std::vector<std::string_view> parts = split_outside(text, ',');
  if (kind.count > 0 && parts.size() != kind.count) refuse();
  for (const std::string_view part : parts) {
    const std::string word(part);
    Value value{};
    if (word.empty() || !CLI::detail::lexical_cast(word, value)) refuse();
    if (const std::string problem = kind.value(word); !problem.empty()) throw CLI::ValidationError(option, problem);
    values.push_back(value);
  }
}

/// Adds the option; `take` receives the values where the option is given.
template <class Value>
CLI::Option* add_list_option(CLI::App& app, const std::string& name, std::function<void(std::vector<Value>)> take,
                             const std::string& meaning, const ListOption& kind) {
  const auto read = [take = std::move(take), name, kind](const CLI::results_t& texts) {
    std::vector<Value> values;
    for (const std::string& text : texts) append_list(name, text, kind, values);
    take(std::move(values));
    return true;
  };
  CLI::Option* option = app.add_option(name, read, meaning)->type_name(kind.type_name);
  return kind.count == 0 ? option->take_all() : option;
}

template <class Value>
CLI::Option* add_list_option(CLI::App& app, const std::string& name, std::vector<Value>& values,
                             const std::string& meaning, const ListOption& kind) {
  return add_list_option<Value>(
      app, name, [&values](std::vector<Value> given) { values = std::move(given); }, meaning, kind);
}

}  // namespace tessera
