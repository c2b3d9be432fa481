// SPDX-License-Identifier: GPL-3.0-or-later
// What speaks against an import, one at a time.

#include "importer/doubts.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "importer/assemble_report.h"
#include "importer/graph_question.h"

using namespace detent;
using namespace detent::importer;

namespace {

/// 100 px per mm and per N; the origin stands at (100, 500) of a picture of 700 x 600.
Point inView(CurvePoint p) { return {100 + 100 * p.displacement_mm, 500 - 100 * p.force_N}; }

StrokePoints strokeOf(const std::vector<CurvePoint>& points) {
  StrokePoints stroke;
  for (const CurvePoint& p : points) {
    stroke.points.push_back(p);
    stroke.points_px.push_back(inView(p));
  }
  return stroke;
}

/// A press that nothing speaks against, on axes that name their units.
struct Import {
  LocatedGraph graph;
  std::vector<CurveTrace> traces;
  std::vector<CurvePoint> press{{0, 0.2}, {1, 0.7}, {1.5, 0.5}, {3, 0.8}, {3.2, 1.6}}, release;
  std::vector<SpecCheck> checks;
  ImportHints hints;
  std::size_t tactilePoints = 1;
  double turn_N = 0.2;  // how far the force turns back at each
  PageClass pageClass = PageClass::picture;
  Explanation explanation;
  bool fromVector = false, namedByLegend = false;
  std::vector<EvidenceItem> assumed;

  Import() {
    graph.view.raster.width_px = 700, graph.view.raster.height_px = 600;
    graph.frame.value.corners = {Point{100, 100}, Point{500, 100}, Point{500, 500}, Point{100, 500}};
    AxisCalibration& axes = graph.axes.calibration.value;
    graph.frame.value.yLines = {{.position_px = 100, .spansFrame = true}};
    axes.viewToUnits = {0.01, 0, -1, 0, -0.01, 5, 0, 0, 1};
    axes.x.unit = "mm", axes.y.unit = "N";
    axes.x.unitFound = axes.y.unitFound = true;
    graph.candidate.confidence = graph.frame.confidence = graph.axes.calibration.confidence = 1;
  }

  /// Everything the steps before gave; the points lie `rms_px` off the fit.
  GraphFindings findings(double rms_px = 0.1) const {
    const auto fitted = [&](const std::vector<CurvePoint>&) {
      FittedStroke stroke{StrokeCurve::throughPoints({{0, 0}, {1, 1}}).value(), {}};
      stroke.summary.tactilePoints.resize(tactilePoints);
      for (FittedTactilePoint& each : stroke.summary.tactilePoints) each.point.prominence_N = turn_N;
      stroke.summary.rmsSigma = 1;
      return stroke;
    };
    StrokePair pair{strokeOf(press), {}};
    FittedStrokes strokes{fitted(press), {}};
    if (!release.empty()) pair.release = strokeOf(release), strokes.release = fitted(release);
    Found<StrokePair> found;
    pair.press.fromVector = fromVector;
    if (pair.release) pair.release->fromVector = fromVector;
    found.value = pair;
    found.confidence = 1;
    found.evidence = assumed;
    if (namedByLegend) found.evidence.push_back({EvidenceCode::namedByLegend});
    return {graph, traces, found, strokes, rms_px, rms_px, {}, {}, pageClass, explanation};
  }
  /// Confidence of an import with this doubt; empty without the doubt.
  std::optional<double> weighed(DoubtCode kind) const {
    for (const WeighedDoubt& each : doubtsOf(findings(), checks, hints))
      if (each.doubt.code == kind) return each.confidence;
    return {};
  }
  std::vector<DoubtCode> doubts() const {
    std::vector<DoubtCode> kinds;
    for (const WeighedDoubt& each : doubtsOf(findings(), checks, hints)) {
      const bool goesOn = explanation.patches.share > 0 ||
                          (!explanation.left.empty() &&
                           (explanation.left.front().atAnEnd || explanation.left.front().dashed));
      const bool isPartOnly =
          each.doubt.code == DoubtCode::belowTheAxis || each.doubt.code == DoubtCode::leavesThePlot ||
          each.doubt.code == DoubtCode::assumed || each.doubt.code == DoubtCode::namesNoStroke ||
          each.doubt.code == DoubtCode::releaseNotGiven ||
          (each.doubt.code == DoubtCode::curveLeftOver && !goesOn);
      CHECK(each.confidence < 0.9);
      CHECK((each.confidence < confidenceBar) == !isPartOnly);
      CHECK_FALSE(english(messageOf(each.doubt)).empty());
      CHECK_FALSE(commandLineWords(each.doubt.remedies).empty());
      kinds.push_back(each.doubt.code);
    }
    return kinds;
  }
  bool doubted(DoubtCode kind) const {
    const auto kinds = doubts();
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
  }
};

}  // namespace

TEST_CASE("a press and a release that nothing speaks against") {
  Import import;
  CHECK(import.doubts().empty());
  import.release = {{3.2, 1.6}, {3, 0.6}, {1.4, 0.3}, {1, 0.4}, { 0, 0.1 }};
  CHECK(import.doubts().empty());
}

TEST_CASE("a point that the plot names and that was not placed is remarked") {
  Import import;
  auto& texts = import.graph.axes.texts;
  texts = {{"operating", {200, 150, 260, 165}, 1, 0}, {"position", {266, 150, 320, 165}, 1, 0}};
  const auto remarked = [&](RemarkCode code, GraphFindings findings, const ImportRequest& request = {}) {
    const auto report = assembleReport(std::move(findings), {}, request);
    REQUIRE(report.ok());
    return std::ranges::any_of(report->remarks, [&](const Remark& remark) { return remark.code == code; });
  };
  CHECK(remarked(RemarkCode::operatingPointNotPlaced, import.findings()));
  CHECK_FALSE(remarked(RemarkCode::resetPointNotPlaced, import.findings()));
  GraphFindings placed = import.findings();
  placed.callouts = {{CalloutKind::operatingPoint, {0.5, 0.5}, {}, 1, {}}};
  CHECK_FALSE(remarked(RemarkCode::operatingPointNotPlaced, placed));
  texts[1].utf8 = "force";  // a figure of the switch
  CHECK_FALSE(remarked(RemarkCode::operatingPointNotPlaced, import.findings()));
  texts = {{"Reset point", {200, 150, 290, 165}, 1, 0}, {"operating point", {200, 540, 320, 555}, 1, 0}};
  CHECK(remarked(RemarkCode::resetPointNotPlaced, import.findings()));
  CHECK_FALSE(remarked(RemarkCode::operatingPointNotPlaced, import.findings()));  // below the plot
}

TEST_CASE("a given press without a release is reported until a person says that there is none") {
  struct Row {
    const char* given;
    void (*give)(ImportHints&);
    bool releaseFound, reported;
  };
  const auto line = [](ImportHints& hints) { hints.drawn.press = {{100, 400}, {400, 200}}; };
  const auto color = [](ImportHints& hints) { hints.trace.pressColor = Rgb{200, 30, 30}; };
  for (const Row& row :
       {Row{"nothing", [](ImportHints&) {}, false, false}, Row{"press line", line, false, true},
        Row{"press line, release found", line, true, false}, Row{"press colour", color, false, true},
        Row{"press colour, no release",
            [](ImportHints& hints) {
              hints.trace.pressColor = Rgb{200, 30, 30};
              hints.strokes.noRelease = true;
            },
            false, false},
        Row{"switch", [](ImportHints& hints) { hints.strokes.curve = "1"; }, false, false}}) {
    CAPTURE(row.given);
    Import import;
    if (row.releaseFound) import.release = {{3.2, 1.6}, {3, 0.6}, {1.4, 0.3}, {1, 0.4}, { 0, 0.1 }};
    ImportRequest request;
    row.give(request.hints);
    const auto report = assembleReport(import.findings(), {}, request);
    REQUIRE(report.ok());
    CHECK((report->confidence < 1) == row.reported);
    CHECK(std::ranges::any_of(report->remarks, [](const Remark& remark) {
            return remark.code == RemarkCode::doubted && remark.remedies.include(RemedyKind::noRelease);
          }) == row.reported);
  }
}

TEST_CASE("an answer about the press leaves all doubts about the release") {
  Import pair;
  pair.release = {{3.2, 1.6}, {3, 0.6}, {1.4, 0.3}, {1, 0.4}, {0, 0.1}};
  Import scale = pair, names = pair, line = pair, dashes = pair;
  scale.graph.axes.rightScale = RightScale::other;
  names.traces.resize(2);
  names.traces[0].color = {200, 30, 30}, names.traces[1].color = {30, 30, 200};
  names.traces[1].label = "Clicky";
  Remainder left;
  left.box_px = {250, 150, 420, 350}, left.thickness = 1.2;
  left.pixels_px = {{250, 350}, {300, 300}, {350, 250}, {420, 150}};
  line.explanation.left = {left};
  left.likeness = 0.8, left.atAnEnd = true;
  dashes.explanation.left = {left};
  struct Row {
    const char* given;
    void (*give)(ImportHints&);
    bool settled;
  };
  const auto press = [](ImportHints& hints) { hints.trace.pressColor = Rgb{200, 30, 30}; };
  const auto pressLine = [](ImportHints& hints) { hints.drawn.press = {{100, 400}, {400, 200}}; };
  const auto release = [](ImportHints& hints) { hints.trace.releaseColor = Rgb{30, 30, 200}; };
  const auto bothLines = [](ImportHints& hints) {
    hints.drawn = {{{100, 400}, {400, 200}}, {{100, 400}, {400, 250}}};
  };
  for (const Row& row : {Row{"nothing", [](ImportHints&) {}, false}, Row{"press", press, false},
                         Row{"press line", pressLine, false}, Row{"release", release, false},
                         Row{"both lines", bothLines, true}}) {
    CAPTURE(row.given);
    for (Import* each : {&scale, &names, &line, &dashes}) each->hints = {}, row.give(each->hints);
    CHECK(scale.weighed(DoubtCode::otherScale).has_value() == !row.settled);
    CHECK(names.weighed(DoubtCode::namesNoStroke).has_value() == !row.settled);
    CHECK((line.weighed(DoubtCode::curveLeftOver).value_or(1) < confidenceBar) == !row.settled);
    CHECK((dashes.weighed(DoubtCode::curveLeftOver).value_or(1) < confidenceBar) == !row.settled);
  }
}

TEST_CASE("a unit that no title names is doubted, unless the page confirms it or it is given") {
  Import import;
  import.graph.axes.calibration.value.y.unitFound = false;
  CHECK(import.doubted(DoubtCode::unitMissing));
  import.checks = {{ {SpecQuantity::tactileForce, 0.7, {}, {}, "Tactile force 0.7 N", 1}, 0.7, true }};
  CHECK_FALSE(import.doubted(DoubtCode::unitMissing));
  import.graph.axes.calibration.value.y.otherQuantity = "kPa";
  CHECK(import.doubted(DoubtCode::otherQuantity));
  import.hints.axes.yUnit = ForceUnit::newton;  // a unit does not make a force of a pressure
  CHECK(import.doubted(DoubtCode::otherQuantity));
}

TEST_CASE("given ends that contradict printed numbers are reported unless those are weak") {
  Import import;
  AxisReading& axis = import.graph.axes.calibration.value.x;
  CHECK_FALSE(import.weighed(DoubtCode::givenAgainstLabels));
  axis.contradicting = {"2", "3"}, axis.contradictedBy = 0.9;
  const double confidence = import.weighed(DoubtCode::givenAgainstLabels).value_or(1);
  CHECK((confidence >= confidenceBar && confidence < 0.9));  // what is given holds, with a remark
  const auto doubts = doubtsOf(import.findings(), import.checks, import.hints);
  CHECK(english(messageOf(doubts.front().doubt)) ==
        "the values entered for the x axis contradict the numbers printed there (2, 3)");
  axis.contradictedBy = 0.3;
  CHECK_FALSE(import.weighed(DoubtCode::givenAgainstLabels));
}

TEST_CASE("a factor in a title stays in doubt, though reported alone with a given unit") {
  Import import;
  AxisReading& axis = import.graph.axes.calibration.value.y;
  CHECK_FALSE(import.weighed(DoubtCode::factorPrinted));
  axis.factor = 10;
  CHECK(import.weighed(DoubtCode::factorPrinted).value_or(1) < confidenceBar);
  import.hints.axes.yUnit = ForceUnit::gramForce;
  const double confidence = import.weighed(DoubtCode::factorPrinted).value_or(1);
  CHECK((confidence >= confidenceBar && confidence < 0.9));
  import.hints.axes.yMax = 10;
  for (const bool multiplied : {false, true}) {
    axis.multiplied = multiplied;
    const Doubt said = doubtsOf(import.findings(), import.checks, import.hints).front().doubt;
    CHECK(english(messageOf(said)) ==
          (multiplied
               ? "the title of the y axis prints the factor 10; the numbers along the axis were multiplied "
                 "by it"
               : "the title of the y axis prints the factor 10; the given values were not multiplied by it"));
  }
}

TEST_CASE("a factor that cannot be read is in doubt, whatever unit was given") {
  Import import;
  import.graph.axes.calibration.value.y.factorUnread = true;
  import.hints.axes.yUnit = ForceUnit::gramForce;
  CHECK(import.weighed(DoubtCode::factorUnread).value_or(1) < confidenceBar);
  const Doubt said = doubtsOf(import.findings(), import.checks, import.hints).front().doubt;
  CHECK(english(messageOf(said)) == "the title of the y axis prints a factor that cannot be read");
  CHECK(said.remedies.include(RemedyKind::giveYAxis));
  import.graph.axes.calibration.value.y.repeated = true;
  import.hints.axes.yMin = 0, import.hints.axes.yMax = 1;
  const auto after = doubtsOf(import.findings(), import.checks, import.hints);
  REQUIRE_FALSE(after.empty());
  CHECK(after.front().doubt.remedies.include(RemedyKind::advice));
}

TEST_CASE("sizes in doubts are in the unit of the page, with three digits") {
  Import import;
  for (CurvePoint& p : import.press) p.force_N = -1.23456 * p.force_N;
  AxisReading& axis = import.graph.axes.calibration.value.y;
  const auto said = [&] {
    for (const WeighedDoubt& each : doubtsOf(import.findings(), import.checks, import.hints))
      if (each.doubt.code == DoubtCode::negativeForce) return english(messageOf(each.doubt));
    return std::string();
  };
  CHECK(said() == "the press goes down to -1.98 N, below zero");
  axis.unit = "gf";
  CHECK(said() == "the press goes down to -201 gf, below zero");
}

TEST_CASE("axes that measure something else are the reason, whatever else is uncertain") {
  Import import;
  import.graph.axes.calibration.confidence = 0.1;
  import.graph.axes.calibration.value.x.otherQuantity = "time";
  const auto report = assembleReport(import.findings(), {}, {});
  REQUIRE_FALSE(report.ok());
  CHECK(report.failure().reason == nameOf(DoubtCode::otherQuantity));
}

TEST_CASE("thousands that may be decimals stay in doubt, whatever the unit") {
  Import import;
  const bool force = GENERATE(false, true);
  AxisCalibration& axes = import.graph.axes.calibration.value;
  (force ? axes.y : axes.x).thousandsUnclear = true;
  CHECK(import.doubted(DoubtCode::thousandsUnclear));
  import.hints.axes.xUnit = LengthUnit::micrometre;
  import.hints.axes.yUnit = ForceUnit::millinewton;
  CHECK(import.doubted(DoubtCode::thousandsUnclear));
}

TEST_CASE(
    "sizes no button has are said by the axis or doubted, and a unit that changes nothing answers nothing") {
  Import import;
  for (CurvePoint& p : import.press) p.force_N *= 1000;
  CHECK(import.doubted(DoubtCode::implausibleForce));
  import.hints.axes.yUnit = ForceUnit::newton;
  CHECK(import.doubted(DoubtCode::implausibleForce));
  // Both ends settle it, with a remark, unless they are those of the printed numbers.
  const auto isRemark = [](std::optional<double> confidence) {
    return confidence && *confidence >= confidenceBar && *confidence < 0.9;
  };
  import.hints.axes.yMin = 0, import.hints.axes.yMax = 4000;
  CHECK(isRemark(import.weighed(DoubtCode::implausibleForce)));
  import.graph.axes.calibration.value.y.repeated = true;
  CHECK(import.weighed(DoubtCode::implausibleForce).value_or(1) < confidenceBar);
  Import wideGap;
  for (CurvePoint& p : wideGap.press) p.displacement_mm *= 10;
  CHECK(wideGap.doubted(DoubtCode::implausibleTravel));
  wideGap.hints.axes.xUnit = LengthUnit::millimetre;
  CHECK(wideGap.doubted(DoubtCode::implausibleTravel));
  wideGap.hints.axes.xMin = 0, wideGap.hints.axes.xMax = 40;
  CHECK(isRemark(wideGap.weighed(DoubtCode::implausibleTravel)));
  wideGap.graph.axes.calibration.value.x.repeated = true;
  CHECK(wideGap.weighed(DoubtCode::implausibleTravel).value_or(1) < confidenceBar);
}

TEST_CASE(
    "pixels left over in the colour of a curve that was set aside are that curve's, and a black mark "
    "nobody's") {
  Import import;
  Raster& picture = import.graph.view.raster;
  picture.rgb.assign(3UL * 700 * 600, 255);
  CurveTrace stroke, contact;
  stroke.color = {200, 0, 0}, contact.color = {0, 0, 200};
  for (const CurvePoint& p : import.press) stroke.points_px.push_back(inView(p));
  contact.points_px = {inView({0, 3}), inView({2, 3})};
  import.traces = {stroke, contact};
  Remainder left;
  left.likeness = 0.8, left.atAnEnd = true, left.box_px = {150, 150, 450, 300}, left.thickness = 1;
  const auto paint = [&](Rgb color, int rising) {
    left.pixels_px.clear();
    for (int x = 150; x < 450; ++x) {
      const int y = 225 + rising * (150 - x) / 4;
      std::uint8_t* p = picture.rgb.data() + 3 * (700 * y + x);
      p[0] = color.r, p[1] = color.g, p[2] = color.b;
      left.pixels_px.push_back({double(x), double(y)});
    }
    import.explanation = {{left}, {}, {}, {}};
  };
  paint(contact.color, 1);
  CHECK(import.doubts().empty());
  paint(stroke.color, 1);
  CHECK(import.weighed(DoubtCode::curveLeftOver));
  left.likeness = 0;
  paint({20, 20, 20}, 1);
  CHECK(import.weighed(DoubtCode::curveLeftOver));  // a line of the other state is left over
  paint({20, 20, 20}, -1);
  CHECK(import.doubts().empty());
  paint(stroke.color, -1);
  CHECK(import.weighed(DoubtCode::curveLeftOver));
  import.explanation = {{}, {}, {}, { 0.5, inView({1, 2}) }};  // a line beside a press that was traced alone
  CHECK(import.weighed(DoubtCode::curveLeftOver).value_or(1) < confidenceBar);
  import.explanation = {{}, {{ inView({0.5, 3}), inView({1.5, 3}), 0.1 }}, {}, {}};
  CHECK(import.doubts().empty());
  import.explanation = {{}, {{ inView({0.5, 2}), inView({1.5, 2}), 0.1 }}, {}, {}};
  CHECK(import.weighed(DoubtCode::curveOverPaper));
}

TEST_CASE(
    "a switch chosen among others whose own colour runs on beside its press has a release that was not "
    "followed") {
  Import import;
  Raster& picture = import.graph.view.raster;
  picture.rgb.assign(3UL * 700 * 600, 255);
  CurveTrace stroke;
  stroke.color = {200, 0, 0};
  for (double mm = 0; mm < 3.2; mm += 0.01) stroke.points_px.push_back(inView({mm, 0.5}));
  stroke.points_px.front() = inView(import.press.front()),
  stroke.points_px.back() = inView(import.press.back());
  import.traces = {stroke};
  import.hints.strokes.curve = "1";
  const auto paint = [&](double force_N, double to_mm) {
    for (double mm = 0; mm < to_mm; mm += 0.01) {
      const Point p = inView({mm, force_N});
      std::uint8_t* at = picture.rgb.data() + 3 * (700 * static_cast<int>(p.y) + static_cast<int>(p.x));
      at[0] = 200, at[1] = at[2] = 0;
    }
  };
  paint(0.5, 3.2);
  paint(3, 0.5);  // the line's key in the legend
  CHECK(import.doubts().empty());
  paint(0.3, 1.2);
  CHECK(import.weighed(DoubtCode::curveLeftOver).value_or(1) < confidenceBar);
  import.release = {{3.2, 1.6}, {3, 0.6}, {1.4, 0.3}, {1, 0.4}, { 0, 0.1 }};
  CHECK(import.doubts().empty());
}

TEST_CASE("a colour given for the curve that the legend calls the other stroke is taken, and that is said") {
  Import import;
  CurveTrace curve;
  curve.color = {200, 0, 0}, curve.label = "Release", curve.stroke = Stroke::press;
  import.traces = {curve};
  CHECK_FALSE(import.weighed(DoubtCode::givenAgainstLegend));  // the tracer's own word
  import.hints.trace.pressColor = curve.color;
  CHECK(import.weighed(DoubtCode::givenAgainstLegend).value_or(0) >= confidenceBar);
  import.traces.front().label = "Press";
  CHECK_FALSE(import.weighed(DoubtCode::givenAgainstLegend));
  import.traces.front().label = "Release";
  import.hints.strokes.swap = true;  // said twice
  CHECK_FALSE(import.weighed(DoubtCode::givenAgainstLegend));
}

TEST_CASE("pixels of a curve's colour that nothing explains are doubted, and a curve without pixels") {
  Import import;
  Remainder left;
  left.box_px = {200, 200, 300, 300}, left.likeness = 0.3;
  import.explanation.left = {left};
  CHECK(import.doubts().empty());
  import.explanation.left.front().likeness = 0.8;
  CHECK(import.doubted(
      DoubtCode::curveLeftOver));  // only a remark: the pixels may be something else on the page
  import.explanation.left.front().atAnEnd = true;
  CHECK(import.doubted(DoubtCode::curveLeftOver));  // a refusal: the curve goes on
  import.explanation.left.front().atAnEnd = false;
  import.explanation.left.front().dashed = true;
  CHECK(import.doubted(DoubtCode::curveLeftOver));  // a refusal: no part of the page but a stroke is drawn so
  import.explanation = {{}, {}, {0.05, { 200, 200 }}, {}};
  CHECK(import.doubts().empty());
  import.explanation.patches.share = 0.2;
  CHECK(
      import.doubted(DoubtCode::curveLeftOver));  // a refusal: the curve may be the edge of a background area
  import.explanation = {{}, {{ {200, 200}, {200, 260}, 0.1 }}, {}, {}};
  CHECK(import.doubted(DoubtCode::curveOverPaper));
  import.hints.drawn.press = {{100, 400}, { 400, 200 }};
  import.hints.strokes.noRelease = true;
  CHECK(import.doubts().empty());
}

TEST_CASE("a line of neither stroke is another state's, however straight") {
  Import import;
  Remainder line;
  line.box_px = {250, 150, 420, 350}, line.thickness = 1.2, line.straight = true;
  import.explanation.left = {line};
  CHECK(import.weighed(DoubtCode::curveLeftOver).value_or(1) < confidenceBar);
  Import guide = import, leader = import, patch = import, chosen = import, legend = import, rim = import;
  rim.explanation.left.front().pixels_px = {inView({0.2, 0.31}), inView({0.9, 0.66}), inView({2, 0.61}),
                                            inView({2.9, 0.79})};
  legend.explanation.left.front().pixels_px = {{250, 200}, {250, 300}, {300, 150}, {400, 350}, {420, 250}};
  guide.explanation.left.front().box_px = {250, 300, 420, 303};
  leader.explanation.left.front().box_px = {250, 150, 300, 250};
  patch.explanation.left.front().thickness = 30;
  chosen.hints.strokes.curve = "1";
  for (const Import* each : {&guide, &leader, &patch, &chosen, &legend, &rim})
    CHECK_FALSE(each->weighed(DoubtCode::curveLeftOver));
}

TEST_CASE("what a step took for granted is said") {
  Import import;
  import.assumed = {{ EvidenceCode::pressAboveRelease, { "0.9" } }};
  CHECK(import.doubts().empty());
  import.assumed = {{EvidenceCode::nameNearly,
                     { "Tactile",
                       "Tactlle" }},
                    { EvidenceCode::startUnderAnother }};
  CHECK(import.doubts() == std::vector{DoubtCode::assumed, DoubtCode::assumed});
  import.assumed.clear();
  import.graph.axes.calibration.evidence.push_back({EvidenceCode::unitsOfHeading, { "(cN, mm)" }});
  CHECK(import.doubts() == std::vector{DoubtCode::assumed});
}

TEST_CASE("travel and force below zero") {
  Import import;
  for (CurvePoint& p : import.press) p.displacement_mm -= 3.2;
  CHECK(import.doubted(DoubtCode::negativeTravel));
  Import low;
  for (CurvePoint& p : low.press) p.force_N -= 0.8;
  CHECK(low.doubted(DoubtCode::negativeForce));
}

TEST_CASE("one line traced twice, a line along an axis, more turns than a button has") {
  Import twice;
  twice.release = twice.press;
  std::reverse(twice.release.begin(), twice.release.end());
  CHECK(twice.doubted(DoubtCode::strokesCoincide));
  twice.namedByLegend = true;
  CHECK(twice.doubted(
      DoubtCode::strokesCoincide));  // in pictures, a blurred rim may have got the other stroke's name
  twice.fromVector = true;
  CHECK_FALSE(twice.doubted(DoubtCode::strokesCoincide));  // a button without hysteresis
  twice.namedByLegend = false;
  CHECK(twice.doubted(DoubtCode::strokesCoincide));
  twice.fromVector = false;
  twice.press.erase(twice.press.begin(), twice.press.begin() + 2);  // a fringe of a part of the line
  CHECK(twice.doubted(DoubtCode::strokesCoincide));
  Import level;
  level.press = {{0, 0.2}, {0.5, 0.7}, {3.5, 0.7}};
  CHECK(level.doubted(DoubtCode::alongAnAxis));
  Import falls;
  falls.press.push_back({3.21, 0});
  CHECK(falls.doubted(DoubtCode::endsInAFall));
  Import falling;  // a curve of a chart that falls and comes back
  falling.press = {{0, 1}, {1, 0.4}, {2, 0}, {3, 0}, {3.5, 0.7}};
  CHECK(falling.doubted(DoubtCode::endsInAFall));
  falling.press.back().force_N = 1.5;  // a key that snaps at once, and its bottom-out
  CHECK_FALSE(falling.doubted(DoubtCode::endsInAFall));
  Import pulls;
  pulls.press = {{0.02, 1.0}, {0.2, 1.4}, {0.5, 0.9},
                 {1.2, 0.5},  {2.2, 0.3}, {3.2, 0.2}};  // a magnet's force over its gap
  CHECK(pulls.doubted(DoubtCode::endsInAFall));
  pulls.press.insert(pulls.press.end(), {{3.201, 1.0}, {3.201, 2.0}});  // the frame's edge at its end
  CHECK(pulls.doubted(DoubtCode::endsInAFall));
  pulls.press = {
      {0, 0.2}, {0.5, 1.4}, {1.2, 0.9}, {2.2, 0.5}, {3.2, 0.2}};  // a dome shown as far as its click
  CHECK_FALSE(pulls.doubted(DoubtCode::endsInAFall));
  Import turns;
  turns.tactilePoints = 7;
  CHECK(turns.doubted(DoubtCode::manyTactilePoints));
  turns.turn_N = 0.05;  // a force meter's noise, drawn as it is
  CHECK_FALSE(turns.doubted(DoubtCode::manyTactilePoints));
}

TEST_CASE("a release that covers a part of the press is a piece of something else") {
  Import import;
  import.release = {{2.6, 0.4}, { 1.9, 0.2 }};
  CHECK(import.doubted(DoubtCode::strokeInPart));
  import.release = {{3.2, 1.4}, { 1.6, 0.2 }};  // a key that stays down
  CHECK_FALSE(import.doubted(DoubtCode::strokeInPart));
  import.release = {{3.2, 1.4}, { 1.6, 0.45 }};  // gives out beside the press
  CHECK(import.doubted(DoubtCode::strokeInPart));
}

TEST_CASE("a release begins where the press ends, or at its force") {
  struct Row {
    CurvePoint begin;
    bool doubted;
  };
  for (const Row& row : {Row{{3.2, 1.4}, false},   // where the press ends
                         {{3.2, 0.7}, false},      // below it: what a drawing leaves out
                         {{3.15, 0.7}, false},     // within the width of lines
                         {{3.1, 0.7}, true},       // its bottom-out is missing
                         {{3.05, 1.1}, true},      // a part of it
                         {{3.05, 1.3}, false}}) {  // beside a slanted bottom-out
    INFO(row.begin.displacement_mm << " mm, " << row.begin.force_N << " N");
    Import import;
    import.release = {row.begin, {1, 0.4}, { 0, 0.1 }};
    CHECK(import.doubted(DoubtCode::releaseStartsShort) == row.doubted);
  }
  Import import;
  import.press = {{0, 0.2}, {1, 1.6}, { 3.2, 1.1 }};  // its end is not its peak
  import.release = {{3.05, 0.9}, {1, 0.4}, { 0, 0.1 }};
  CHECK_FALSE(import.doubted(DoubtCode::releaseStartsShort));
  import = {};
  import.release = {{3.05, 0.7}, {1, 0.4}, { 0, 0.1 }};
  const Doubt said = doubtsOf(import.findings(), import.checks, import.hints).front().doubt;
  CHECK(english(messageOf(said)) ==
        "the release was traced from 3.05 mm only, but the press goes on to 3.2 mm; its beginning may be "
        "missing");
  import.hints.drawn.release = {{100, 100}, { 200, 200 }};
  CHECK_FALSE(import.doubted(DoubtCode::releaseStartsShort));
}

TEST_CASE("a key that locks comes to rest on the way, if a legend names its strokes") {
  Import import;
  import.release = {{3.2, 1.4}, { 2.3, 0.01 }};
  CHECK(import.doubted(DoubtCode::strokeInPart));
  import.namedByLegend = true;
  CHECK_FALSE(import.doubted(DoubtCode::strokeInPart));
  import.release.back().force_N = 0.3;
  CHECK(import.doubted(DoubtCode::strokeInPart));
}

TEST_CASE("a stroke that steps onto the other one and back was led along what was to be seen") {
  Import import;
  import.release = {{3.2, 1.6},   {3, 0.6},    {2.3, 0.5}, {2.25, 0.65},
                    {1.75, 0.55}, {1.7, 0.35}, {1, 0.4},   { 0, 0.1 }};
  CHECK(import.doubted(DoubtCode::strokesCoincide));
  // Two snaps: the press falls onto the release, the release away from the press.
  import.press = {{0, 0.2}, {1, 0.9}, {1.02, 0.5}, {2, 0.7}, {3, 0.9}, { 3.2, 1.6 }};
  import.release = {{3.2, 1.6}, {3, 0.7}, {2.03, 0.5}, {2, 0.7}, {1.02, 0.5}, { 0, 0.1 }};
  CHECK_FALSE(import.doubted(DoubtCode::strokesCoincide));
  // A tester's curve: the release comes up to the press on the way, and its bottom-out stands in front.
  import.press = {{0, 0.5}, {0.5, 0.65}, {2, 0.4}, {2.5, 0.55}, {3.16, 0.65}, { 3.2, 1.6 }};
  import.release = {{3.17, 1.6}, {3.13, 0.65}, {2.55, 0.55}, {2.5, 0.45}, {2, 0.2}, { 0, 0.1 }};
  CHECK_FALSE(import.doubted(DoubtCode::strokesCoincide));
}

TEST_CASE("a release that jumps onto the press in the gaps of its dashes was traced along the wrong line") {
  Import import;
  import.press = {{0, 0.2}, {0.4, 0.9}, {1, 0.6}, {2.8, 0.7}, { 3.2, 1.6 }};
  const auto onPress_N = [](double x_mm) { return 0.6 + 0.1 * (x_mm - 1) / 1.8; };
  const auto releaseInGaps = [&](int gaps) {
    std::vector<CurvePoint> release{{0, 0.1}};
    for (int k = 0; k < gaps; ++k) {
      const double x = 1.2 + 0.15 * k;
      release.insert(release.end(), {{x, onPress_N(x) - 0.06},
                                     {x + 0.01, onPress_N(x)},
                                     {x + 0.05, onPress_N(x + 0.05)},
                                     {x + 0.06, onPress_N(x) - 0.06}});
    }
    release.insert(release.end(), {{2.8, 0.63}, {3.2, 1.6}});
    std::ranges::reverse(release);
    return release;
  };
  import.release = releaseInGaps(4);
  CHECK(import.doubted(DoubtCode::strokesCoincide));
  import.release = releaseInGaps(2);
  CHECK_FALSE(import.doubted(DoubtCode::strokesCoincide));
}

TEST_CASE("a press that begins with force where its release has long not come back to lost its way there") {
  Import import;
  import.press = {{0.8, 0.9}, {1.6, 1.0}, {2.4, 0.6}, { 3.2, 1.6 }};
  import.release = {{3.2, 1.6}, {2.4, 0.4}, {0.8, 0.5}, { 0, 0 }};
  CHECK(import.doubted(DoubtCode::strokeInPart));
  import.press.front() = {0.8, 0.1};  // a way that no force is met on
  CHECK_FALSE(import.doubted(DoubtCode::strokeInPart));
  import.press.insert(import.press.begin(),
                      {0.81, 0.05});  // a locked key's rises from there, and not quite plumb
  import.press[1] = {0.8, 0.9};
  CHECK_FALSE(import.doubted(DoubtCode::strokeInPart));
  import.press.front() = {0.3, 0.9};
  CHECK_FALSE(import.doubted(DoubtCode::strokeInPart));
}

TEST_CASE("what came from paper is worth less, unless frame and axes were given") {
  Import import;
  import.pageClass = PageClass::scan;
  CHECK(import.weighed(DoubtCode::pageIsScan) == Approx(0.88));
  import.pageClass = PageClass::photo;
  CHECK(import.weighed(DoubtCode::pageIsPhoto) == Approx(0.66));
  for (CurvePoint& p : import.press) p.force_N *= 1000;  // a second doubt: both lower the confidence
  CHECK(import.weighed(DoubtCode::implausibleForce) == Approx(0.66 * 0.4));
  import.hints.frame = {{100, 100}, { 500, 500 }};
  import.hints.axes.xMin = import.hints.axes.yMin = 0;
  import.hints.axes.xMax = 4, import.hints.axes.yMax = 4;
  CHECK_FALSE(import.weighed(DoubtCode::pageIsPhoto).has_value());
}

TEST_CASE("one of two curves is called something that is no stroke, and the other's name is not read") {
  Import import;
  import.release = {{3.2, 1.6}, {3, 0.6}, {1.4, 0.3}, {1, 0.4}, { 0, 0.1 }};
  import.traces.resize(2);
  import.traces[0].color = {200, 30, 30}, import.traces[1].color = {30, 30, 200};
  import.traces[1].label = "Clicky";
  CHECK(import.doubted(DoubtCode::namesNoStroke));
  import.hints.trace = {import.traces[0].color, import.traces[1].color, {}};
  CHECK_FALSE(import.doubted(DoubtCode::namesNoStroke));
  import.hints.trace = {};
  // A stroke's word, a word of every curve, a program's own name, and two names, which the rules for legends
  // judge.
  for (const char* name : {"Release", "Force", "Series 2", ""}) {
    import.traces[1].label = name;
    CHECK_FALSE(import.doubted(DoubtCode::namesNoStroke));
  }
  import.traces[0].label = "Loading", import.traces[1].label = "Clicky";
  CHECK_FALSE(import.doubted(DoubtCode::namesNoStroke));
  CHECK_FALSE(import.doubted(DoubtCode::assumed));
  import.traces[0].label = "Plonger", import.traces[1].label = "Sortir";  // words that no list has: said
  CHECK(import.weighed(DoubtCode::assumed) == 0.4);
}

TEST_CASE("the legend names another switch's strokes that were not traced") {
  Import import;
  import.release = {{3.2, 1.6}, {3, 0.6}, {1.4, 0.3}, {1, 0.4}, { 0, 0.1 }};
  import.traces.resize(2);
  import.traces[0].color = {200, 30, 30}, import.traces[1].color = {30, 30, 200};
  import.traces[0].label = "Creamy Yellow press", import.traces[1].label = "Creamy Yellow release";
  for (const CurvePoint& p : import.press) import.traces[0].points_px.push_back(inView(p));
  for (const CurvePoint& p : import.release) import.traces[1].points_px.push_back(inView(p));
  const auto print = [&](const std::string& text) { import.graph.axes.texts.push_back({text, {}, 1.0, 0}); };
  for (const CurveTrace& trace : import.traces) print(trace.label);
  print("Release force 0.3 N");
  CHECK_FALSE(import.doubted(DoubtCode::otherSwitchNamed));
  print("Press 2"), print("Release 2");  // a run of the same switch, hidden by whoever made the page
  CHECK_FALSE(import.doubted(DoubtCode::otherSwitchNamed));
  print("Silent White press"), print("Silent White release");
  CHECK(import.doubted(DoubtCode::otherSwitchNamed));
  import.hints.strokes.curve = "Creamy Yellow";
  CHECK_FALSE(import.doubted(DoubtCode::otherSwitchNamed));
}

/// Both strokes run along the lower end of an axis that begins at 0.3 N.
Import cutBelow() {
  Import below;
  below.press = {{0, 0.2}, {0.4, 0}, {0.5, 0}, {0.6, 0}, {3, 0.5}, {3.2, 1.3}};
  below.release = {{3.2, 1.2}, {3, 0.4}, {1.6, 0}, {1.5, 0}, {1.4, 0}, {0, 0.1}};
  below.graph.axes.calibration.value.viewToUnits = {0.01, 0, -1, 0, -0.01, 5.3, 0, 0, 1};
  return below;
}

TEST_CASE("a plot that shows a part of its curves") {
  Import below;
  below.press = {{0, 0.5}, {0.4, 0.3}, {0.5, 0.3}, {0.6, 0.3}, {3, 0.8}, {3.2, 1.6}};
  CHECK(below.doubts().empty());
  below.graph.axes.calibration.value.viewToUnits = {0.01, 0, -1, 0, -0.01, 5.3, 0, 0, 1};  // from 0.3 N on
  for (CurvePoint& p : below.press) p.force_N -= 0.3;  // their place on the page matters, not their forces
  CHECK(below.doubted(DoubtCode::belowTheAxis));

  // First steep, so that only its end lies on the axis; then so far inside that the hidden part matters.
  below.press = {{0.1, 0}, {0.2, 0.4}, {3, 0.5}, {3.2, 1.3}};
  CHECK(below.doubted(DoubtCode::belowTheAxis));
  below.press = {{0.7, 0}, {0.9, 0.4}, {3, 0.5}, {3.2, 1.3}};
  CHECK(below.weighed(DoubtCode::belowTheAxis) == Approx(0.4));
  below.hints.axes.yMin = 0.3;
  CHECK(below.weighed(DoubtCode::belowTheAxis) == Approx(0.6));

  // Leaves the frame at the lower edge and returns; and a start half a line above that edge.
  Import dips;
  dips.graph.axes.calibration.value.viewToUnits = {0.01, 0, -1, 0, -0.01, 5.3, 0, 0, 1};
  dips.press = {{0.3, 0.03}, {1, 0.4}, {1.6, 0}, {1.8, 0}, {1.9, 0}, {3.2, 1.3}};
  CHECK(dips.weighed(DoubtCode::belowTheAxis) == Approx(0.4));
  dips.press = {{0.3, 0.03}, {1, 0.4}, {1.8, 0}, {1.85, 0}, {1.9, 0}, {3.2, 1.3}};
  CHECK(dips.weighed(DoubtCode::belowTheAxis) == Approx(0.6));

  Import leaves;
  leaves.press.clear();
  for (int i = 0; i <= 400; ++i) leaves.press.push_back({0.01 * i, 0.2 + 0.002 * i});
  leaves.traces.resize(1);
  leaves.traces[0].color = {200, 30, 30};
  for (const CurvePoint& p : leaves.press) leaves.traces[0].points_px.push_back(inView(p));
  Raster& picture = leaves.graph.view.raster;
  picture.rgb.assign(3UL * 700 * 600, 255);
  CHECK(leaves.doubts().empty());
  const auto drawOn = [&](int to) {
    for (int x = 500; x < to; ++x) {
      std::uint8_t* p = picture.rgb.data() +
                        3 * (700 * std::lround(inView({0.01 * (x - 100), 0}).y - 20 - 0.2 * (x - 100)) + x);
      p[0] = 200, p[1] = p[2] = 30;
    }
  };
  drawOn(512);
  CHECK(leaves.weighed(DoubtCode::leavesThePlot) >= confidenceBar);
  drawOn(530);
  CHECK(leaves.weighed(DoubtCode::leavesThePlot) < confidenceBar);  // the frame was cut short

  Import upwards;
  upwards.traces = leaves.traces;
  upwards.graph.view.raster = leaves.graph.view.raster;
  Raster& above = upwards.graph.view.raster;
  upwards.press = {{0, 0.2}};
  for (int i = 0; i <= 100; ++i)
    upwards.press.push_back({3 + 0.001 * i, 1 + 0.03 * i});  // a bottom-out up to the frame's top
  upwards.traces[0].points_px.clear();
  for (const CurvePoint& p : upwards.press) upwards.traces[0].points_px.push_back(inView(p));
  CHECK(upwards.doubts().empty());
  Import broken = upwards;  // the tick labels go on beyond an axis break, the curve does not
  std::vector<TickLabel>& numbers = broken.graph.axes.calibration.value.y.ticks;
  numbers.assign(4, {});
  numbers.back().box = {60, 70, 90, 90};
  CHECK(broken.doubts().empty());
  numbers.back().used = false;
  CHECK(broken.weighed(DoubtCode::leavesThePlot) == Approx(0.4));
  numbers.back().box = {60, 200, 90, 220};  // misread, within the frame
  CHECK(broken.doubts().empty());
  for (int y = 80; y < 100; ++y) {
    std::uint8_t* p = above.rgb.data() + 3 * (700 * y + 410);
    p[0] = 200, p[1] = p[2] = 30;
  }
  CHECK(upwards.weighed(DoubtCode::leavesThePlot) >= confidenceBar);
  Import parted = upwards;  // the rest of the axis stands above a gap, where nothing is drawn
  parted.graph.frame.value.yLines.clear();
  TickLabel tick;
  tick.box = {60, 290, 80, 310}, tick.used = true;
  parted.graph.axes.calibration.value.y.ticks = {tick};
  CHECK(parted.weighed(DoubtCode::leavesThePlot) >= confidenceBar);
  parted.graph.axes.texts = {{"80", {60, 40, 80, 60}, 1, 0}};
  CHECK(parted.weighed(DoubtCode::leavesThePlot) < confidenceBar);
  parted.graph.axes.texts.front().box = {260, 40, 280, 60};  // a title's
  CHECK(parted.weighed(DoubtCode::leavesThePlot) >= confidenceBar);
  upwards.graph.axes.remarks.push_back({RemarkCode::labelContradicts, {"60", "y", "40"}});
  std::vector<TickLabel>& labels = upwards.graph.axes.calibration.value.y.ticks;
  upwards.graph.axes.calibration.value.x.ticks.assign(8, {});
  labels.assign(4, {});
  labels.back().used = false;
  labels.back().box = {60, 200, 90, 220};
  CHECK(upwards.weighed(DoubtCode::leavesThePlot) < confidenceBar);  // a part of another frame
  labels.insert(labels.end(), 20, labels.front());
  CHECK(upwards.weighed(DoubtCode::leavesThePlot) >= confidenceBar);  // one misprint among many
  // the user gave the frame: the result is accepted, and the remark stays
  leaves.hints.frame = {{100, 100}, {500, 500}};
  CHECK(leaves.weighed(DoubtCode::leavesThePlot) >= confidenceBar);
}

TEST_CASE("a bottom-out on the frame's side, in the frame's colour, does not leave the plot below its top") {
  Import withBottomOut;
  withBottomOut.press.clear();
  for (int i = 0; i <= 400; ++i) withBottomOut.press.push_back({0.01 * i, 0.2 + 0.002 * i});
  for (int i = 1; i <= 200; ++i) withBottomOut.press.push_back({4, 1 + 0.01 * i});
  withBottomOut.traces.resize(1);
  withBottomOut.traces[0].color = {200, 30, 30};
  for (const CurvePoint& p : withBottomOut.press) withBottomOut.traces[0].points_px.push_back(inView(p));
  Raster& picture = withBottomOut.graph.view.raster;
  picture.rgb.assign(3UL * 700 * 600, 255);
  for (int y = 100; y < 500; ++y) {
    std::uint8_t* p = picture.rgb.data() + 3 * (700 * y + 500);
    p[0] = 200, p[1] = p[2] = 30;
  }
  CHECK(!withBottomOut.doubted(DoubtCode::leavesThePlot));
}

TEST_CASE("a curve that ends where the picture does, and a second scale") {
  Import cut;
  cut.graph.view.raster.width_px = 421;
  CHECK(cut.doubted(DoubtCode::cutAtPictureEdge));
  Import scales;
  scales.graph.axes.rightScale = RightScale::other;
  CHECK(scales.doubted(DoubtCode::otherScale));
}

TEST_CASE("the doubt about a second scale says what the scale names") {
  struct Row {
    RightScale scale;
    const char *title, *sentence;
  };
  for (const Row& row :
       {Row{RightScale::other, "Voltage (V)",
            "there is a second scale on the right, and it measures \"voltage (V)\""},
        Row{RightScale::other, "Contact [mV]",
            "there is a second scale on the right, and it measures \"mV\""},
        Row{RightScale::other, "", "there is a second scale on the right, and it names no unit of force"},
        Row{RightScale::other, "Force",
            "there is a second scale on the right, and it names no unit of force"},
        Row{RightScale::otherForces, "Force [gf]",
            "there is a second scale on the right, and it also measures forces"}}) {
    CAPTURE(row.title);
    Import scales;
    scales.graph.axes.rightScale = row.scale;
    scales.release = {{3.2, 1.6}, {3, 0.6}, {1.5, 0.3}, {0, 0.1}};
    scales.graph.axes.texts = {{"Time (s)", {20, 250, 40, 350}, 1, 90},  // beside the left axis
                               {"Time (s)", {540, 20, 640, 40}, 1, 0}};  // over the plot
    scales.graph.axes.texts.push_back({row.title, {540, 250, 560, 350}, 1, 90});
    std::vector<std::string> said;
    for (const WeighedDoubt& each : doubtsOf(scales.findings(), scales.checks, scales.hints))
      if (each.doubt.code == DoubtCode::otherScale) said.push_back(english(messageOf(each.doubt)));
    CHECK(said == std::vector<std::string>{row.sentence});
  }
}

TEST_CASE("a second scale is denied by the colours of the curves that count") {
  Import scales;
  scales.graph.axes.rightScale = RightScale::other;
  CHECK(scales.doubted(DoubtCode::otherScale));
  scales.hints.trace.pressColor = Rgb{200, 30, 30};
  CHECK_FALSE(scales.doubted(DoubtCode::otherScale));
}

TEST_CASE("colours do not say which of two scales of forces a curve belongs to") {
  Import scales;
  scales.graph.axes.rightScale = RightScale::otherForces;
  scales.hints.trace.pressColor = Rgb{200, 30, 30};
  CHECK_FALSE(scales.doubted(DoubtCode::otherScale));  // the press alone, of the left graph as requested
  scales.release = {{3.2, 1.6}, {3, 0.6}, {1.5, 0.3}, {0, 0.1}};
  CHECK(scales.doubted(DoubtCode::otherScale));
  // Both colours are given: drawing the same curves again would change nothing.
  scales.hints.trace.releaseColor = Rgb{30, 30, 200};
  for (const WeighedDoubt& each : doubtsOf(scales.findings(), scales.checks, scales.hints))
    if (each.doubt.code == DoubtCode::otherScale)
      CHECK_FALSE(each.doubt.remedies.include(RemedyKind::drawPress));
}

TEST_CASE("a second scale whose curve is known does not touch the strokes") {
  Import scales;
  scales.graph.axes.rightScale = RightScale::other;
  scales.release = {{3.2, 1.6}, {3, 0.6}, {1.5, 0.3}, {0, 0.1}};
  CurveTrace press, release, contact;
  press.color = {200, 0, 0}, release.color = {0, 160, 0}, contact.color = {0, 0, 200};
  for (const CurvePoint& p : scales.press) press.points_px.push_back(inView(p));
  for (const CurvePoint& p : scales.release) release.points_px.push_back(inView(p));
  contact.points_px = {inView({0, 3}), inView({2, 3}), inView({2, 0.1})};
  scales.traces = {press, release, contact};
  CHECK(scales.weighed(DoubtCode::otherScale));
  scales.traces.back().label = "Contact resistance";
  CHECK_FALSE(scales.weighed(DoubtCode::otherScale));
  scales.traces.back().label.clear();
  scales.namedByLegend = true;
  scales.traces[0].label = "Press";  // one name: the other scale's curve may have been taken for the release
  CHECK(scales.weighed(DoubtCode::otherScale));
  scales.traces[1].label = "Release";
  CHECK_FALSE(scales.weighed(DoubtCode::otherScale));
  scales.traces.pop_back();  // the right scale may be a stroke's
  CHECK(scales.weighed(DoubtCode::otherScale));
}

namespace {

/// Gives the requested value by hand, as a user does who follows the advice.
void give(RemedyKind kind, ImportHints& hints) {
  switch (kind) {
    case RemedyKind::giveFrame:
      hints.frame = {{100, 100}, {500, 500}};
      break;
    case RemedyKind::giveXAxis:
      hints.axes.xMin = 0, hints.axes.xMax = 4;
      break;
    case RemedyKind::giveYAxis:
      hints.axes.yMin = 0, hints.axes.yMax = 4;
      break;
    case RemedyKind::giveXUnit:
      hints.axes.xUnit = LengthUnit::millimetre;
      break;
    case RemedyKind::giveYUnit:
      hints.axes.yUnit = ForceUnit::newton;
      break;
    case RemedyKind::pickPress:
      hints.trace.pressColor = Rgb{};
      break;
    case RemedyKind::pickRelease:
      hints.trace.releaseColor = Rgb{};
      break;
    case RemedyKind::setResolution:
      hints.dpi = 300;
      break;
    case RemedyKind::noRelease:
      hints.strokes.noRelease = true;
      break;
    case RemedyKind::drawPress:
      hints.drawn.press = {{0, 0}, {1, 1}};
      break;
    case RemedyKind::drawRelease:
      hints.drawn.release = {{0, 0}, {1, 1}};
      break;
    case RemedyKind::chooseSwitch:
      hints.strokes.curve = "1";
      break;
    default:
      break;
  }
}

}  // namespace

TEST_CASE("what was given by hand is not requested again, and something is always left to try") {
  Import pulls;
  pulls.press = {{-1, -0.5}, {1, -0.7}, {1.5, -0.5}, {3, 0.1}};
  pulls.release = {{3, 0.1}, {2, 0.9}, {-1, -0.5}};
  pulls.graph.axes.rightScale = RightScale::other;
  pulls.graph.axes.calibration.value.x.unitFound = false;
  pulls.graph.axes.calibration.value.y.otherQuantity = "kPa";
  pulls.tactilePoints = 9;
  pulls.pageClass = PageClass::photo;
  for (int step = 0; step < 12; ++step) {
    const auto doubts = doubtsOf(pulls.findings(), pulls.checks, pulls.hints);
    REQUIRE_FALSE(doubts.empty());  // no hint makes a pull a press
    std::optional<RemedyKind> next;
    for (const WeighedDoubt& each : doubts) {
      INFO(nameOf(each.doubt.code));
      CHECK_FALSE(each.doubt.remedies.empty());
      for (const Remedy& remedy : each.doubt.remedies) {
        ImportHints given = pulls.hints;
        give(remedy.kind, given);
        const bool asksAnew = remedy.kind == RemedyKind::addMask || remedy.kind == RemedyKind::advice ||
                              remedy.kind == RemedyKind::acceptAsIs;
        CHECK((asksAnew || given != pulls.hints));
        if (!asksAnew) next = remedy.kind;
      }
    }
    if (!next) return;
    give(*next, pulls.hints);
  }
  FAIL("twelve times asked, and not at an end");
}

TEST_CASE("after the last hint the strokes are drawn by hand, then the person's word counts") {
  ImportHints hints;
  hints.axes.xMin = 0, hints.axes.xMax = 4;
  hints.trace.pressColor = Rgb{};
  const Remedies ofAxes = RemedyKind::giveXAxis, ofCurves = RemedyKind::pickPress;
  for (const Remedies& wanted : {ofAxes, ofCurves})
    CHECK(commandLineWords(leftToTry(wanted, {})) == commandLineWords(wanted));
  CHECK(commandLineWords(leftToTry(ofAxes, hints)).find("--sure") !=
        std::string::npos);  // no line helps there
  CHECK(commandLineWords(leftToTry(ofCurves, hints)).find("--press-line") != std::string::npos);
  hints.drawn.press = {{0, 0}, {1, 1}};
  CHECK(commandLineWords(leftToTry(ofCurves, hints)).find("--sure") != std::string::npos);
  CHECK(leftToTry({}, hints).empty());
}

TEST_CASE("points that make no curve are refused, however sure the steps before were") {
  const Import import;
  const auto taken = assembleReport(import.findings(1), {}, {});
  INFO((taken.ok() ? "" : taken.failure().sentence()));
  CHECK(taken.ok());
  const auto refused = assembleReport(import.findings(50), {}, {});
  REQUIRE_FALSE(refused.ok());
  INFO(refused.failure().sentence());
  CHECK(refused.failure().code == FailureCode::notCertain);
  CHECK(refused.failure().sentence().find("50") != std::string::npos);
}

TEST_CASE("a doubt too small to refuse is said once, and kept in the button's file") {
  const auto taken = assembleReport(cutBelow().findings(), {}, {});
  REQUIRE(taken.ok());
  CHECK(taken->confidence == Approx(0.6));
  const auto said = [](const auto& remarks, auto isIt) {
    return std::count_if(remarks.begin(), remarks.end(), isIt);
  };
  CHECK(said(taken->remarks, [](const Remark& r) { return r.code == RemarkCode::doubted; }) == 1);
  const auto& kept = taken->button.provenance()->warnings;
  CHECK(said(kept, [](const RecordedWarning& w) { return w.code == nameOf(RemarkCode::doubted); }) == 1);

  ImportRequest surer;
  surer.sure = 0.7;
  const auto refused = assembleReport(cutBelow().findings(), {}, surer);
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.failure().code == FailureCode::notCertain);
}

TEST_CASE("a refusal that one answer settles is a question") {
  ImportHints hints;
  const auto optionsOf = [&](DoubtCode code, const Remedies& remedies, const GraphEvidence* evidence) {
    Failure failure{FailureCode::notCertain, "plot.png", {}, Message("refused"), remedies};
    failure.reason = nameOf(code);
    std::vector<std::string> options;
    if (const auto question = questionAbout(failure, evidence, hints))
      for (const auto& choice : question->choices) options.push_back(choice.option);
    return options;
  };
  CHECK(optionsOf(DoubtCode::unitMissing, RemedyKind::giveXUnit, nullptr) ==
        std::vector<std::string>{"--x-unit mm", "--x-unit um", "--x-unit in", "--x-unit mil"});
  CHECK(optionsOf(DoubtCode::unitMissing, RemedyKind::giveYUnit, nullptr).front() == "--y-unit N");
  CHECK(optionsOf(DoubtCode::unitMissing, {{RemedyKind::giveXUnit, {}}, {RemedyKind::giveYUnit, {}}}, nullptr)
            .empty());
  CHECK(optionsOf(DoubtCode::severalSwitches, {}, nullptr).empty());

  GraphEvidence evidence;
  evidence.traces.resize(2);
  evidence.traces[0].color = {0xc8, 0x10, 0x2e}, evidence.traces[1].color = {0x0b, 0x5c, 0xad};
  CHECK(optionsOf(DoubtCode::strokesAlike, {}, &evidence) ==
        std::vector<std::string>{"--press-color #c8102e --release-color #0b5cad",
                                 "--press-color #0b5cad --release-color #c8102e",
                                 "--press-color #c8102e --no-release", "--press-color #0b5cad --no-release"});
  hints.trace.pressColor = evidence.traces[0].color;  // the release is still a question
  CHECK(optionsOf(DoubtCode::releaseAbovePress, RemedyKind::pickRelease, &evidence) ==
        std::vector<std::string>{"--release-color #0b5cad", "--no-release"});
  CHECK(optionsOf(DoubtCode::pageIsScan, RemedyKind::giveFrame, &evidence).empty());
  hints.strokes.noRelease = true;
  CHECK(optionsOf(DoubtCode::releaseAbovePress, RemedyKind::pickRelease, &evidence).empty());
  hints = {};
  evidence.traces[1].color = evidence.traces[0].color;
  CHECK(optionsOf(DoubtCode::strokesAlike, {}, &evidence).empty());
  evidence.switches.resize(2);
  evidence.switches[0].name = "Brown";
  CHECK(optionsOf(DoubtCode::severalSwitches, {}, &evidence) ==
        std::vector<std::string>{"--curve 1", "--curve 2"});

  CHECK(takeUp({"", "--press-color #c8102e --release-color #0b5cad"}, hints));
  CHECK(hints.trace.pressColor == Rgb{0xc8, 0x10, 0x2e});
  CHECK(hints.trace.releaseColor == Rgb{0x0b, 0x5c, 0xad});
  CHECK_FALSE(hints.strokes.noRelease);
  CHECK(takeUp({"", "--press-color #c8102e --no-release"}, hints));
  CHECK(hints.strokes.noRelease);
  CHECK(takeUp({"", "--curve 2"}, hints));
  CHECK(hints.strokes.curve == "2");
  CHECK_FALSE(takeUp({"", "--frame 1,2,3,4"}, hints));
}
