// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/program/confusion_command.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "model/edits.h"
#include "model/file/button_file.h"
#include "playback/program/json_output.h"
#include "playback/program/shared_options.h"
#include "playback/study/perception/design_help.h"
#include "playback/study/perception/forecast_words.h"

namespace detent::playback {

namespace {

struct ConfusionArguments {
  std::vector<std::string> buttons;
  FeelOptions feel;
  bool suggest = false, json = false;
};

Result<std::vector<Button>> readAll(const std::vector<std::string>& files) {
  std::vector<Button> buttons;
  for (const std::string& file : files) {
    Result<Button> button = readButtonFile(file);
    if (!button) return button.failure();
    if (button->name().empty()) button = rename(*button, std::filesystem::path(file).filename().string());
    if (!button) return button.failure();
    buttons.push_back(*std::move(button));
  }
  return buttons;
}

Result<PerceptionSettings> perceptionOf(const ConfusionArguments& a) {
  PerceptionSettings settings;
  settings.playback = a.feel.settings;
  if (a.feel.profileFile.empty()) return settings;
  Result<DeviceProfile> profile = profileOf(a.feel.profileFile);
  if (!profile) return profile.failure();
  settings.device = *std::move(profile);
  return settings;
}

const char* confusionWord(Verdict verdict) {
  if (verdict == Verdict::distinguished) return "told apart";
  return verdict == Verdict::notDistinguished ? "not told apart" : "undecided";
}

Json jsonOf(const std::string& a, const std::string& b, const PredictedPair& pair, const PairRank& rank) {
  return {{"a", a},
          {"b", b},
          {"d_prime", pair.dPrime},
          {"errors_per_90", pair.errorsPer90()},
          {"errors_low", pair.leastErrorsPer90()},
          {"errors_high", pair.mostErrorsPer90()},
          {"verdict", confusionWord(pair.verdict())},
          {"probability_apart", pair.probabilityApart},
          {"rank", rank.rank},
          {"more_confused_than_next",
           rank.moreConfusedThanNext ? Json(*rank.moreConfusedThanNext) : Json(nullptr)},
          {"reason", english(reasonOf(pair))}};
}

void sayConfusion(const std::string& a, const std::string& b, const PredictedPair& pair) {
  std::fprintf(stderr, "%s | %s: %s; %s (d' %.1f)\n", a.c_str(), b.c_str(), english(verdictOf(pair)).c_str(),
               english(reasonOf(pair)).c_str(), pair.dPrime);
}

/// Prints the pairs from the most confused to the least, each with the probability that it is more confused
/// than the next.
void sayOrder(const std::vector<FeltButton>& felt, const std::vector<PairRank>& ranks) {
  if (ranks.size() < 2) return;
  std::vector<std::string> lines(ranks.size());
  std::size_t at = 0;
  for (std::size_t second = 1; second < felt.size(); ++second)
    for (std::size_t first = 0; first < second; ++first, ++at) {
      std::string& line = lines[ranks[at].rank - 1] = felt[first].name + " | " + felt[second].name;
      if (const auto& probability = ranks[at].moreConfusedThanNext)
        line += " (" + std::to_string(std::lround(100 * *probability)) + " %)";
    }
  std::fprintf(
      stderr,
      "Most confused first; in brackets how likely it is that a pair is more confused than the next:\n");
  for (const std::string& line : lines) std::fprintf(stderr, "  %s\n", line.c_str());
}

const char* confusionName(Lever lever) {
  if (lever == Lever::snap) return "snap ratio";
  return lever == Lever::travel ? "travel" : "force";
}

int suggest(const Button& button, const Button& other, const PerceptionSettings& perception,
            const Cancelled& cancelled) {
  DesignHelpSettings settings;
  settings.perception = perception;
  Result<std::vector<Suggestion>> found = makeDistinguishable(button, other, settings, cancelled);
  if (!found) return fail(found.failure());
  if (found->empty())
    std::fprintf(stderr, "  no single change of up to a factor 4 is sure to tell them apart\n");
  for (const Suggestion& s : *found)
    std::fprintf(stderr, "  %s of \"%s\" x %.2f: %s\n", confusionName(s.lever), button.name().c_str(),
                 s.factor, english(errorsOf(s.forecast)).c_str());
  return 0;
}

int runConfusion(const ConfusionArguments& a, const Cancelled& cancelled) {
  Result<std::vector<Button>> buttons = readAll(a.buttons);
  if (!buttons) return fail(buttons.failure());
  Result<PerceptionSettings> settings = perceptionOf(a);
  if (!settings) return fail(settings.failure());
  std::vector<FeltButton> felt;
  for (const Button& button : *buttons) {
    Result<FeltButton> one = feel(button, *settings, cancelled);
    if (!one) return fail(one.failure());
    felt.push_back(*std::move(one));
  }
  const std::vector<PredictedPair> pairs =
      predictAll(felt, [&](std::size_t, std::size_t) { return !cancelled(); });
  if (pairs.empty())
    return fail({FailureCode::wrongUsage, "confusion", "", "was cancelled", "Start it again"});
  const std::vector<PairRank> ranks = ranksOf(pairs);
  Json list = Json::array();
  std::size_t at = 0;
  for (std::size_t second = 1; second < felt.size(); ++second) {
    for (std::size_t first = 0; first < second; ++first, ++at) {
      list.push_back(jsonOf(felt[first].name, felt[second].name, pairs[at], ranks[at]));
      sayConfusion(felt[first].name, felt[second].name, pairs[at]);
      if (!a.suggest || pairs[at].distinguished()) continue;
      if (const int code = suggest((*buttons)[second], (*buttons)[first], *settings, cancelled); code != 0)
        return code;
    }
  }
  sayOrder(felt, ranks);
  if (a.json) print({{"pairs", list}});
  return 0;
}

}  // namespace

std::string pairJson(const std::string& a, const std::string& b, const PredictedPair& pair,
                     const PairRank& rank) {
  return jsonText(jsonOf(a, b, pair, rank));
}

void addConfusionCommand(CLI::App& program, Action& chosen) {
  CLI::App* app = program.add_subcommand(
      "confusion",
      "Forecast whether people tell these buttons apart (docs/reference/predicted-confusion.md)");
  const auto a = std::make_shared<ConfusionArguments>();
  app->add_option("BUTTON", a->buttons, "*.button.json, at least two")->required()->expected(2, 1000);
  app->add_flag("--suggest", a->suggest, "Suggest the smallest change that makes a pair distinguishable");
  addFeelOptions(*app, a->feel);
  app->add_flag("--json", a->json, "One JSON object on stdout");
  app->callback(
      [&chosen, a] { chosen = [a](const Cancelled& cancelled) { return runConfusion(*a, cancelled); }; });
}

}  // namespace detent::playback
