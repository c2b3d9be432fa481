// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "importer/axes/read_text.h"
#include "importer/importer.h"
#include "tests/importer/frame/drawn_plot.h"

using namespace detent;
using namespace detent::importer;
using namespace detent::importer::test;

namespace {

const std::string plots = std::string(DETENT_SOURCE_DIR) + "/samples/plots/";

ImportSession opened(const char* name) {
  auto session = ImportSession::open(plots + name);
  REQUIRE(session);
  return std::move(session).value();
}

ImportRequest firstGraph() {
  ImportRequest request;
  request.page = 1, request.graph = 1;
  return request;
}

ImportReport imported(ImportSession& session, const ImportRequest& request) {
  auto report = session.importGraph(request);
  REQUIRE(report);
  return std::move(report).value();
}

double travel_mm(const ImportReport& report) { return report.button.states().front().graph.travel_mm(); }

/// An empty plot of 0 to 1 mm and 0 to 5 N, and its places: 0 to 1 along both axes.
cv::Point placeOnPlot(double x, double y) {
  return {static_cast<int>(100 + 600 * x), static_cast<int>(560 - 450 * y)};
}
cv::Mat emptyPlot() {
  cv::Mat plot(640, 960, CV_8UC3, cv::Scalar::all(255));
  const auto at = placeOnPlot;
  const cv::Scalar black = cv::Scalar::all(0), grid = cv::Scalar::all(215);
  for (int i = 0; i <= 5; ++i) {
    cv::line(plot, at(0.2 * i, 0), at(0.2 * i, 1), grid);
    cv::line(plot, at(0, 0.2 * i), at(1, 0.2 * i), grid);
    cv::putText(plot, "0." + std::to_string(2 * i), at(0.2 * i, 0) + cv::Point(-16, 28),
                cv::FONT_HERSHEY_SIMPLEX, 0.6, black, 1, cv::LINE_AA);
    cv::putText(plot, std::to_string(i), at(0, 0.2 * i) + cv::Point(-26, 7), cv::FONT_HERSHEY_SIMPLEX, 0.6,
                black, 1, cv::LINE_AA);
  }
  cv::rectangle(plot, at(1, 0) + cv::Point(-18, 10), at(1, 0) + cv::Point(24, 34), cv::Scalar::all(255), -1);
  cv::putText(plot, "1.0", at(1, 0) + cv::Point(-16, 28), cv::FONT_HERSHEY_SIMPLEX, 0.6, black, 1,
              cv::LINE_AA);
  cv::line(plot, at(0, 0), at(1, 0), black), cv::line(plot, at(0, 0), at(0, 1), black);
  cv::putText(plot, "Travel [mm]", at(0.4, 0) + cv::Point(0, 60), cv::FONT_HERSHEY_SIMPLEX, 0.6, black, 1,
              cv::LINE_AA);
  cv::putText(plot, "Force [N]", at(0, 1) + cv::Point(-60, -30), cv::FONT_HERSHEY_SIMPLEX, 0.6, black, 1,
              cv::LINE_AA);
  return plot;
}

ImportSession sessionOf(const cv::Mat& plot) {
  std::vector<unsigned char> bytes;
  REQUIRE(cv::imencode(".png", plot, bytes));
  auto session = ImportSession::fromBytes(std::move(bytes), "plot.png");
  REQUIRE(session);
  return std::move(session).value();
}

}  // namespace

TEST_CASE("A hint runs the steps that depend on it and no others") {
  auto session = opened("white-vector.pdf");
  ImportRequest request = firstGraph();
  const ImportReport found = imported(session, request);
  for (const ImportStep step :
       {ImportStep::locate, ImportStep::texts, ImportStep::trace, ImportStep::strokes, ImportStep::fit})
    CHECK(found.seconds.count(step) == 1);

  request.hints.axes.xMin = 0, request.hints.axes.xMax = 9;
  const ImportReport wider = imported(session, request);  // the page prints 4.5
  CHECK(std::ranges::any_of(wider.remarks, [](const Remark& r) { return r.code == RemarkCode::doubted; }));
  CHECK(travel_mm(wider) == Approx(2 * travel_mm(found)).epsilon(1e-3));
  CHECK(wider.seconds.count(ImportStep::axes) == 1);
  for (const ImportStep step : {ImportStep::locate, ImportStep::texts, ImportStep::trace})
    CHECK(wider.seconds.count(step) == 0);
  CHECK(wider.x->ticks.size() == found.x->ticks.size());  // still there, for a person to see
  for (const TickLabel& tick : wider.x->ticks) CHECK_FALSE(tick.used);

  request.hints.axes = {};
  const ImportReport again = imported(session, request);
  CHECK(again.button.states() == found.button.states());
  CHECK(again.seconds.count(ImportStep::axes) == 0);  // the axes were kept, not read again

  request.hints.strokes.swap = true;
  CHECK(imported(session, request).seconds.count(ImportStep::trace) == 0);
  request.hints.trace.masks_px = {{0, 0, 5, 5}};
  const ImportReport masked = imported(session, request);
  CHECK(masked.seconds.count(ImportStep::trace) == 1);
  CHECK(masked.seconds.count(ImportStep::locate) == 0);
}

TEST_CASE("The contact points that the sample plots call out are read, across the lines of their grids") {
  if (!TextReader::available()) {
    WARN("SKIPPED: no Tesseract language data");
    return;
  }
  struct Case {
    const char* name;
    double operating_mm;
    std::optional<double> reset_mm;  // samples/plots/MANIFEST.md; empty: a gridline hides a letter of it
  };
  const auto& [name, operating_mm, reset_mm] = GENERATE(values<Case>(
      {{"brown-one-ink.png", 2, 1.7}, {"black-red-curves.png", 2, 2}, {"white-chinese-gf.png", 2, {}}}));
  INFO(name);
  auto session = opened(name);
  const auto report = imported(session, firstGraph());
  const ButtonState& state = report.button.states().front();
  REQUIRE(state.operatingPoint_mm);
  CHECK(*state.operatingPoint_mm == Approx(operating_mm).margin(0.03));
  if (!reset_mm) return;
  REQUIRE(state.resetPoint_mm);
  CHECK(*state.resetPoint_mm == Approx(*reset_mm).margin(0.03));
}

TEST_CASE("A graph with exchanged or uneven axes is refused by that name before its curves are traced") {
  if (!TextReader::available()) {
    WARN("SKIPPED: no Tesseract language data");
    return;
  }
  PlotStyle s;
  DoubtCode expected = DoubtCode::axesExchanged;
  SECTION("exchanged") {
    s.xTitle = "Force [N]", s.yTitle = "Travel [mm]";
    s.xStep = 20, s.yStep = 0.5;
  }
  SECTION("of something else") {
    s.xTitle = "Time [s]";
    expected = DoubtCode::otherQuantity;
  }
  std::vector<unsigned char> png;
  REQUIRE(cv::imencode(".png", drawn(s), png));
  auto session = ImportSession::fromBytes(std::move(png), "drawn.png");
  REQUIRE(session);
  ImportRequest request = firstGraph();
  request.hints.frame = {{s.left, s.top}, {s.right, s.bottom}};
  request.acceptDoubt = true;  // no person's word makes a button of it
  const auto attempt = session->attempt(request);
  REQUIRE_FALSE(attempt.report);
  INFO(english(attempt.report.failure().problem));
  CHECK(attempt.report.failure().reason == nameOf(expected));
  REQUIRE(attempt.evidence);
  CHECK(attempt.evidence->traces.empty());
  CHECK(attempt.report.failure().remedies.include(RemedyKind::giveXUnit) ==
        (expected == DoubtCode::otherQuantity));
}

TEST_CASE("Hints of a numbered graph do not change which graphs the page has") {
  auto session = opened("two-level-legend.png");
  const auto before = session.list(1);
  REQUIRE(before);
  ImportRequest request = firstGraph();
  request.hints.axes = {0, 10, 0, 10, LengthUnit::millimetre, ForceUnit::newton};
  CHECK(imported(session, request).confidence > confidenceBar);
  const auto after = session.list(1);
  REQUIRE(after);
  REQUIRE(after->graphs.size() == before->graphs.size());
  CHECK(after->graphs.front().x.max == Approx(3.5));  // a list without hints says what the page says
  CHECK(after->graphs.front().confidence == before->graphs.front().confidence);
}

TEST_CASE("A given frame keeps the graph's number and its axes follow their own hints") {
  auto session = opened("brown-one-ink.png");
  const auto listed = session.list(1);
  REQUIRE(listed);
  const Box box = listed->graphs.front().frame;
  ImportRequest request = firstGraph();
  request.graph = 3;
  request.hints.frame = {{box.x0, box.y0}, {box.x1, box.y1}};
  const ImportReport report = imported(session, request);
  CHECK(report.graph == 3);
  request.hints.axes.yUnit = ForceUnit::gramForce;
  const ImportReport inGrams = imported(session, request);
  CHECK(inGrams.seconds.count(ImportStep::locate) == 0);
  CHECK(inGrams.y->unit == "gf");
}

TEST_CASE("A doubt is a failure, or comes with the result where a person will check it") {
  auto session = opened("white-vector.pdf");
  ImportRequest request = firstGraph();
  const auto listed = session.list(1);
  REQUIRE(listed);
  const Box box = listed->graphs.front().frame;
  // The lower left quarter of the plot: the curves are cut off and the numbers belong elsewhere.
  request.hints.frame = {{box.x0, 0.5 * (box.y0 + box.y1)}, {0.5 * (box.x0 + box.x1), box.y1}};
  request.hints.axes = {0, 2, 0, 900, {}, {}};
  const auto strict = session.importGraph(request);
  request.acceptDoubt = true;
  const auto [lenient, evidence, question, interpretations] = session.attempt(request);
  if (strict) {
    CHECK(lenient);
    CHECK_FALSE(lenient->doubt);
  } else if (lenient) {
    REQUIRE(lenient->doubt);
    CHECK_FALSE(nameOf(lenient->doubt->code).empty());
    CHECK_FALSE(lenient->doubt->remedies.empty());
    CHECK(lenient->evidence->steps.size() == 3);
  } else {
    CHECK(evidence);
  }
}

TEST_CASE("A button keeps in its file which units its user accepted as a guess") {
  if (!TextReader::available()) {
    WARN("SKIPPED: no Tesseract language data");
    return;
  }
  PlotStyle s;
  s.xTitle = "Travel", s.yTitle = "Force";
  std::vector<unsigned char> png;
  REQUIRE(cv::imencode(".png", drawn(s), png));
  auto session = ImportSession::fromBytes(std::move(png), "drawn.png");
  REQUIRE(session);
  ImportRequest request = firstGraph();
  request.acceptDoubt = true;
  const auto attempt = session->attempt(request);
  REQUIRE(attempt.report);
  REQUIRE(attempt.report->doubt);
  std::string all;
  for (const RecordedWarning& warning : attempt.report->button.provenance()->warnings)
    all += warning.text + "\n";
  CHECK_THAT(all, Catch::Contains("not certain: no unit for lengths was found at the x axis"));
  CHECK_THAT(all, Catch::Contains("not certain: no unit for forces was found at the y axis"));
}

TEST_CASE("A failed import gives what was found so far; a good one what its report holds") {
  auto session = opened("two-level-legend.png");
  ImportRequest request = firstGraph();
  request.hints.trace.masks_px = {{-1, -1, 1e5, 1e5}};  // no marks are left
  const auto [failed, evidence, question, interpretations] = session.attempt(request);
  CHECK_FALSE(failed);
  REQUIRE(evidence);
  CHECK(evidence->axes.calibration.value.x.max == Approx(3.5));
  CHECK(evidence->steps.front().step == ImportStep::locate);
  request.hints = {};
  const auto good = session.attempt(request);
  REQUIRE(good.report);
  CHECK(good.evidence == good.report->evidence);
}

TEST_CASE("A button keeps the frame on which its axes end, in units of the page") {
  for (const char* name : {"brown-one-ink.png", "white-chinese-gf.png", "white-vector.pdf"}) {
    INFO(name);
    auto session = opened(name);
    const ImportReport report = imported(session, firstGraph());
    REQUIRE(report.evidence);
    const GraphEvidence& seen = *report.evidence;
    const Box onPage = seen.view.viewToPage.boxOf(seen.frame.box());
    const std::vector<double> kept = report.button.provenance()->frame;
    REQUIRE(kept.size() == 4);
    CHECK(kept[0] == Approx(onPage.x0).margin(0.01));
    CHECK(kept[1] == Approx(onPage.y0).margin(0.01));
    CHECK(kept[2] == Approx(onPage.x1).margin(0.01));
    CHECK(kept[3] == Approx(onPage.y1).margin(0.01));
    // Its right edge is where the axis ends.
    const Point topRight = seen.axes.calibration.value.toUnits({seen.frame.box().x1, seen.frame.box().y0});
    CHECK(topRight.x == Approx(seen.axes.calibration.value.x.max).epsilon(0.002));
  }
}

TEST_CASE("A document from memory is imported as one from a file") {
  std::ifstream in(plots + "brown-one-ink.png", std::ios::binary);
  std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(in), {}};
  REQUIRE(!bytes.empty());
  auto session = ImportSession::fromBytes(std::move(bytes), "Pasted picture");
  REQUIRE(session);
  auto fromFile = opened("brown-one-ink.png");
  const ImportReport pasted = imported(*session, firstGraph()), filed = imported(fromFile, firstGraph());
  CHECK(pasted.button.states() == filed.button.states());
  CHECK(pasted.button.provenance()->sourceFile == "Pasted picture");
  CHECK(pasted.button.provenance()->sourceSha256 == filed.button.provenance()->sourceSha256);
  CHECK_FALSE(ImportSession::fromBytes({}, "nothing"));
}

// Lines scaled up are off by more pixels, and a filter with lobes leaves pale copies beside them: neither is
// a doubt.
TEST_CASE("A plot that imports at its own size imports scaled up to the most pixels that are read") {
  const cv::Mat plot = cv::imread(plots + "black-red-curves.png");
  REQUIRE(!plot.empty());
  auto fromFile = opened("black-red-curves.png");
  const ImportReport usual = imported(fromFile, firstGraph());
  for (const auto& [times, filter] : {std::pair(6.8, cv::INTER_CUBIC), std::pair(3.0, cv::INTER_LANCZOS4)}) {
    cv::Mat large;  // 14 megapixels; 3
    cv::resize(plot, large, {}, times, times, filter);
    std::vector<unsigned char> bytes;
    REQUIRE(cv::imencode(".png", large, bytes, {cv::IMWRITE_PNG_COMPRESSION, 1}));
    auto session = ImportSession::fromBytes(std::move(bytes), "large.png");
    REQUIRE(session);
    const ImportReport report = imported(*session, firstGraph());
    CHECK(travel_mm(report) == Approx(travel_mm(usual)).margin(0.02));
    CHECK(report.evidence->view.raster.width_px < 2000);  // read in as many pixels as it takes
  }
}

// The strokes of a key with two snaps cross; that they end in one point is drawn beyond the frame.
TEST_CASE("Strokes that resemble two switches' within the frame are followed beyond it first") {
  cv::Mat plot = emptyPlot();
  const auto at = placeOnPlot;
  const std::vector<cv::Point> down{at(0, 0),      at(0.2, 0.35),  at(0.5, 0.6),  at(0.62, 0.3),
                                    at(0.9, 0.55), at(1.01, 0.66), at(1.08, 0.95)},
      up{at(0, 0),      at(0.15, 0.22), at(0.42, 0.42), at(0.5, 0.25),
         at(0.6, 0.37), at(0.9, 0.46),  at(1.04, 0.55), at(1.08, 0.95)};
  cv::polylines(plot, up, false, {200, 60, 20}, 2, cv::LINE_AA);
  cv::polylines(plot, down, false, {30, 30, 210}, 2, cv::LINE_AA);
  ImportSession session = sessionOf(plot);
  const ImportReport report = imported(session, firstGraph());
  CHECK(travel_mm(report) == Approx(1.08).margin(0.02));
}

TEST_CASE("A press given by hand does not make another switch's press its release") {
  cv::Mat plot = emptyPlot();
  const auto at = placeOnPlot;
  const auto curve = [&](const std::vector<cv::Point>& points, const cv::Scalar& color) {
    cv::polylines(plot, points, false, color, 2, cv::LINE_AA);
  };
  const std::vector<cv::Point> upper{at(0, 0), at(0.2, 0.45), at(0.5, 0.6), at(0.7, 0.55), at(0.82, 0.95)};
  curve({at(0, 0), at(0.15, 0.2), at(0.45, 0.35), at(0.6, 0.25), at(0.9, 0.4), at(0.98, 0.8)}, {200, 60, 20});
  curve(upper, {30, 30, 210});
  ImportSession session = sessionOf(plot);
  ImportRequest request = firstGraph();
  request.asks = true;
  for (const cv::Point& p : upper) request.hints.drawn.press.push_back({double(p.x), double(p.y)});
  const ImportAttempt attempt = session.attempt(request);
  REQUIRE_FALSE(attempt.report.ok());
  INFO(attempt.report.failure().sentence());
  CHECK(attempt.report.failure().remedies.include(RemedyKind::noRelease));
  REQUIRE(attempt.question);
  CHECK(attempt.question->choices.back().option == "--no-release");
  for (const Choice& choice : attempt.question->choices) {
    CAPTURE(choice.option);
    ImportRequest answered = request;
    REQUIRE(takeUp(choice, answered.hints));
    const ImportReport report = imported(session, answered);
    CHECK(report.release.has_value() == (choice.option != "--no-release"));
    CHECK(travel_mm(report) == Approx(0.82).margin(0.02));
  }
}

TEST_CASE("A picked colour that is on no curve is refused by name, and does not leave out its stroke") {
  cv::Mat plot = emptyPlot();
  const auto at = placeOnPlot;
  const auto curve = [&](const std::vector<cv::Point>& points, const cv::Scalar& color) {
    cv::polylines(plot, points, false, color, 2, cv::LINE_AA);
  };
  curve({at(0, 0), at(0.2, 0.45), at(0.5, 0.6), at(0.7, 0.55), at(0.82, 0.95)}, {30, 30, 210});
  curve({at(0, 0), at(0.2, 0.25), at(0.5, 0.4), at(0.7, 0.35), at(0.82, 0.95)}, {200, 60, 20});
  ImportSession session = sessionOf(plot);
  constexpr Rgb red{210, 30, 30}, blue{20, 60, 200}, green{0, 255, 0}, paper{255, 255, 255};
  struct Row {
    Rgb press, release;
    std::optional<RemedyKind> again;
  };
  for (const Row& row : {Row{red, blue, {}},
                         {red, green, RemedyKind::pickRelease},
                         {red, paper, RemedyKind::pickRelease},
                         {paper, blue, RemedyKind::pickPress}}) {
    INFO(nameOf(row.press) << " and " << nameOf(row.release));
    ImportRequest request = firstGraph();
    request.hints.trace.pressColor = row.press, request.hints.trace.releaseColor = row.release;
    const ImportAttempt attempt = session.attempt(request);
    CHECK(attempt.report.ok() == !row.again.has_value());
    if (attempt.report.ok()) continue;
    const Failure& failure = attempt.report.failure();
    INFO(failure.sentence());
    CHECK(failure.remedies.include(*row.again));
    CHECK(english(failure.problem).find("no curve has the colour #") == 0);
  }
}

TEST_CASE("A scanner's grain is seen where a large plot is read from averaged pixels") {
  cv::Mat large, grain;
  cv::resize(cv::imread(plots + "black-red-curves.png"), large, {}, 5, 5, cv::INTER_CUBIC);
  grain.create(large.size(), CV_16SC3);
  cv::theRNG().state = 7;
  cv::randn(grain, 0, 0.45);
  large.convertTo(large, CV_16SC3, 1, -12);  // paper below white, so that grain is not cut off
  large += grain;
  large.convertTo(large, CV_8UC3);
  std::vector<unsigned char> bytes;
  REQUIRE(cv::imencode(".bmp", large, bytes));
  auto session = ImportSession::fromBytes(std::move(bytes), "scan.bmp");
  REQUIRE(session);
  const ImportReport report = imported(*session, firstGraph());
  CHECK(report.evidence->view.raster.width_px < 2000);
  CHECK(report.pageClass == PageClass::scan);
}

TEST_CASE("A cancelled import leaves nothing half done behind") {
  // Cancelled at the n-th call, for every n until it is not called so often.
  const ImportReport whole = [] {
    auto session = opened("white-vector.pdf");
    return imported(session, firstGraph());
  }();
  for (int atMost = 0; atMost < 60; atMost += 3) {
    auto session = opened("white-vector.pdf");
    int requests = 0;
    Progress progress;
    progress.cancelled = [&] { return ++requests > atMost; };
    const auto stopped = session.importGraph(firstGraph(), progress);
    if (!stopped) CHECK(stopped.failure().code == FailureCode::cancelled);
    CHECK(imported(session, firstGraph()).button.states() == whole.button.states());
    if (stopped) break;
  }
}

TEST_CASE("A view that was let go is made again, and gives the same result") {
  auto session = opened("white-vector.pdf");
  const auto listed = session.list(1);
  REQUIRE(listed);
  const Box box = listed->graphs.front().frame;
  ImportRequest request = firstGraph();
  const ImportReport first = imported(session, request);
  ImportRequest large = request;  // the view of this request alone exceeds the memory kept
  large.hints.frame = {{box.x0, box.y0}, {box.x1, box.y1}};
  large.hints.dpi = 900;
  imported(session, large);
  request.hints.strokes.swap = true;
  CHECK(imported(session, request).seconds.count(ImportStep::view) == 1);
  request.hints.strokes.swap = false;
  const ImportReport again = imported(session, request);
  CHECK(again.button.states() == first.button.states());
  CHECK(again.seconds.count(ImportStep::locate) == 0);
  CHECK(again.evidence->view.raster.rgb == first.evidence->view.raster.rgb);
}

TEST_CASE("Precise reads a page twice and keeps the results of both readings") {
  auto session = opened("black-red-curves.png");
  ImportRequest request = firstGraph();
  CHECK(imported(session, request).readings.empty());
  request.quality = Quality::precise;
  const ImportReport report = imported(session, request);
  REQUIRE(report.readings.size() == 2);
  CHECK(report.readings[0].magnification == 1);
  CHECK(report.readings[1].magnification == 2);
  CHECK(report.readings[0].taken);
  CHECK(report.readings[1].problem.empty());
  CHECK(report.readings[1].travel_mm.value() == Approx(report.readings[0].travel_mm.value()).epsilon(0.01));
  CHECK(report.readings[1].highest_N.value() == Approx(report.readings[0].highest_N.value()).epsilon(0.02));
  CHECK_FALSE(report.endedByTimeLimit);
}

TEST_CASE("A second reading keeps the requested graph, frame and axes") {
  auto session = opened("brown-one-ink.png");
  const auto listed = session.list(1);
  REQUIRE(listed);
  const Box box = listed->graphs.front().frame;
  ImportRequest request = firstGraph();
  request.quality = Quality::precise;
  request.hints.frame = {{box.x0, box.y0}, {box.x1, box.y1}};
  request.hints.axes = {0, 10, 0, 10, LengthUnit::millimetre, ForceUnit::newton};
  const ImportReport report = imported(session, request);
  REQUIRE(report.readings.size() == 2);
  CHECK(report.readings[1].travel_mm.value() == Approx(report.readings[0].travel_mm.value()).epsilon(0.01));
  CHECK(report.x->max == 10);
}

TEST_CASE("A limit on time ends an import with a sentence, or with what was read until then") {
  auto session = opened("black-red-curves.png");
  ImportRequest request = firstGraph();
  request.quality = Quality::precise;
  request.timeLimit.emplace(1e-6);
  const auto nothing = session.importGraph(request);
  REQUIRE_FALSE(nothing);
  CHECK(nothing.failure().code == FailureCode::unreadableInput);
  CHECK_THAT(nothing.failure().sentence(), Catch::Contains("limit"));

  request.timeLimit.emplace(3600);
  const ImportReport whole = imported(session, request);
  CHECK_FALSE(whole.endedByTimeLimit);
  CHECK(whole.seconds.count(ImportStep::refine) == 1);

  // Findings are kept, so that strokes are soon reached; there it waits until the limit has passed.
  request.timeLimit.emplace(2);
  Progress progress;
  progress.report = [&](double, ImportStep step) {
    if (step == ImportStep::strokes) std::this_thread::sleep_until(request.timeLimit->end);
  };
  const auto cut = session.importGraph(request, progress);
  REQUIRE(cut);
  CHECK(cut->endedByTimeLimit);
  CHECK(std::ranges::count(cut->remarks, RemarkCode::endedByTimeLimit, &Remark::code) == 1);
  CHECK(cut->seconds.count(ImportStep::refine) == 0);
  CHECK(travel_mm(*cut) == Approx(travel_mm(whole)).epsilon(0.01));
}
