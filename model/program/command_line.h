// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Shared code of the programs' command lines. CLI11's types are template parameters, because a header shared
// by rooms includes no library.

#include <cstddef>
#include <cstdio>
#include <set>
#include <string>
#include <string_view>

#include "model/named_values.h"
#include "model/number_table.h"
#include "model/result.h"
#include "model/text.h"

namespace detent {

/// CLI11's help with readable values: "--jobs 1..1024=4", "--gain NUMBER" instead of "INT:INT in [1 -
/// 1024]=4" and "FLOAT". Formatter: CLI::Formatter, Option: CLI::Option. Call it before adding subcommands.
template <class Formatter, class Option>
class PlainHelp : public Formatter {
 public:
  PlainHelp() {
    this->label("INT", "N");
    this->label("UINT", "N");
    this->label("FLOAT", "NUMBER");
  }
  std::string make_option_opts(const Option* option) const override {
    std::string options = Formatter::make_option_opts(option);
    for (const std::string_view type : {" INT:", " UINT:", " FLOAT:"})
      if (options.starts_with(type)) return " " + options.substr(type.size());
    return options;
  }
};

/// Exit code of a program whose work ended with `exitCode`: 1, with a line on standard error, if standard output
/// lost part of a good result.
inline int codeAfterOutput(int exitCode) {
  if ((std::fflush(stdout) == 0 && std::ferror(stdout) == 0) || exitCode != 0) return exitCode;
  std::fputs("standard output cannot be written. Check the disk or the pipe.\n", stderr);
  return static_cast<int>(FailureCode::internalFault);
}

/// A number from `low` to `high`, both included. CLI::Range would accept "nan". Validator: CLI::Validator.
template <class Validator>
Validator numberWithin(double low, double high) {
  const std::string range = shortestText(low) + ".." + shortestText(high);
  return Validator(
      [low, high, range](std::string& text) {
        const auto value = numberFrom(text);
        if (value && *value >= low && *value <= high) return std::string();
        return text + " is not a number from " + range;
      },
      range);
}

/// An option with one of several words as its value, in either case; --help lists them, other words are wrong
/// usage. App: CLI::App. Target: Enum, or an optional of it if there is no `standard`. `names` and `target`
/// must outlive the parse.
template <class App, class Target, class Enum, std::size_t count>
auto addChoice(App& app, const std::string& name, Target& target, const NamedValues<Enum, count>& names,
               const std::string& help, const std::string& standard) {
  std::set<std::string> sorted;
  for (const auto& named : names.all) sorted.insert(named.word);
  std::string words;
  for (const std::string& word : sorted) words += (words.empty() ? "" : "|") + word;
  const auto known = [&names, words](const std::string& word) {
    return names.value(lowered(word)) ? std::string() : word + " is none of " + words;
  };
  const auto take = [&target, &names](const std::string& word) { target = *names.value(lowered(word)); };
  return app.template add_option_function<std::string>(name, take, help)
      ->check(known)
      ->type_name(words)
      ->default_str(standard);
}

}  // namespace detent
