// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/graph_question.h"

#include <array>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "importer/page/same_colour.h"

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
  Question question{"which curves are press and release", {}};
  const std::array colors{nameOf(traces[0].color), nameOf(traces[1].color)};
  for (const auto& [press, release] : {std::pair<std::size_t, std::size_t>(0, 1), {1, 0}})
    question.choices.push_back({"press " + colors[press] + ", release " + colors[release],
                                "--press-color " + colors[press] + " --release-color " + colors[release]});
  for (const std::string& color : colors)
    question.choices.push_back(
        {"press " + color + ", no release", "--press-color " + color + " --no-release"});
  return question;
}

/// The curves in other colours than the press, which a person gave.
Question whichIsRelease(const std::vector<CurveTrace>& traces, const ImportHints& hints) {
  Question question{"which curve is the release", {}};
  std::set<std::string> colors;
  for (const CurveTrace& trace : traces) {
    const bool isPress = trace.stroke == Stroke::press ||
                         (hints.trace.pressColor && isSameColour(trace.color, *hints.trace.pressColor));
    const std::string color = nameOf(trace.color);
    if (!isPress && colors.insert(color).second)
      question.choices.push_back({color, "--release-color " + color});
  }
  question.choices.push_back({"this button has no release", "--no-release"});
  return question;
}

/// Returns true for a failure that the choice of the curves may settle.
bool isOfCurves(const Failure& failure) {
  return failure.remedies.include(RemedyKind::pickRelease) ||
         failure.remedies.include(RemedyKind::drawPress) || failure.remedies.include(RemedyKind::noRelease);
}

}  // namespace

std::optional<Question> questionAbout(const Failure& failure, const GraphEvidence* evidence,
                                      const ImportHints& hints) {
  if (failure.code != FailureCode::notCertain) return {};
  if (failure.reason == nameOf(DoubtCode::severalSwitches) && evidence && evidence->switches.size() > 1)
    return whichSwitch(evidence->switches);
  if (failure.reason == nameOf(DoubtCode::unitMissing)) {
    const bool x = failure.remedies.include(RemedyKind::giveXUnit),
               y = failure.remedies.include(RemedyKind::giveYUnit);
    if (x != y) return whichUnit(y);
  }
  if (strokeIsGiven(hints, Stroke::press)) {
    if (!evidence || strokeIsGiven(hints, Stroke::release) || !isOfCurves(failure)) return {};
    return whichIsRelease(evidence->traces, hints);
  }
  const bool mayBeExchanged = failure.reason == nameOf(DoubtCode::strokesAlike) ||
                              failure.reason == nameOf(DoubtCode::releaseAbovePress);
  if (mayBeExchanged && evidence && evidence->traces.size() == 2 &&
      evidence->traces[0].color != evidence->traces[1].color)
    return whichIsPress(evidence->traces);
  return {};
}

}  // namespace detent::importer
