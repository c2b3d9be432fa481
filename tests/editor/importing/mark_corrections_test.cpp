// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/mark_corrections.h"

#include <catch2/catch.hpp>

using namespace detent;
using namespace detent::editor;
using Kind = MarkCorrection::Kind;

namespace {

/// A real page with a loop of its own, read once.
const ImportedGraph& imported() {
  static const ImportedGraph graph = [] {
    auto session =
        importer::ImportSession::open(std::string(DETENT_SOURCE_DIR) + "/samples/plots/white-vector.pdf");
    REQUIRE(session);
    importer::ImportRequest request;
    request.page = 1, request.graph = 1;
    const auto attempt = session->attempt(request);
    REQUIRE(attempt.report);
    return ImportedGraph{
        {1, 1}, std::make_shared<const importer::ImportReport>(*attempt.report), {}, attempt.evidence, {}};
  }();
  return graph;
}

importer::Point onPage(CurvePoint at) {
  const auto& evidence = *imported().evidence;
  return evidence.view.viewToPage(evidence.axes.calibration.value.toView({at.displacement_mm, at.force_N}));
}

const ButtonState& stateOf(const MarkedImport& marked) { return marked.imported.report->button.states()[0]; }

}  // namespace

TEST_CASE("Operating and reset point are set and taken away where a hand puts them on the page") {
  const StrokeCurve& press = imported().report->button.states()[0].graph.press();
  const double at_mm = 0.4 * press.end_mm();
  const auto set =
      withMarks(imported(), {{Kind::operating, Stroke::press, {}, onPage({at_mm, press.force_N(at_mm)})}});
  CHECK(set.refused.empty());
  CHECK(stateOf(set).operatingPoint_mm.value() == Approx(at_mm).epsilon(1e-6));
  CHECK(stateOf(set).graph == imported().report->button.states()[0].graph);
  const auto& given = set.imported.report->button.provenance()->given;
  CHECK(std::find(given.begin(), given.end(), "operating point") != given.end());
  CHECK_FALSE(stateOf(withMarks(imported(), {{Kind::operating, Stroke::press, {}, {}}})).operatingPoint_mm);
  const auto outside = withMarks(imported(), {{Kind::reset, Stroke::release, {}, onPage({-5, 0.2})}});
  CHECK(outside.refused.size() == 1);
}

TEST_CASE("Tactile points are moved, taken away and added") {
  const auto points = tactilePoints(imported().report->button.states()[0].graph.press(), Stroke::press);
  REQUIRE_FALSE(points.empty());
  const CurvePoint from{points[0].displacement_mm, points[0].force_N};
  const CurvePoint to{from.displacement_mm + 0.02, 1.02 * from.force_N};
  const auto moved = withMarks(imported(), {{Kind::tactile, Stroke::press, onPage(from), onPage(to)}});
  CHECK(moved.refused.empty());
  const auto now = tactilePoints(stateOf(moved).graph.press(), Stroke::press);
  CHECK(now[0].displacement_mm == Approx(to.displacement_mm).margin(1e-6));
  CHECK(now[0].force_N == Approx(to.force_N).margin(1e-6));
  CHECK(moved.imported.report->press.fit.tactilePoints.size() == now.size());
  const auto gone = withMarks(imported(), {{Kind::tactile, Stroke::press, onPage(from), {}}});
  CHECK(tactilePoints(stateOf(gone).graph.press(), Stroke::press).size() + 1 == points.size());
}

TEST_CASE("A point that is moved twice is one correction") {
  const MarkCorrection first{Kind::tactile, Stroke::press, importer::Point{1, 1}, importer::Point{2, 2}};
  const MarkCorrection again{Kind::tactile, Stroke::press, importer::Point{2, 2}, importer::Point{3, 3}};
  const auto twoMarks = withMark(withMark({}, first), again);
  REQUIRE(twoMarks.size() == 1);
  CHECK(twoMarks[0] ==
        MarkCorrection{Kind::tactile, Stroke::press, importer::Point{1, 1}, importer::Point{3, 3}});
  const MarkCorrection added{Kind::tactile, Stroke::press, {}, importer::Point{5, 5}};
  const MarkCorrection removed{Kind::tactile, Stroke::press, importer::Point{5, 5}, {}};
  CHECK(withMark(withMark({}, added), removed).empty());
  const MarkCorrection operating{Kind::operating, Stroke::press, {}, importer::Point{1, 1}};
  CHECK(withMark(withMark({}, operating), operating).size() == 1);
}
