// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/program/between_command.h"

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include "model/file/button_file.h"
#include "model/program/command_line.h"
#include "playback/program/json_output.h"
#include "playback/program/number_option.h"
#include "playback/study/perception/middle.h"

namespace detent::playback {

namespace {

struct BetweenArguments {
  std::string from, to, out;
  std::optional<double> share;
  bool json = false;
};

int runBetween(const BetweenArguments& a, const Cancelled& cancelled) {
  const auto from = readButtonFile(a.from);
  if (!from) return fail(from.failure());
  const auto to = readButtonFile(a.to);
  if (!to) return fail(to.failure());
  const auto place = a.share ? placeBetween(*from, *to, *a.share, cancelled)
                             : perceptualMiddle(*from, *to, {}, {}, cancelled);
  if (!place) return fail(place.failure());
  if (auto written = writeButtonFile(a.out, place->button); !written) return fail(written.failure());
  std::fprintf(stderr, "%s: %.1f %% of the way; forecast d' %.2f from %s, %.2f from %s\n", a.out.c_str(),
               100 * place->share, place->dPrimeFrom, a.from.c_str(), place->dPrimeTo, a.to.c_str());
  if (!a.share && !place->equal())
    std::fprintf(stderr, "warning: no place between the two has equal halves; this one is nearest to it\n");
  if (a.json)
    print({{"output", a.out},
           {"share", place->share},
           {"d_prime_from", place->dPrimeFrom},
           {"d_prime_to", place->dPrimeTo},
           {"equal_halves", place->equal()}});
  return 0;
}

}  // namespace

void addBetweenCommand(CLI::App& program, Action& chosen) {
  CLI::App* app = program.add_subcommand(
      "between",
      "Make the button between two others; by default the one that is forecast to differ equally from both");
  const auto a = std::make_shared<BetweenArguments>();
  app->add_option("FROM", a->from, "*.button.json")->required();
  app->add_option("TO", a->to, "*.button.json")->required();
  app->add_option("-o,--output", a->out, "*.button.json to write")->required();
  app->add_option("--at", a->share, "Share of the way instead, 0 (FROM) to 1 (TO)")
      ->check(numberWithin(0, 1));
  app->add_flag("--json", a->json, "One JSON object on stdout");
  app->callback(
      [&chosen, a] { chosen = [a](const Cancelled& cancelled) { return runBetween(*a, cancelled); }; });
}

}  // namespace detent::playback
