// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/links.h"

#include <catch2/catch.hpp>

#include "model/edits.h"
#include "model/sections.h"
#include "model/templates.h"

using namespace detent;

namespace {

Button withPressEndAt(const Button& button, double end_mm) {
  const auto moved = editGraph(button, 0, [&](const ForceGraph& graph) {
    return editStroke(graph, Stroke::press, [&](const StrokeCurve& curve) {
      const auto sections = sectionsOf(curve, Stroke::press);
      return moveSection(curve, Stroke::press, sections.size() - 1, end_mm - curve.end_mm(), 0);
    });
  });
  REQUIRE(moved.ok());
  return *moved;
}

Button withPeakAt(const Button& button, CurvePoint to) {
  const auto moved = editGraph(button, 0, [&](const ForceGraph& graph) {
    return editStroke(graph, Stroke::press, [&](const StrokeCurve& curve) {
      return moveTactilePoint(curve, Stroke::press, 0, to);
    });
  });
  REQUIRE(moved.ok());
  return *moved;
}

}  // namespace

TEST_CASE("Without links an edit is what it is") {
  const Button before = *tactileButton(), after = withPressEndAt(before, 4.3);
  CHECK(*keptLinks(before, after, {}) == after);
}

TEST_CASE("One end of the travel: every stroke of every state goes to where one was moved") {
  const Button before = *addState(*tactileButton(), 0);
  EditLinks links;
  links.oneTravelEnd = true;
  for (const double end_mm : {4.25, 3.8}) {
    const auto kept = keptLinks(before, withPressEndAt(before, end_mm), links);
    REQUIRE(kept.ok());
    for (std::size_t i = 0; i < 2; ++i) {
      const ForceGraph& graph = kept->states()[i].graph;
      CHECK(graph.press().end_mm() == Approx(end_mm).margin(1e-9));
      CHECK(graph.release()->end_mm() == Approx(end_mm).margin(1e-9));
      // The bottom-out keeps its height and the peak its displacement.
      CHECK(graph.press().knots().back().force_N == before.states()[i].graph.press().knots().back().force_N);
      CHECK(tactilePoints(graph.press(), Stroke::press)[0].force_N == Approx(0.55));
    }
    CHECK(*keptLinks(before, *kept, links) == *kept);
  }
}

TEST_CASE("A release that follows its press lies below it by the offset, and is not edited itself") {
  const Button before = *tactileButton();
  EditLinks links;
  links.releaseBelowPress_N = 0.07;
  const auto kept = keptLinks(before, withPeakAt(before, {1.4, 0.62}), links);
  REQUIRE(kept.ok());
  const ForceGraph& graph = kept->states()[0].graph;
  for (const double at_mm : {0.2, 1.4, 2.6, 3.9})
    CHECK(graph.release()->force_N(at_mm) == Approx(graph.press().force_N(at_mm) - 0.07).margin(1e-12));
  const auto edited = editGraph(*kept, 0, [](const ForceGraph& g) {
    return editStroke(g, Stroke::release, [](const StrokeCurve& c) { return scaleForce(c, 1.1); });
  });
  const auto refused = keptLinks(*kept, *edited, links);
  REQUIRE_FALSE(refused.ok());
  CHECK_THAT(refused.failure().sentence(), Catch::Contains("release: follows its press"));
}

TEST_CASE("Switched on, the links hold at once") {
  const Button before = withPressEndAt(*tactileButton(), 4.2);
  EditLinks links;
  links.oneTravelEnd = true;
  links.releaseBelowPress_N = 0.05;
  const auto linked = linkedTo(before, 0, links);
  REQUIRE(linked.ok());
  const ForceGraph& graph = linked->states()[0].graph;
  CHECK(graph.release()->end_mm() == Approx(4.2));
  CHECK(graph.release()->force_N(2) == Approx(graph.press().force_N(2) - 0.05));
}

TEST_CASE("A pinned point stays, whatever else moves") {
  const Button before = *tactileButton();
  EditLinks links;
  links.pinned = {{0, Stroke::press, 1.3}};
  CHECK_FALSE(keptLinks(before, withPeakAt(before, {1.3, 0.6}), links).ok());
  CHECK_FALSE(keptLinks(before, withPeakAt(before, {1.4, 0.55}), links).ok());
  CHECK(keptLinks(before, withPressEndAt(before, 4.2), links).ok());
  const auto scaled = scaleForce(before, 1.01);
  const auto refused = keptLinks(before, *scaled, links);
  REQUIRE_FALSE(refused.ok());
  CHECK_THAT(refused.failure().sentence(), Catch::Contains("1.3 mm"));
  links.pinned = {{3, Stroke::press, 1.3}};  // of a state that is not there: holds nothing
  CHECK(keptLinks(before, *scaled, links).ok());
}
