// SPDX-License-Identifier: GPL-3.0-or-later
// The one place that tests how detent-import words what it found.
#include "importer/page/findings.h"

#include <set>

#include <catch2/catch.hpp>

using namespace detent;
using namespace detent::importer;

namespace {

template <class Code>
void everyCodeHasItsOwnNameAndWords(Code last, const auto& messageOfCode) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(last); ++i) {
    const auto code = static_cast<Code>(i);
    INFO(nameOf(code));
    CHECK(names.insert(nameOf(code)).second);
    CHECK_FALSE(nameOf(code).empty());
    const std::string words = english(messageOfCode(code));
    CHECK_FALSE(words.empty());
    CHECK(words.find('%') == std::string::npos);  // every place of the pattern is filled
    CHECK(words.back() != '.');
  }
}

}  // namespace

TEST_CASE("every finding has a name for scripts and words for people") {
  const std::vector<MessageValue> values{"a", "b", "c", "d"};
  everyCodeHasItsOwnNameAndWords(EvidenceCode::unitsOfHeading, [&](EvidenceCode c) {
    return messageOf(EvidenceItem{c, values});
  });
  everyCodeHasItsOwnNameAndWords(DoubtCode::assumed, [&](DoubtCode c) {
    return messageOf(Doubt{c, values, {}});
  });
  everyCodeHasItsOwnNameAndWords(RemarkCode::errorBarsLeftOut, [&](RemarkCode c) {
    return messageOf(Remark{c, values, {}});
  });
  for (int step = 0; step <= static_cast<int>(ImportStep::callouts); ++step)
    CHECK_FALSE(nameOf(static_cast<ImportStep>(step)).empty());
}

TEST_CASE("detent-import says what to pass after what it remarks") {
  CHECK(commandLineWords(Remark{
            RemarkCode::lengthUnitAssumed, {"x", "mm"}, {{RemedyKind::giveXUnit, "if it is another"}}}) ==
        "no unit for lengths was found at the x axis, so mm was assumed. Pass --x-unit if it is another");
  CHECK(
      commandLineWords(Remark{RemarkCode::severalGraphs,
                              {3, 2, 1},
                              {{RemedyKind::choosePage, {}},
                               {RemedyKind::chooseGraph, "for another"},
                               {RemedyKind::importAll, "for each"}}}) ==
      "3 graphs were found; this is the most certain one (page 2, graph 1). Pass --page and --graph (--list "
      "shows the "
      "graphs that were found) for another, or --all for each");
}

TEST_CASE("a doubt that nobody settles is a Failure with its code as reason") {
  const Failure failure = failureOf(
      {DoubtCode::axesUncertain,
       {messagesOf({{EvidenceCode::axisGiven, {"x"}}, {EvidenceCode::labelsInProgression, {"y", 5, 6, 9}}})},
       RemedyKind::giveFrame},
      std::string("a.pdf"), Message("graph %1", 1));
  CHECK(failure.code == FailureCode::notCertain);
  CHECK(failure.reason == nameOf(DoubtCode::axesUncertain));
  CHECK(failure.sentence() ==
        "a.pdf, graph 1: the axes are not certain (x: entered by hand; y axis: 5 of 6 printed numbers fit "
        "one scale, "
        "with "
        "9 ticks). "
        "Pass --frame X0,Y0,X1,Y1.");
}
