// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An option whose value is one of several words.

#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace detent::playback {

/// `names` and `target` must outlive the parse. --help lists the words; another word is wrong usage.
template <class Enum>
CLI::Option* addChoice(CLI::App& app, const std::string& name, Enum& target,
                       const std::map<std::string, Enum>& names, const std::string& help,
                       const std::string& standard) {
  std::string words;
  std::vector<std::string> known;
  for (const auto& [word, value] : names) {
    words += (words.empty() ? "" : "|") + word;
    known.push_back(word);
  }
  const auto take = [&target, &names](const std::string& word) { target = names.at(word); };
  CLI::Validator isKnown = CLI::IsMember(known);
  isKnown.description("");
  return app.add_option_function<std::string>(name, take, help)
      ->check(isKnown)
      ->type_name(words)
      ->default_str(standard);
}

}  // namespace detent::playback
