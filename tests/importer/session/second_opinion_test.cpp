// SPDX-License-Identifier: GPL-3.0-or-later
// Several readings of one page: agreement, contradiction, and a reading taken in place of another.

#include "importer/second_opinion.h"

#include <algorithm>

#include <catch2/catch.hpp>

using namespace detent;
using namespace detent::importer;

namespace {

constexpr double sure = confidenceBar;

/// A press and a release over this travel, up to this force.
ImportReport reportOf(double travel_mm, double highest_N, double confidence) {
  const auto curve = [&](double share) {
    return StrokeCurve::throughPoints({{0, 0}, {travel_mm, share * highest_N}}).value();
  };
  auto graph = ForceGraph::fromCurves(curve(1), curve(0.8));
  REQUIRE(graph);
  ImportReport report(Button::fromStates("plot", {{"", std::move(graph).value(), {}, {}, {}}}).value());
  report.x = AxisReading{}, report.y = AxisReading{};
  report.x->unit = "mm", report.y->unit = "N";
  report.x->unit = "mm", report.y->unit = "N";
  report.release = StrokeReport{};
  report.strokes.release.emplace();
  for (int i = 0; i <= 100; ++i) {
    const double at = i / 100.0;
    report.strokes.press.points.push_back({at * travel_mm, at * highest_N});
    report.strokes.release->points.insert(report.strokes.release->points.begin(),
                                          {at * travel_mm, 0.8 * at * highest_N});
  }
  report.confidence = confidence;
  return report;
}

PageReading certain(double magnification, double travel_mm, double confidence = 0.9) {
  return {magnification, {reportOf(travel_mm, 1, confidence), {}}};
}

PageReading doubted(double magnification, double travel_mm, DoubtCode code, double confidence = 0.4) {
  PageReading reading = certain(magnification, travel_mm, confidence);
  reading.attempt.report->doubt = Doubt{code};
  return reading;
}

PageReading failed(double magnification, Failure why) { return {magnification, {std::move(why), {}}}; }

PageReading unasked() {
  FAIL("the third look was not to be asked for");
  return failed(1.5, Failure{});
}

double travelOf(const ImportAttempt& attempt) {
  return attempt.report->button.states().front().graph.travel_mm();
}

bool says(const ImportReport& report, RemarkCode code) {
  return std::ranges::find(report.remarks, code, &Remark::code) != report.remarks.end();
}

const Failure noRow{FailureCode::noForceGraph, "plot frame", {}, "no row of numbers stands along it", {}};

}  // namespace

TEST_CASE("the most prominent tactile point is named, and those that rival it") {
  struct Row {
    std::vector<double> prominences_N;
    const char* text;
  };
  const Row row = GENERATE(values<Row>({
      {{}, "no tactile point"},
      {{0.02, 0.19, 0.01}, "tactile point 2.000 mm 0.500 N"},
      {{0.1, 0.02, 0.19}, "tactile point 1.000 mm 0.500 N or 3.000 mm 0.500 N"},
  }));
  ImportReport report = reportOf(4, 1, 0.9);
  for (std::size_t i = 0; i < row.prominences_N.size(); ++i)
    report.press.fit.tactilePoints.push_back({{double(i + 1), 0.5, row.prominences_N[i]}});
  CHECK(report.brief().find(std::string(row.text) + "; release") != std::string::npos);
}

TEST_CASE("Two certain readings that agree leave the first as it is and are kept", "[second opinion]") {
  const auto best = settled(certain(1, 4), certain(2, 4.01), unasked, sure);
  REQUIRE(best.report);
  CHECK(travelOf(best) == Approx(4));
  CHECK(best.report->confidence == 0.9);
  CHECK(best.report->remarks.empty());
  REQUIRE(best.report->readings.size() == 2);
  CHECK(best.report->readings[0].taken);
  CHECK_FALSE(best.report->readings[1].taken);
  CHECK(best.report->readings[1].travel_mm.value() == Approx(4.01));
}

TEST_CASE("Two certain readings that differ are both reported, and nothing is picked", "[second opinion]") {
  const auto best = settled(certain(1, 4), certain(2, 8), unasked, sure);
  REQUIRE(best.report);
  REQUIRE(best.report->doubt);
  CHECK(best.report->doubt->code == DoubtCode::readingsDiffer);
  CHECK(best.report->confidence < sure);
  const std::string words = english(messageOf(*best.report->doubt));
  CHECK_THAT(words, Catch::Contains("4 mm"));
  CHECK_THAT(words, Catch::Contains("8 mm"));
}

TEST_CASE("The much surer reading is taken, and the other is reported beside it", "[second opinion]") {
  const auto best = settled(certain(1, 4, 0.95), certain(2, 8, 0.7), unasked, sure);
  REQUIRE(best.report);
  CHECK_FALSE(best.report->doubt);
  CHECK(best.report->confidence == 0.95);
  CHECK(says(*best.report, RemarkCode::doubted));
  // A request for more confidence than there is gets the doubt.
  CHECK(settled(certain(1, 4, 0.95), certain(2, 8, 0.7), unasked, 0.97).report->doubt);
}

TEST_CASE("A stroke that one reading alone finds is a difference", "[second opinion]") {
  PageReading pressAlone = certain(2, 4);
  pressAlone.attempt.report->release.reset();
  pressAlone.attempt.report->strokes.release.reset();
  const auto best = settled(certain(1, 4), std::move(pressAlone), unasked, sure);
  REQUIRE(best.report->doubt);
  CHECK_THAT(english(messageOf(*best.report->doubt)), Catch::Contains("no release"));
}

TEST_CASE("An uncertain second reading changes nothing", "[second opinion]") {
  const auto best = settled(certain(1, 4), doubted(2, 8, DoubtCode::axesUncertain), unasked, sure);
  CHECK_FALSE(best.report->doubt);
  CHECK(best.report->confidence == 0.9);
  CHECK(best.report->readings[1].problem.empty() == false);
}

TEST_CASE("Two other readings that agree replace an uncertain one", "[second opinion]") {
  const auto first = GENERATE(0, 1);
  PageReading uncertain = first == 0 ? doubted(1, 6, DoubtCode::axesUncertain)
                                     : failed(1, failureOf({DoubtCode::rangeUnreadable, {6, "x"}}));
  const auto best = settled(
      std::move(uncertain), certain(2, 4), [] { return certain(1.5, 4.01, 0.7); }, sure);
  REQUIRE(best.report);
  CHECK(travelOf(best) == Approx(4));
  CHECK_FALSE(best.report->doubt);
  CHECK(best.report->confidence == 0.7);  // as sure as the less sure of both
  CHECK(best.report->button.provenance()->confidence == 0.7);
  REQUIRE(says(*best.report, RemarkCode::secondReadingTaken));
  CHECK_THAT(english(messageOf(best.report->remarks.back())),
             Catch::Contains(first == 0 ? "a travel of 6 mm" : "do not form an even scale"));
  REQUIRE(best.report->readings.size() == 3);
  CHECK(best.report->readings[1].taken);
}

TEST_CASE("One other reading alone does not", "[second opinion]") {
  SECTION("the third reads another button") {
    const auto best = settled(
        doubted(1, 6, DoubtCode::axesUncertain), certain(2, 4), [] { return certain(1.5, 5); }, sure);
    CHECK(best.report->doubt);
    CHECK(travelOf(best) == Approx(6));
  }
  SECTION("the required confidence is higher") {
    const auto third = [] { return certain(1.5, 4, 0.95); };
    const auto best = settled(doubted(1, 6, DoubtCode::axesUncertain), certain(2, 4, 0.95), third, 0.9);
    CHECK(best.report->doubt);
    CHECK(travelOf(best) == Approx(6));
  }
  SECTION("the third is not certain") {
    const auto third = [] { return doubted(1.5, 4, DoubtCode::axesUncertain); };
    CHECK(settled(doubted(1, 6, DoubtCode::curveLeftOver), certain(2, 4), third, sure).report->doubt);
  }
}

TEST_CASE("What stands on the page is not read away", "[second opinion]") {
  for (const DoubtCode code :
       {DoubtCode::thousandsUnclear, DoubtCode::otherQuantity, DoubtCode::valueContradicts}) {
    CHECK_FALSE(anotherMaySettle(doubted(1, 4, code).attempt));
    const auto best = settled(doubted(1, 4, code), certain(2, 4), unasked, sure);
    CHECK(best.report->doubt);
  }
  CHECK_FALSE(anotherMaySettle({failureOf({DoubtCode::severalSwitches}), {}}));
  CHECK_FALSE(anotherMaySettle({Failure{FailureCode::wrongUsage, {}, {}, "there is no such graph", {}}, {}}));
  CHECK_FALSE(anotherMaySettle({noRow, {}}));
  CHECK(anotherMaySettle({failureOf({DoubtCode::rangeUnreadable}), {}}));
  CHECK(anotherMaySettle(doubted(1, 4, DoubtCode::curveLeftOver).attempt));
}

TEST_CASE("A photograph is worth more where three readings agree", "[second opinion]") {
  const auto photo = [](double magnification, double travel_mm) {
    return doubted(magnification, travel_mm, DoubtCode::pageIsPhoto, 0.45);
  };
  SECTION("alike") {
    const auto best = settled(
        photo(1, 4), photo(2, 4.01), [&] { return photo(1.5, 3.99); }, sure);
    CHECK_FALSE(best.report->doubt);
    CHECK(best.report->confidence > sure);
    CHECK(best.report->confidence < 0.66);
    CHECK(says(*best.report, RemarkCode::doubted));
    CHECK(travelOf(best) == Approx(4));
  }
  SECTION("one differs") {
    CHECK(settled(photo(1, 4), photo(2, 5), unasked, sure).report->doubt);
    CHECK(settled(
              photo(1, 4), photo(2, 4), [&] { return photo(1.5, 5); }, sure)
              .report->doubt);
  }
  SECTION("one has another doubt") {
    CHECK(settled(photo(1, 4), doubted(2, 4, DoubtCode::curveLeftOver), unasked, sure).report->doubt);
  }
  SECTION("still below the required confidence") {
    CHECK(settled(
              photo(1, 4), photo(2, 4), [&] { return photo(1.5, 4); }, 0.9)
              .report->doubt);
  }
}

TEST_CASE("Small pictures are looked at larger, large ones smaller, documents both", "[second opinion]") {
  Page page;
  page.unit = PageUnit::pixel;
  page.overview.width_px = 800, page.overview.height_px = 600;
  CHECK(otherSizesOf(page).second > 1);
  page.overview.width_px = 8000, page.overview.height_px = 6000;
  CHECK(otherSizesOf(page).second < 1);
  CHECK(otherSizesOf(page).third < 1);
  page.unit = PageUnit::point;
  CHECK(otherSizesOf(page).second > 1);
  CHECK(otherSizesOf(page).third < 1);
}
