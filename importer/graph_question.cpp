// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/graph_question.h"

#include <array>
#include <span>
#include <utility>

namespace detent::importer {
namespace {

std::string textOf(const PlotSwitch& each, std::size_t number) {
  const std::string color = nameOf(each.pressColor);
  return each.name.empty() ? "curve " + std::to_string(number) + " (" + color + ")"
                           : each.name + " (" + color + ")";
}

Question whichSwitch(const std::vector<PlotSwitch>& switches) {
  Question question{"which switch should be read", {}};
  for (std::size_t i = 0; i < switches.size(); ++i)
    question.choices.push_back({textOf(switches[i], i + 1), "--curve " + std::to_string(i + 1)});
  return question;
}

Question whichUnit(bool ofForce) {
  constexpr std::array forces{"N", "gf", "cN", "mN", "kgf", "lbf", "ozf"};
  constexpr std::array lengths{"mm", "um", "in", "mil"};
  Question question{std::string("the unit of ") + (ofForce ? "force" : "displacement"), {}};
  for (const char* unit :
       ofForce ? std::span<const char* const>(forces) : std::span<const char* const>(lengths))
    question.choices.push_back({unit, std::string(ofForce ? "--y-unit " : "--x-unit ") + unit});
  return question;
}

Question whichIsPress(const std::vector<CurveTrace>& traces) {
  Question question{"which curve is the press", {}};
  for (const auto& [press, release] : {std::pair(0, 1), std::pair(1, 0)}) {
    const std::string pressColor = nameOf(traces[static_cast<std::size_t>(press)].color),
                      releaseColor = nameOf(traces[static_cast<std::size_t>(release)].color);
    Choice choice{pressColor, "--press-color "};
    choice.option.append(pressColor).append(" --release-color ").append(releaseColor);
    question.choices.push_back(std::move(choice));
  }
  return question;
}

}  // namespace

std::optional<Question> questionAbout(const Failure& failure, const GraphEvidence* evidence) {
  if (failure.code != FailureCode::notCertain) return {};
  if (failure.reason == nameOf(DoubtCode::severalSwitches) && evidence && evidence->switches.size() > 1)
    return whichSwitch(evidence->switches);
  if (failure.reason == nameOf(DoubtCode::unitMissing)) {
    const bool x = failure.remedies.include(RemedyKind::giveXUnit),
               y = failure.remedies.include(RemedyKind::giveYUnit);
    if (x != y) return whichUnit(y);
  }
  const bool mayBeExchanged = failure.reason == nameOf(DoubtCode::strokesAlike) ||
                              failure.reason == nameOf(DoubtCode::releaseAbovePress);
  if (mayBeExchanged && evidence && evidence->traces.size() == 2 &&
      evidence->traces[0].color != evidence->traces[1].color)
    return whichIsPress(evidence->traces);
  return {};
}

}  // namespace detent::importer
