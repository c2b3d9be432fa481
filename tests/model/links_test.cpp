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

TEST_CASE("A release that follows its press keeps its shape and moves along") {
  const Button before = *tactileButton(), after = withPeakAt(before, {1.4, 0.62});
  EditLinks links;
  links.releaseBelowPress_N = 0.07;
  const auto kept = keptLinks(before, after, links);
  REQUIRE(kept.ok());
  const ForceGraph &was = before.states()[0].graph, &is = kept->states()[0].graph;
  CHECK(is.press() == after.states()[0].graph.press());
  REQUIRE(is.release()->knots().size() == was.release()->knots().size());
  // Beyond the flanks of the peak nothing moved; inside, each knot rose as the press did there.
  for (std::size_t i = 0; i < was.release()->knots().size(); ++i) {
    const Knot &from = was.release()->knots()[i], &to = is.release()->knots()[i];
    CHECK(to.force_N - from.force_N ==
          Approx(is.press().force_N(to.displacement_mm) - was.press().force_N(from.displacement_mm))
              .margin(1e-12));
  }
  CHECK(is.release()->start_mm() == was.release()->start_mm());
  CHECK(is.release()->end_mm() == was.release()->end_mm());
  CHECK(is.release()->knots() != was.release()->knots());
}

TEST_CASE("A mirrored release that follows stays at its distance, whatever moves") {
  const Button mirrored = *editGraph(
      *tactileButton(), 0, [](const ForceGraph& graph) { return mirrorPressToRelease(graph, 0.05); });
  EditLinks links;
  links.releaseBelowPress_N = 0.05;
  for (const Button& after : {withPeakAt(mirrored, {1.5, 0.62}), withPressEndAt(mirrored, 4.3)}) {
    const auto kept = keptLinks(mirrored, after, links);
    REQUIRE(kept.ok());
    const ForceGraph& graph = kept->states()[0].graph;
    CHECK(graph.release()->end_mm() == Approx(graph.press().end_mm()).margin(1e-9));
    for (const double at_mm : {1.0, 1.4, 1.5, 2.6, 3.9})
      CHECK(graph.press().force_N(at_mm) - graph.release()->force_N(at_mm) == Approx(0.05).margin(1e-9));
  }
  // The release can be edited by itself, and a button as a whole.
  const auto edited = editGraph(mirrored, 0, [](const ForceGraph& g) {
    return editStroke(g, Stroke::release, [](const StrokeCurve& c) { return scaleForce(c, 1.1); });
  });
  CHECK(*keptLinks(mirrored, *edited, links) == *edited);
  const auto scaled = scaleForce(mirrored, 1.2);
  CHECK(*keptLinks(mirrored, *scaled, links) == *scaled);
}

TEST_CASE("Lowering the releases moves every force by the same, and nothing else") {
  const Button before = *tactileButton();
  const auto lowered = lowerReleases(before, 0.02);
  REQUIRE(lowered.ok());
  CHECK(lowered->states()[0].graph.press() == before.states()[0].graph.press());
  for (const double at_mm : {0.2, 1.3, 3.0})
    CHECK(lowered->states()[0].graph.release()->force_N(at_mm) ==
          Approx(before.states()[0].graph.release()->force_N(at_mm) - 0.02));
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
