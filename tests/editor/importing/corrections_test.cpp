// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/corrections.h"

#include <filesystem>
#include <fstream>
#include <QLocale>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "editor/importing/finding_words.h"
#include "editor/importing/findings_painting.h"
#include "editor/importing/quality_figures.h"

using namespace detent;
using namespace detent::editor;

namespace {

const FrameCorners upright{{{100, 50}, {300, 50}, {300, 250}, {100, 250}}};

}  // namespace

TEST_CASE("A place on an axis has a share of it, whichever way the graph lies") {
  CHECK(*shareAlong(GraphAxis::x, upright, {150, 250}) == Approx(0.25));
  CHECK(*shareAlong(GraphAxis::y, upright, {100, 100}) == Approx(0.75));  // the y axis counts upwards
  // On its side: the graph's top left is the page's top right.
  const FrameCorners turned{{{300, 50}, {300, 250}, {100, 250}, {100, 50}}};
  CHECK(*shareAlong(GraphAxis::x, turned, {100, 100}) == Approx(0.25));
  CHECK(*shareAlong(GraphAxis::y, turned, {150, 50}) == Approx(0.25));
  const auto back = placeAlong(GraphAxis::x, turned, 0.25);
  CHECK(back.x == Approx(100));
  CHECK(back.y == Approx(100));
}

TEST_CASE("In a leaning frame the middle of an axis is where the perspective has it") {
  const FrameCorners leaning{{{120, 50}, {280, 50}, {300, 250}, {100, 250}}};
  const double share = *shareAlong(GraphAxis::y, leaning, {110, 150});
  CHECK(share < 0.5);  // the upper half is farther away and smaller
  CHECK(share > 0.3);
}

TEST_CASE("Ends that were typed stay as ticks when another tick is set") {
  AxisCorrection axis;
  axis.min = 0, axis.max = 6;
  endsToTicks(axis, GraphAxis::x, upright);
  CHECK_FALSE(axis.min);
  CHECK_FALSE(axis.max);
  const auto ends = endsFromTicks(GraphAxis::x, upright, axis.ticks, {});
  REQUIRE(ends);
  CHECK(ends->min == Approx(0));
  CHECK(ends->max == Approx(6));
}

TEST_CASE("A typed end is one more tick beside those that were given") {
  AxisCorrection axis;
  axis.ticks = {{{140, 250}, 1}};
  giveEnds(axis, GraphAxis::x, {}, 4, upright);
  giveEnds(axis, GraphAxis::x, {}, 5, upright);  // typed again: it replaces the first one
  REQUIRE(axis.ticks.size() == 2);
  CHECK(axis.ticks[0].value == 1);
  CHECK(axis.ticks[1].value == 5);
  const auto ends = endsFromTicks(GraphAxis::x, upright, axis.ticks, {});
  REQUIRE(ends);
  CHECK(ends->min == Approx(0).margin(1e-9));
  CHECK(ends->max == Approx(5));
}

TEST_CASE("Without given ticks a typed end is an end") {
  AxisCorrection axis;
  giveEnds(axis, GraphAxis::x, 0, {}, upright);
  giveEnds(axis, GraphAxis::x, {}, 6, upright);
  CHECK(axis.ticks.empty());
  CHECK(axis.min == 0);
  CHECK(axis.max == 6);
}

TEST_CASE("Two ticks with values define the ends of an axis") {
  const auto ends = endsFromTicks(GraphAxis::x, upright, {{{140, 250}, 1}, {{260, 250}, 4}}, {});
  REQUIRE(ends);
  CHECK(ends->min == Approx(0));
  CHECK(ends->max == Approx(5));
}

TEST_CASE("One given tick keeps the farthest found one; more given ones need none") {
  const std::vector<AxisTick> found{{{100, 250}, 0}, {{200, 250}, 2}, {{300, 250}, 4}};
  // The label at 200 was misread: it says 3.
  const auto ends =
      endsFromTicks(GraphAxis::x, upright, {{{200, 250}, 3}}, {found.begin(), found.begin() + 1});
  REQUIRE(ends);
  CHECK(ends->min == Approx(0));
  CHECK(ends->max == Approx(6));
  CHECK_FALSE(endsFromTicks(GraphAxis::x, upright, {{{200, 250}, 3}}, {}));
  CHECK_FALSE(endsFromTicks(GraphAxis::x, upright, {{{200, 250}, 3}, {{200, 250}, 4}}, {}));
  CHECK_FALSE(endsFromTicks(GraphAxis::x, upright, {{{200, 250}, 3}, {{300, 250}, 3}}, {}));
}

TEST_CASE("A given tick that agrees with the found ones keeps their scale, exactly") {
  const std::vector<AxisTick> found{{{100, 250}, 0}, {{200.1, 250}, 2}, {{249.9, 250}, 3}},
      ends{{{100, 250}, 0}, {{300, 250}, 4}};
  const auto with = [&](const std::vector<AxisTick>& given) {
    return endsFromTicks(GraphAxis::x, upright, given, found, ends);
  };
  const std::vector<AxisTick> misread{{{150.3, 250}, 1}};  // its label was read as 4
  for (const auto& given : {misread, {misread.front(), {{100, 250}, 0}}}) {
    const auto kept = with(given);
    REQUIRE(kept);
    CHECK(kept->min == 0);
    CHECK(kept->max == 4);
  }
  const auto other = with({{{150, 250}, 1.5}});  // contradicts: counts, with the farthest found one
  REQUIRE(other);
  CHECK(other->min == Approx(1.5 - 50 * 1.5 / 99.9));  // through (150, 1.5) and (249.9, 3)
  CHECK(other->max == Approx(1.5 + 150 * 1.5 / 99.9));
  const FoundAxes axes{upright, found, {}, ends, {}};
  Corrections corrections;
  corrections.x.ticks = misread;
  CHECK(hintsFrom(corrections, axes).axes.xMin == 0);
  CHECK(hintsFrom(corrections, axes).axes.xMax == 4);
}

TEST_CASE("Corrections become the importer's hints; what is not given stays open") {
  Corrections corrections;
  CHECK(hintsFrom(corrections, {}) == importer::ImportHints{});
  corrections.yUnit = ForceUnit::gramForce;
  corrections.x.max = 4;
  corrections.y.ticks = {{{100, 250}, 0}, {{100, 150}, 50}};
  corrections.swapStrokes = true;
  corrections.pressColor = importer::Rgb{1, 2, 3};
  corrections.masks = {{1, 2, 3, 4}};
  const auto hints = hintsFrom(corrections, FoundAxes{upright, {}, {}});
  CHECK(hints.frame.empty());
  CHECK_FALSE(hints.axes.xMin);
  CHECK(hints.axes.xMax == 4);
  CHECK(*hints.axes.yMin == Approx(0));
  CHECK(*hints.axes.yMax == Approx(100));
  CHECK(hints.axes.yUnit == ForceUnit::gramForce);
  CHECK(hints.strokes.swap);
  CHECK(hints.trace.pressColor == importer::Rgb{1, 2, 3});
  CHECK(hints.trace.masks_px.size() == 1);
  // A moved frame: the ticks stay where they are on the page, so the ends change.
  corrections.frame = FrameCorners{{{100, 150}, {300, 150}, {300, 250}, {100, 250}}};
  const auto smaller = hintsFrom(corrections, FoundAxes{upright, {}, {}});
  CHECK(smaller.frame.size() == 4);
  CHECK(*smaller.axes.yMax == Approx(50));
}

TEST_CASE("Corrections are undone by value, a run of nudges at once") {
  CorrectionHistory history;
  Corrections next;
  CHECK_FALSE(history.apply(next, "Nothing"));
  next.xUnit = LengthUnit::inch;
  CHECK(history.apply(next, "Unit"));
  const Corrections unit = next;
  for (const double max : {4.0, 4.1, 4.2}) {
    next.x.max = max;
    CHECK(history.apply(next, "Nudge", "nudge"));
  }
  CHECK(history.undoLabel() == "Nudge");
  history.undo();
  CHECK(history.now() == unit);
  history.undo();
  CHECK(history.now() == Corrections{});
  CHECK_FALSE(history.canUndo());
  CHECK(history.redoLabel() == "Unit");
  history.redo();
  history.redo();
  CHECK(history.now() == next);
  history.undo();
  next = history.now();
  next.swapStrokes = true;
  CHECK(history.apply(next, "Swap"));
  CHECK_FALSE(history.canRedo());
}

TEST_CASE("What the importer says is put in the words of someone before the page") {
  const auto none = adviceFor({FailureCode::noForceGraph,
                               "plot frame",
                               "x axis",
                               "nothing there",
                               {{RemedyKind::giveXAxis, "if it is"}, {RemedyKind::raiseLimit, {}}}},
                              "a.pdf");
  CHECK(none.problem == "Plot frame, x axis: nothing there.");
  CHECK(none.remedies == std::vector{RemedyKind::giveXAxis});
  CHECK_FALSE(none.remedy.contains("--"));

  const auto file =
      adviceFor({FailureCode::unreadableInput, std::string("a.pdf"), "", "broken", "Mend it"}, "a.pdf");
  CHECK(file.problem == "Broken.");
  CHECK(file.remedy == "Mend it.");
  CHECK(file.remedies.empty());

  const auto doubt = adviceFor({importer::DoubtCode::pointsMakeNoCurve, {7}},
                               {RemedyKind::addMask, RemedyKind::setResolution, RemedyKind::giveFrame});
  CHECK(doubt.problem.contains('7'));
  CHECK(doubt.remedies.size() == 3);
}

TEST_CASE("Findings are worded in the units shown and in the person's number style") {
  const importer::Remark preload{importer::RemarkCode::preloadTakenOff, {newtons(0.5)}};
  const QString inGrams = inWords(preload, {LengthUnit::inch, ForceUnit::gramForce});
  INFO(inGrams.toStdString());
  CHECK(inGrams.contains("50.9858 gf"));
  const importer::Remark shifted{importer::RemarkCode::displacementShifted, {millimetres(1.27)}};
  CHECK(inWords(shifted, {LengthUnit::inch, ForceUnit::newton}).contains("0.05 in"));
  const QLocale before;
  QLocale::setDefault(QLocale(QLocale::German));
  const QString german = inWords(shifted, modelUnits);
  QLocale::setDefault(before);
  CHECK(german.contains("1,27 mm"));
}

TEST_CASE("A table that is refused comes with advice that a window can follow") {
  const auto rows = [](const std::string& before, double strength) {
    std::string text;
    for (int i = 0; i <= 40; ++i)
      text += before + std::to_string(0.1 * i) + "," + std::to_string(strength * (0.2 + 0.1 * i)) + "\n";
    return text;
  };
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"cycle,displacement (mm),force (N)\n" + rows("1,", 0.2) + rows("2,", 1.5), "a file of its own"},
      {"temperature,current\n" + rows("", 1), "titles such as"}};
  for (const auto& [table, words] : cases) {
    const std::string path = "corrections_test_table.csv";
    std::ofstream(path) << table;
    importer::ImportRequest request;
    request.path = path;
    const auto attempt = importer::ImportSession::open(path)->attempt(request);
    REQUIRE_FALSE(attempt.report.ok());
    const Advice advice = adviceFor(attempt.report.failure(), "table.csv", modelUnits);
    INFO(advice.problem.toStdString() << " " << advice.remedy.toStdString());
    CHECK(advice.remedy.contains(QString::fromStdString(words)));
    CHECK_FALSE(advice.remedy.contains("--"));
    std::filesystem::remove(path);
  }
}

TEST_CASE("Every finding has words at the editor, and none names an option of a program") {
  using namespace importer;
  for (int code = 0; code <= static_cast<int>(RemarkCode::errorBarsLeftOut); ++code) {
    const Remark remark{static_cast<RemarkCode>(code), {"a", "b", "c", "d"}, RemedyKind::giveXUnit};
    const QString words = inWords(remark, modelUnits);
    INFO(words.toStdString());
    CHECK(words.endsWith('.'));
    CHECK_FALSE(words.contains("--"));
    CHECK_FALSE(nameOf(remark.code).empty());
  }
  for (int kind = 0; kind <= static_cast<int>(RemedyKind::acceptAsIs); ++kind) {
    const Remedies remedies{Remedy{static_cast<RemedyKind>(kind), {}},
                            Remedy{RemedyKind::advice, Message("Draw the curve: --press-line")},
                            Remedy{RemedyKind::advice, Message("Look at the page")}};
    const Advice advice = adviceFor(
        Failure{FailureCode::notCertain, "plot frame", "", Message("unclear"), remedies}, {}, modelUnits);
    CHECK_FALSE(advice.remedy.contains("--"));
    CHECK(advice.remedy.contains("Look at the page"));
    for (const RemedyKind each : advice.remedies) CHECK_FALSE(textOnButton(each).isEmpty());
  }
  CHECK(textOnButton(RemedyKind::drawPress) == "Draw press curve");
  CHECK(textOnButton(RemedyKind::drawRelease) == "Draw release curve");
  for (int step = 0; step <= static_cast<int>(ImportStep::callouts); ++step) {
    CHECK_FALSE(inProgress(static_cast<ImportStep>(step)).isEmpty());
    CHECK_FALSE(nameOfWork(static_cast<ImportStep>(step)).isEmpty());
  }
}

TEST_CASE("Every quality level says its work and its error") {
  for (const auto quality :
       {importer::Quality::draft, importer::Quality::standard, importer::Quality::precise}) {
    CHECK(figuresOf(quality).quality == quality);
    CHECK(describedQuality(quality).contains(quality == importer::Quality::draft ? "fastest" : "time"));
    CHECK(describedQuality(quality).contains(" %"));
  }
}

TEST_CASE(
    "Words beside marks hide neither marks nor each other while there is room, and least where there is "
    "none") {
  const QRectF page(0, 0, 200, 216);  // the page on a small screen
  const QSizeF words(130, 12);
  const std::vector<QPointF> marks{{50, 100}, {100, 118}, {101, 128}, {150, 110}};
  std::vector<QRectF> taken;
  for (const QPointF& mark : marks) taken.emplace_back(mark - QPointF(7, 7), QSizeF(14, 14));
  for (const double y : {20.0, 40.0, 60.0, 80.0}) taken.emplace_back(20, y, 20, 14);  // tick labels
  const std::size_t others = taken.size();
  for (const QPointF& mark : marks) freePlace(mark, words, true, page, taken);
  REQUIRE(taken.size() == others + marks.size());
  for (std::size_t i = others; i < taken.size(); ++i) {
    CHECK(page.contains(taken[i]));
    for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(taken[i].intersects(taken[j]));
  }
  std::vector<QRectF> full{{0, 0, 200, 150}};  // only the lower edge has room
  freePlace({100, 140}, words, true, page, full);
  CHECK(full.back().top() >= 150);
}
