// SPDX-License-Identifier: GPL-3.0-or-later
// Plots drawn by the test are calibrated; what cannot be read is said.

#include <algorithm>
#include <tuple>

#include <catch2/catch.hpp>

#include "importer/axes/axis_calibration.h"
#include "importer/axes/frame_by_numbers.h"
#include "importer/axes/read_text.h"
#include "importer/frame/plot_frame.h"
#include "tests/importer/frame/drawn_plot.h"

using namespace detent;
using namespace detent::importer;
using namespace detent::importer::test;

namespace {

struct Looked {
  PageView view;
  PlotFrame frame;
};

/// Plots here stand upright; where more than one way is likely, reading settles it, a step later.
Looked readingOfWhole(const cv::Mat& grey) {
  const auto document = documentOf(grey);
  const auto page = document.page(1).value();
  const auto candidates = findPlotFrames(page);
  const auto upright = std::ranges::find_if(
      candidates, [](const Found<FrameCandidate>& c) { return c.value.quarterTurns == 0; });
  REQUIRE(upright != candidates.end());
  const FrameCandidate& found = upright->value;
  Looked looked{document.view(page, found.regionBox, found.quarterTurns, {}, found.levelToPage).value(), {}};
  looked.frame = locatePlotFrame(looked.view, page, found)->value;
  return looked;
}

/// The frame of a drawn plot whose pixels were erased: no text is recognised except the test's own.
Looked readWithoutCurves(const PlotStyle& s) {
  auto looked = readingOfWhole(drawn(s));
  for (auto& p : looked.view.raster.rgb) p = 255;
  return looked;
}

/// Each label where it is drawn, as the document's own text.
void writeBelow(PageView& view, const PlotStyle& s) {
  for (int k = 0; k <= s.xSteps; ++k) {
    const double x = s.left + (s.right - s.left) * k / s.xSteps;
    const std::string text = shown(s.xFrom + k * s.xStep);
    const double half = 5.0 * static_cast<double>(text.size());
    view.texts.push_back({text, {x - half, 512, x + half, 528}, 0});
  }
}
void writeLeft(PageView& view, const PlotStyle& s) {
  for (int k = 0; k <= s.ySteps; ++k) {
    const double y = s.bottom - (s.bottom - s.top) * k / s.ySteps;
    const std::string text = shown(s.yFrom + k * s.yStep);
    view.texts.push_back({text, {90 - 10.0 * static_cast<double>(text.size()), y - 8, 90, y + 8}, 0});
  }
}

AxesFound read(const cv::Mat& grey, const AxisHints& hints = {}) {
  const auto looked = readingOfWhole(grey);
  auto axes = readAxes(looked.view, looked.frame, hints);
  if (!axes.ok()) FAIL(axes.failure().sentence());
  return std::move(axes).value();
}

/// Largest distance, in pixels, of the calibration's corners from the drawn ones.
double worstCornerError_px(const AxesFound& axes, const PlotStyle& s, double newtonPerUnit) {
  double worst = 0;
  const auto& c = axes.calibration.value;
  for (const double u : {0.0, 1.0})
    for (const double v : {0.0, 1.0}) {
      const Point drawnAt{s.left + u * (s.right - s.left), s.bottom - v * (s.bottom - s.top)};
      const Point value{s.xFrom + u * s.xSteps * s.xStep, (s.yFrom + v * s.ySteps * s.yStep) * newtonPerUnit};
      const Point seen = c.toView(value);
      worst = std::max({worst, std::abs(seen.x - drawnAt.x), std::abs(seen.y - drawnAt.y)});
    }
  return worst;
}

bool skipWithoutEngine() {
  if (TextReader::available()) return false;
  WARN("SKIPPED: no Tesseract language data");
  return true;
}

}  // namespace

TEST_CASE("drawn plots are calibrated to a tenth of a pixel") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  double newton = 0.01;
  std::string unit = "cN";
  SECTION("grid") {}
  SECTION("between pixels") {
    s.left = 100.37, s.top = 40.21, s.right = 820.83, s.bottom = 500.55, s.lineWidth = 1.6;
  }
  SECTION("two axis lines only") { s.box = s.grid = false; }
  SECTION("y does not start at 0") { s.yFrom = 20, s.yStep = 10; }
  SECTION("negative values") { s.yFrom = -40; }
  SECTION("every second line labelled") { s.labelEvery = 2; }
  SECTION("newton") { s.yTitle = "Force [N]", s.yStep = 0.2, newton = 1, unit = "N"; }
  SECTION("gram-force") { s.yTitle = "Force (gf)", newton = 0.00980665, unit = "gf"; }
  SECTION("white on dark") { s.paperGrey = 40, s.lineGrey = 230, s.gridGrey = 90, s.textGrey = 230; }
  const auto axes = read(drawn(s));
  const auto& c = axes.calibration.value;
  CHECK(c.x.unit == "mm");
  CHECK(c.y.unit == unit);
  CHECK(c.x.unitFound);
  CHECK(c.y.unitFound);
  CHECK(c.x.min == Approx(s.xFrom).margin(1e-9));
  CHECK(c.x.max == Approx(s.xFrom + s.xSteps * s.xStep));
  CHECK(c.y.min == Approx(s.yFrom).margin(1e-9));
  CHECK(c.y.max == Approx(s.yFrom + s.ySteps * s.yStep));
  CHECK(worstCornerError_px(axes, s, newton) < 0.1);
  CHECK(axes.calibration.confidence > 0.8);
  CHECK(axes.remarks.empty());
}

TEST_CASE("a picture askew is calibrated where its corners were drawn") {
  if (skipWithoutEngine()) return;
  const double degrees = GENERATE(-4.5, 1.2, 2.5, 9.0);
  PlotStyle s;
  s.gridGrey = 225;
  s.width = 1060, s.height = 760, s.left = 180, s.right = 900, s.top = 120,
  s.bottom = 580;  // room to turn in
  const cv::Mat turn = cv::getRotationMatrix2D(
      {0.5F * static_cast<float>(s.width), 0.5F * static_cast<float>(s.height)}, degrees, 1);
  cv::Mat askew;
  cv::warpAffine(drawn(s), askew, turn, {s.width, s.height}, cv::INTER_CUBIC, cv::BORDER_CONSTANT,
                 cv::Scalar(255));
  const auto looked = readingOfWhole(askew);
  const auto axes = readAxes(looked.view, looked.frame);
  INFO(degrees << " degrees");
  REQUIRE(axes.ok());
  for (const double u : {0.0, 1.0})
    for (const double v : {0.0, 1.0}) {
      const double x = s.left + u * (s.right - s.left), y = s.bottom - v * (s.bottom - s.top);
      const Point onPage{turn.at<double>(0, 0) * x + turn.at<double>(0, 1) * y + turn.at<double>(0, 2),
                         turn.at<double>(1, 0) * x + turn.at<double>(1, 1) * y + turn.at<double>(1, 2)};
      const Point value{u * s.xSteps * s.xStep, 0.01 * v * s.ySteps * s.yStep};
      CHECK(distance(looked.view.viewToPage(axes->calibration.value.toView(value)), onPage) < 0.5);
    }
}

TEST_CASE("the calibration is invertible and knows its scale") {
  AxisCalibration c;
  c.viewToUnits = {0.01, 1e-5, -1, 2e-6, -0.002, 1, 1e-7, 2e-7, 1};
  for (const Point p : {Point{10, 20}, Point{400, 300}, Point{-5, 900}}) {
    const Point back = c.toView(c.toUnits(p));
    CHECK(back.x == Approx(p.x).margin(1e-6));
    CHECK(back.y == Approx(p.y).margin(1e-6));
  }
  CHECK(c.mmPerPx() == Approx(0.01).epsilon(0.01));
  CHECK(c.newtonPerPx() == Approx(0.002).epsilon(0.01));
}

TEST_CASE("a label that contradicts the grid is left out, and said") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.oddLabel = 7, s.oddText = "3.7";  // stands at 3.5
  const auto axes = read(drawn(s));
  CHECK(worstCornerError_px(axes, s, 0.01) < 0.1);
  REQUIRE(axes.remarks.size() == 1);
  CHECK(axes.remarks[0].code == RemarkCode::labelContradicts);
  CHECK(axes.remarks[0].values.at(0).text.find("3.7") != std::string::npos);
  CHECK(axes.remarks[0].values.at(2).text.find("3.5") != std::string::npos);
  CHECK(axes.calibration.confidence > 0.8);
  CHECK(axes.calibration.confidence < 1);
}

TEST_CASE("a number similar to the value of its even row contradicts it where it was read for certain") {
  PlotStyle s;
  auto looked = readWithoutCurves(s);
  writeBelow(looked.view, s), writeLeft(looked.view, s);
  looked.view.texts[0].utf8 = "8";
  const auto said = [&] {
    const auto axes = readAxes(looked.view, looked.frame);
    REQUIRE(axes.ok());
    return std::ranges::count(axes->remarks, RemarkCode::labelContradicts, &Remark::code);
  };
  CHECK(said() == 1);  // the document's own text is certain
}

TEST_CASE("a zero beside its corner contradicts nothing") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.xShiftOfFirst = -14;
  const auto axes = read(drawn(s));
  CHECK(worstCornerError_px(axes, s, 0.01) < 0.1);
  CHECK(axes.remarks.empty());
  CHECK(axes.calibration.confidence > 0.95);
}

TEST_CASE("a number of which only a digit was read makes no scale") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  auto looked = readWithoutCurves(s);
  auto& view = looked.view;
  writeBelow(view, s);
  // Room for two digits at 20, of which one is there.
  const char* read[] = {"0", "2"};
  for (int k = 0; k < 2; ++k) {
    const double y = s.bottom - (s.bottom - s.top) * k / s.ySteps;
    view.texts.push_back({read[k], {k == 0 ? 80.0 : 70.0, y - 8, 90, y + 8}, 0});
  }
  CHECK_FALSE(readAxes(view, looked.frame).ok());
}

TEST_CASE("a zero with two digits' room lost its point, and so did the numbers that count on from it") {
  PlotStyle s;
  auto looked = readWithoutCurves(s);
  auto& view = looked.view;
  writeBelow(view, s);
  const auto [zeroFrom_px, most] = GENERATE(std::pair(68.0, 3.0), std::pair(80.0, 30.0));
  const std::vector<std::string> texts{"00", "5", "10", "15", "20", "25", "30"};
  for (int k = 0; k <= s.ySteps; ++k) {
    const double y = s.bottom - (s.bottom - s.top) * k / s.ySteps;
    const std::string& text = texts[static_cast<std::size_t>(k)];
    const double from_px = k == 0 ? zeroFrom_px : 90 - 11.0 * static_cast<double>(text.size());
    view.texts.push_back({text, {from_px, y - 8, 90, y + 8}, 0});
  }
  const auto axes = readAxes(view, looked.frame);
  if (!axes.ok()) FAIL(axes.failure().sentence());
  CHECK(axes->calibration.value.y.max == Approx(most));
}

TEST_CASE("numbers at the ticks make the scale, not more of them that count on farther out") {
  PlotStyle s;
  auto looked = readWithoutCurves(s);
  auto& view = looked.view;
  writeBelow(view, s);
  writeLeft(view, s);
  // As letters of a title that runs upwards are read.
  const char* letters[] = {"1", "2", "3", "4", "5", "6", "9", "9"};
  for (int k = 0; k < 8; ++k) {
    const double y = 460 - 45.0 * k;
    view.texts.push_back({letters[k], {42, y - 8, 52, y + 8}, 0});
  }
  const auto axes = readAxes(view, looked.frame);
  if (!axes.ok()) FAIL(axes.failure().sentence());
  CHECK(axes->calibration.value.y.max == Approx(120));
}

TEST_CASE("numbers that all but touch the axis are read, not taken for its ticks") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.ticks = false, s.gridGrey = 0;
  s.xSteps = 4, s.xStep = 1;
  s.textScale = 0.35, s.labelDrop = 7;
  const auto axes = read(drawn(s));
  CHECK(axes.calibration.value.x.max == Approx(4));
  CHECK(worstCornerError_px(axes, s, 0.01) < 0.1);
}

TEST_CASE("a plot without units says which ones it took") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.xTitle = s.yTitle = "";
  SECTION("large numbers: gram-force") {
    const auto axes = read(drawn(s));
    CHECK(axes.calibration.value.y.unit == "gf");
    CHECK_FALSE(axes.calibration.value.y.unitFound);
    CHECK_FALSE(axes.calibration.value.x.unitFound);
    CHECK(axes.remarks.size() == 2);
    CHECK(axes.calibration.confidence < 0.5);
  }
  SECTION("words without units: surely a force graph, still not sure enough") {
    const double nameless = read(drawn(s)).calibration.confidence;
    s.xTitle = "Travel", s.yTitle = "Force";
    const auto named = read(drawn(s));
    CHECK(named.calibration.confidence > nameless);
    CHECK(named.calibration.confidence < 0.5);
  }
  SECTION("up to 5: newton") {
    s.yStep = 0.5;
    CHECK(read(drawn(s)).calibration.value.y.unit == "N");
  }
  SECTION("units given by hand: no doubt left") {
    AxisHints hints;
    hints.xUnit = LengthUnit::inch;
    hints.yUnit = ForceUnit::ounceForce;
    const auto axes = read(drawn(s), hints);
    CHECK(axes.calibration.value.y.unitBy == DecidedBy::given);
    CHECK(axes.calibration.value.y.unit == symbolOf(ForceUnit::ounceForce));
    CHECK(axes.remarks.empty());
    CHECK(axes.calibration.confidence > 0.8);
  }
}

TEST_CASE("a letter of another quantity beside a unit of force leaves the axes uncertain") {
  PlotStyle s;
  s.xStep = 0.25, s.yStep = 10;
  auto looked = readWithoutCurves(s);
  writeBelow(looked.view, s);
  writeLeft(looked.view, s);
  const auto titled = [&](const char* x, const char* y) {
    PageView view = looked.view;
    view.texts.push_back({x, {420, 545, 500, 562}, 0});
    view.texts.push_back({y, {20, 220, 38, 320}, 90});
    return readAxes(view, looked.frame).value().calibration;
  };
  const auto right = titled("s [mm]", "F [cN]");
  CHECK(right.confidence > 0.8);
  CHECK(right.value.y.unit == "cN");
  const auto voltage = titled("s [mm]", "U [cN]");
  CHECK(voltage.confidence < 0.5);
  CHECK(voltage.value.y.otherQuantity == "U");
  CHECK(voltage.value.x.otherQuantity.empty());
  const auto time = titled("t [mm]", "F [cN]");
  CHECK(time.confidence < 0.5);
  CHECK(time.value.x.otherQuantity == "t");
}

TEST_CASE("a doubt about an axis names what the axis shows") {
  struct Row {
    const char *quantity, *sentence;
    bool mayBeForce;
  };
  for (const Row& row :
       {Row{"inductance (H)", "the y axis cannot be used: it measures \"inductance (H)\"", true},
        Row{"kPa", "the y axis cannot be used: it measures \"kPa\"", true},
        Row{"values on a logarithmic scale", "the y axis cannot be used: it is logarithmic", false},
        Row{"categories, not to scale", "the y axis cannot be used: it has categories instead of a scale",
            false}}) {
    CAPTURE(row.quantity);
    AxisCalibration axes;
    CHECK(otherQuantitiesOf(axes).empty());
    axes.y.otherQuantity = row.quantity;
    const auto doubts = otherQuantitiesOf(axes);
    REQUIRE(doubts.size() == 1);
    CHECK(english(messageOf(doubts[0])) == row.sentence);
    CHECK(doubts[0].remedies.include(RemedyKind::giveYUnit) == row.mayBeForce);
    CHECK(doubts[0].remedies.include(RemedyKind::advice) == !row.mayBeForce);
  }
}

TEST_CASE("axes whose titles are exchanged stay exchanged, whatever units are given") {
  PlotStyle s;
  s.xStep = 10, s.yStep = 0.25;
  auto looked = readWithoutCurves(s);
  writeBelow(looked.view, s);
  writeLeft(looked.view, s);
  const auto doubtsWith = [&](const char* x, const char* y, const AxisHints& hints) {
    PageView view = looked.view;
    view.texts.push_back({x, {380, 545, 500, 562}, 0});
    view.texts.push_back({y, {20, 200, 38, 340}, 90});
    return otherQuantitiesOf(readAxes(view, looked.frame, hints).value().calibration.value);
  };
  AxisHints units;
  units.xUnit = LengthUnit::millimetre, units.yUnit = ForceUnit::gramForce;
  AxisHints xAlone, yAlone;
  xAlone.xUnit = units.xUnit, yAlone.yUnit = units.yUnit;
  for (const AxisHints& hints : {AxisHints{}, xAlone, yAlone, units}) {
    const auto doubts = doubtsWith("Force (gf)", "Travel (mm)", hints);
    REQUIRE(doubts.size() == 1);
    CHECK(doubts[0].code == DoubtCode::axesExchanged);
    CHECK(doubtsWith("Travel (mm)", "Force (gf)", hints).empty());
  }
  // One axis alone: the unit that a person gives counts.
  CHECK(doubtsWith("Travel (mm)", "Travel (mm)", {}).size() == 1);
  CHECK(doubtsWith("Travel (mm)", "Travel (mm)", yAlone).empty());
}

TEST_CASE("a title that the plot's own view cuts is found in a wider one") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.width = 1500, s.xTitle = "";
  Canvas canvas(s.width, s.height, s.paperGrey);
  drawInto(canvas, s);
  canvas.text("Travel (um)", 1250, s.bottom + 4, 0, 0.6);
  const auto document = documentOf(canvas.grey());
  const auto page = document.page(1).value();
  const auto candidates = findPlotFrames(page);
  REQUIRE(candidates.size() == 1);
  const auto narrow = document.view(page, {0, 0, 1150, 600}).value(),
             wideText_px = document.view(page, {0, 0, 1500, 600}).value();
  const auto frame = locatePlotFrame(narrow, page, candidates[0].value)->value;
  auto axes = readAxes(narrow, frame).value();
  REQUIRE_FALSE(axes.calibration.value.x.unitFound);
  const double sureBefore = axes.calibration.confidence, before = axes.calibration.value.mmPerPx();
  readMissingUnits(axes, wideText_px, frame, Affine{});
  CHECK(axes.calibration.value.x.unitFound);
  CHECK(axes.calibration.value.x.unit == symbolOf(LengthUnit::micrometre));
  CHECK(axes.calibration.value.mmPerPx() == Approx(before / 1000));
  CHECK(axes.calibration.confidence > sureBefore);
  CHECK(axes.remarks.empty());
}

TEST_CASE("a force axis that stands at the right alone is read there") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.forceOnRight = true, s.left = 30, s.right = 750;
  SECTION("in a box") {}
  SECTION("gridlines alone") { s.box = false; }
  SECTION("its title left where it was") { s.titleAtLeft = true; }
  SECTION("its title left where it was, whose letters resemble numbers") {
    s.titleAtLeft = true, s.yTitle = "oooooo [cN]";
  }
  const auto axes = read(drawn(s));
  const AxisCalibration& cal = axes.calibration.value;
  CHECK(cal.y.unitFound);
  CHECK(cal.y.unit == "cN");
  CHECK(cal.y.max == Approx(s.ySteps * s.yStep));
  CHECK(axes.rightScale == RightScale::none);
  CHECK(worstCornerError_px(axes, s, 0.01) < 0.2);
}

TEST_CASE("a travel axis that stands at the top alone is read there") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.travelAtTop = true, s.top = 100, s.bottom = 560;
  SECTION("in a box") {}
  SECTION("the force at the right") { s.forceOnRight = true, s.left = 30, s.right = 750; }
  const auto axes = read(drawn(s));
  const AxisCalibration& cal = axes.calibration.value;
  CHECK(cal.x.unitFound);
  CHECK(cal.x.title == "Travel [mm]");
  CHECK(cal.x.max == Approx(s.xSteps * s.xStep));
  CHECK(worstCornerError_px(axes, s, 0.01) < 0.2);
}

TEST_CASE("a title set so tight that its line reaches into that of the numbers is read") {
  PlotStyle s;
  auto looked = readWithoutCurves(s);
  writeBelow(looked.view, s), writeLeft(looked.view, s);
  for (auto& text : looked.view.texts)
    if (text.box.y0 == 512) text.box.y1 = 542;  // a box as high as its typeface
  looked.view.texts.push_back({"Travel [um]", {400, 520, 500, 550}, 0});
  const auto axes = readAxes(looked.view, looked.frame);
  REQUIRE(axes.ok());
  CHECK(axes->calibration.value.x.unit == symbolOf(LengthUnit::micrometre));
}

TEST_CASE("a second scale on the right is the same forces in another unit, or something else") {
  if (skipWithoutEngine()) return;
  // A tick that begins off the frame's edge is no minus sign.
  const double ticksOff_px = GENERATE(0.0, 4.5, 7.0);
  PlotStyle s;
  const auto hasOther = [&](const char* sign, double perStep) {
    Canvas canvas(s.width, s.height, s.paperGrey);
    drawInto(canvas, s);
    for (int k = 0; k <= s.ySteps; ++k) {
      const double y = s.bottom - (s.bottom - s.top) * k / s.ySteps;
      canvas.row(y, s.right + ticksOff_px, s.right + std::max(9.0, ticksOff_px + 3), 2, s.lineGrey);
      const std::string text = (k > 0 ? sign : "") + shown(k * perStep);
      const auto size = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, s.textScale, 1, nullptr);
      canvas.text(text, s.right + 14 + 0.5 * size.width, y, s.textGrey);
    }
    return read(canvas.grey()).rightScale != RightScale::none;
  };
  CHECK_FALSE(hasOther("", 0.2));  // 20 cN
  CHECK(hasOther("", 0.5));
  CHECK(hasOther("-", 0.2));
}

TEST_CASE("a frame follows its numbers only to an edge that is drawn") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.ySteps = 5, s.top = 120;
  Canvas canvas(s.width, s.height, s.paperGrey);
  drawInto(canvas, s);
  const double above = s.top - (s.bottom - s.top) / s.ySteps;
  canvas.text("120", s.left - 28, above, 0);
  const auto widened = [](const cv::Mat& grey) {
    const auto looked = readingOfWhole(grey);
    return frameByNumbers(looked.view, looked.frame, readAxes(looked.view, looked.frame)->calibration.value);
  };
  CHECK_FALSE(widened(canvas.grey()));  // the number stands above the last line
  canvas.row(above, s.left + 0.3 * (s.right - s.left), s.left + 0.75 * (s.right - s.left), 1, s.lineGrey);
  const auto wideText_px = widened(canvas.grey());  // a piece of the top edge is there
  REQUIRE(wideText_px);
  CHECK(wideText_px->y0 == Approx(above).margin(3));
}

TEST_CASE("a frame without edges follows its numbers where its lines go on to them") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  const bool gridlines = GENERATE(false, true);
  s.xSteps = 5, s.right = 550;
  s.box = s.grid = gridlines;
  Canvas canvas(s.width, s.height, s.paperGrey);
  drawInto(canvas, s);
  const double beyond = s.right + (s.right - s.left) / s.xSteps;
  canvas.text("3", beyond, s.bottom + s.labelDrop, 0);
  const auto rightEnd = [](const cv::Mat& grey) {
    const auto looked = readingOfWhole(grey);
    const auto axes = readAxes(looked.view, looked.frame);
    REQUIRE(axes.ok());
    return frameByNumbers(looked.view, looked.frame, axes->calibration.value).value_or(looked.frame.box()).x1;
  };
  CHECK(rightEnd(canvas.grey()) == Approx(s.right).margin(3));
  const bool flush = !gridlines && GENERATE(false, true);
  if (flush) {
    canvas = Canvas(s.width, s.height, s.paperGrey);
    drawInto(canvas, s);
    canvas.text("3.0", beyond - 13, s.bottom + s.labelDrop, 0);
  }
  if (!gridlines) canvas.row(s.bottom, s.right, beyond, 1, s.lineGrey);
  for (int k = 1; gridlines && k < s.ySteps; ++k)
    canvas.row(s.bottom - (s.bottom - s.top) * k / s.ySteps, s.right, beyond, 1, s.gridGrey);
  CHECK(rightEnd(canvas.grey()) == Approx(beyond).margin(3));
}

TEST_CASE("a drawn edge ends the frame though the axis goes on to a number") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.ySteps = 5, s.top = 120;
  Canvas canvas(s.width, s.height, s.paperGrey);
  drawInto(canvas, s);
  const double above = s.top - (s.bottom - s.top) / s.ySteps;
  canvas.text("120", s.left - 28, above, 0);
  canvas.column(s.left, above, s.top, 1, s.lineGrey);
  const auto looked = readingOfWhole(canvas.grey());
  CHECK_FALSE(
      frameByNumbers(looked.view, looked.frame, readAxes(looked.view, looked.frame)->calibration.value));
}

TEST_CASE("digits that touch the axis belong to their numbers") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.ticks = false, s.labels = false, s.lineWidth = 2;
  Canvas canvas(s.width, s.height, s.paperGrey);
  drawInto(canvas, s);
  const auto write = [&](double value, double cx, double cy, bool left) {
    const std::string text = shown(value);
    int below = 0;
    const double wideText_px = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, 0.4, 1, &below).width;
    canvas.text(text, left ? cx - 0.5 * wideText_px : cx, cy, 0, 0.4);
  };
  for (int k = 0; k <= s.xSteps; ++k)
    write(k * s.xStep, s.left + (s.right - s.left) * k / s.xSteps, s.bottom + s.labelDrop, false);
  for (int k = 0; k <= s.ySteps; ++k)
    write(k * s.yStep, s.left - 1, s.bottom - (s.bottom - s.top) * k / s.ySteps, true);
  CHECK(read(canvas.grey()).calibration.value.y.max == Approx(120));
}

TEST_CASE("numbers that were all misread alike make no certain scale") {
  PlotStyle s;
  const auto sureWith = [&](const std::vector<std::string>& texts) {
    auto looked = readWithoutCurves(s);
    writeBelow(looked.view, s);
    for (int k = 0; k <= s.ySteps; ++k) {
      const double y = s.bottom - (s.bottom - s.top) * k / s.ySteps;
      looked.view.texts.push_back({texts[static_cast<std::size_t>(k)], {60, y - 8, 90, y + 8}, 0});
    }
    const auto axes = readAxes(looked.view, looked.frame);
    REQUIRE(axes.ok());
    return axes->calibration.confidence;
  };
  const double one = sureWith({"0", "20", "40", "60", "80", "100", "126"});
  CHECK(sureWith({"8", "28", "48", "68", "88", "108", "126"}) < 0.5 * one);
}

TEST_CASE("thousands among hundreds are read on the axis") {
  PlotStyle s;
  auto looked = readWithoutCurves(s);
  writeBelow(looked.view, s);
  const std::vector<std::string> texts{"0", "250", "500", "750", "1,000", "1,250", "1,500"};
  for (int k = 0; k <= s.ySteps; ++k) {
    const double y = s.bottom - (s.bottom - s.top) * k / s.ySteps;
    looked.view.texts.push_back({texts[static_cast<std::size_t>(k)], {40, y - 8, 90, y + 8}, 0});
  }
  const auto axes = readAxes(looked.view, looked.frame);
  REQUIRE(axes.ok());
  CHECK(axes->calibration.value.y.max == Approx(1500));
  CHECK(std::ranges::all_of(axes->calibration.value.y.ticks, [](const TickLabel& t) { return t.used; }));
}

TEST_CASE("thousands or three decimals: the one that makes a button's size") {
  PlotStyle s;
  auto looked = readWithoutCurves(s);
  const auto ended = [&](const char* title, const char* decimalsTitle) {
    PageView view = looked.view;
    for (int k = 0; k <= s.xSteps; ++k) {
      const double x = s.left + (s.right - s.left) * k / s.xSteps;
      view.texts.push_back({k == 0 ? "0" : std::to_string(k) + ".000", {x - 20, 512, x + 20, 528}, 0});
    }
    for (int k = 0; k <= s.ySteps; ++k) {
      const double y = s.bottom - (s.bottom - s.top) * k / s.ySteps;
      view.texts.push_back({k == 0 ? "0" : std::to_string(k) + ".000", {40, y - 8, 90, y + 8}, 0});
    }
    view.texts.push_back({title, {420, 545, 500, 562}, 0});
    view.texts.push_back({decimalsTitle, {10, 220, 28, 320}, 90});
    const auto axes = readAxes(view, looked.frame);
    REQUIRE(axes.ok());
    return axes->calibration.value;
  };
  const auto small = ended("Travel (\xc2\xb5m)", "Force (mN)");
  CHECK(small.x.max == Approx(8000));
  CHECK(small.y.max == Approx(6000));
  CHECK(small.toUnits({s.right, s.top}).x == Approx(8).epsilon(0.01));
  CHECK(small.toUnits({s.right, s.top}).y == Approx(6).epsilon(0.01));
  CHECK(small.x.ticks.back().value == Approx(8000));
  CHECK_FALSE(small.x.thousandsUnclear);
  CHECK_FALSE(small.y.thousandsUnclear);

  const auto large = ended("Travel (mm)", "Force (N)");
  CHECK(large.x.max == Approx(8));
  CHECK(large.y.max == Approx(6));
  CHECK_FALSE(large.x.thousandsUnclear);

  const auto either = ended("Travel (mm)", "Force (gf)");  // 6 gf are a light key, 6000 gf a heavy switch
  CHECK(either.y.thousandsUnclear);
}

TEST_CASE("numbers of the y axis that read upwards are read") {
  PlotStyle s;
  const auto at = [&](int k) { return s.bottom - (s.bottom - s.top) * k / s.ySteps; };
  SECTION("the document's own") {
    auto looked = readWithoutCurves(s);
    writeBelow(looked.view, s);
    for (int k = 0; k <= s.ySteps; ++k) {
      const std::string text = shown(s.yFrom + k * s.yStep);
      const double half = 5.0 * static_cast<double>(text.size());
      looked.view.texts.push_back({text, {70, at(k) - half, 86, at(k) + half}, 90});
    }
    looked.view.texts.push_back({"Force [cN]", {20, 220, 38, 320}, 90});
    const auto axes = readAxes(looked.view, looked.frame);
    REQUIRE(axes.ok());
    CHECK(axes->calibration.value.y.max == Approx(120));
    CHECK(axes->calibration.value.y.unit == "cN");
    CHECK(axes->calibration.value.y.ticks.size() == 7);
    CHECK(axes->calibration.value.y.ticks.front().value == Approx(120));  // from above, as upright ones
  }
  SECTION("drawn") {
    if (skipWithoutEngine()) return;
    // "0.5": read level its digits are numbers of which two make a scale; of 0, 5, 10 and 15 no three are
    // equally long.
    std::tie(s.ySteps, s.yStep) = GENERATE(std::pair(6, 20.0), std::pair(4, 0.5), std::pair(3, 5.0));
    s.grid = false;
    s.labels = false;
    s.left = 140;
    Canvas c(s.width, s.height, s.paperGrey);
    drawInto(c, s);
    for (int k = 0; k <= s.xSteps; ++k)
      c.text(shown(s.xFrom + k * s.xStep), s.left + (s.right - s.left) * k / s.xSteps, s.bottom + 20, 0);
    for (int k = 0; k <= s.ySteps; ++k) c.text(shown(s.yFrom + k * s.yStep), s.left - 18, at(k), 0, 0.5, 1);
    const auto axes = read(c.grey());
    CHECK(axes.calibration.value.y.min == Approx(0).margin(1e-9));
    CHECK(axes.calibration.value.y.max == Approx(s.ySteps * s.yStep));
    CHECK(worstCornerError_px(axes, s, 0.01) < 0.1);
  }
}

TEST_CASE("ranges given by hand are kept") {
  PlotStyle s;
  AxisHints hints;
  hints.xMin = 0, hints.xMax = 8, hints.yMin = -10, hints.yMax = 50;
  hints.xUnit = LengthUnit::millimetre, hints.yUnit = ForceUnit::newton;
  const auto axes = read(drawn(s), hints);
  const auto& c = axes.calibration.value;
  CHECK(axes.calibration.confidence == 1);
  CHECK(axes.calibration.by == DecidedBy::given);
  const Point p = c.toUnits({s.right, s.top}), q = c.toUnits({s.left, s.bottom});
  CHECK(p.x == Approx(8).margin(0.01));
  CHECK(p.y == Approx(50).margin(0.1));
  CHECK(q.x == Approx(0).margin(0.01));
  CHECK(q.y == Approx(-10).margin(0.1));
}

TEST_CASE("printed numbers speak for given ends or against them") {
  PlotStyle s;
  auto looked = readWithoutCurves(s);
  writeBelow(looked.view, s);
  writeLeft(looked.view, s);
  looked.view.texts.push_back({"Travel [mm]", {420, 545, 520, 562}, 0});
  looked.view.texts.push_back({"Force [cN]", {20, 220, 38, 320}, 90});
  const auto readWith = [&](const AxisHints& hints) {
    return readAxes(looked.view, looked.frame, hints).value().calibration;
  };
  const auto agreeing = [](const AxisReading& axis) {
    return std::ranges::count_if(axis.ticks, &TickLabel::agrees);
  };
  AxisHints hints;
  SECTION("ends as printed") {
    hints.xMin = 0, hints.xMax = 4, hints.yMin = 0, hints.yMax = 120;
    const auto axes = readWith(hints);
    for (const AxisReading* axis : {&axes.value.x, &axes.value.y}) {
      CHECK(axis->contradicting.empty());
      CHECK(agreeing(*axis) == std::ssize(axis->ticks));
    }
    CHECK(axes.evidence.front().code == EvidenceCode::axisGivenAmongLabels);
    CHECK(english(messageOf(axes.evidence.front())) ==
          "x axis: entered by hand; 9 of 9 printed numbers agree");
  }
  SECTION("one end that is wrong by a tenth of a step") {
    hints.xMax = 4.05;
    const auto axes = readWith(hints);
    CHECK(axes.value.x.min == 0);
    CHECK(axes.value.x.max == 4.05);
    REQUIRE_FALSE(axes.value.x.contradicting.empty());
    CHECK(axes.value.x.contradicting.back() == "4");
    CHECK(agreeing(axes.value.x) >= 1);  // those beside the other end
    CHECK(axes.value.x.contradictedBy > 0.8);
    CHECK(axes.value.y.contradicting.empty());
  }
  SECTION("a wrong end of force, beside a right one") {
    hints.yMin = 0, hints.yMax = 12;
    const auto axes = readWith(hints);
    CHECK(axes.value.y.contradicting.size() == 6);  // all but 0
    CHECK(axes.evidence.back().code == EvidenceCode::axisGivenAmongLabels);
  }
  SECTION("the same ends in another unit") {
    hints.xMin = 0, hints.xMax = 4000, hints.xUnit = LengthUnit::micrometre;
    hints.yMin = 0, hints.yMax = 1.2, hints.yUnit = ForceUnit::newton;
    const auto axes = readWith(hints);
    CHECK(axes.value.x.contradicting.empty());
    CHECK(axes.value.y.contradicting.empty());
  }
}

TEST_CASE("a factor in a title multiplies the numbers, whatever unit is given") {
  struct Row {
    const char *what, *force;
    std::optional<ForceUnit> unit;
    std::optional<double> top;
    double max, factor;
    bool unread = false;
  };
  PlotStyle s;  // the numbers end at 120
  for (const Row& row :
       {Row{"read", "Load [x10 gf]", {}, {}, 1200, 10},
        {"the unit given", "Load [x10 gf]", ForceUnit::gramForce, {}, 1200, 10},
        {"in front of the unit", "Kraft in 0.1 N", ForceUnit::newton, {}, 12, 0.1},
        {"the ends as printed", "Load [x10 gf]", ForceUnit::gramForce, 120, 1200, 10},
        {"the ends as printed, without a unit", "Load [x10 gf]", {}, 120, 1200, 10},
        {"ends that no number agrees with", "Load [x10 gf]", {}, 75, 75, 10},
        {"the top multiplied", "Load [x10 gf]", ForceUnit::gramForce, 1200, 1200, 1},
        {"misread", "Load [x10?gf]", ForceUnit::gramForce, {}, 120, 1, true},
        {"misread, the ends as printed", "Load [x10?gf]", {}, 120, 120, 1, true},
        {"misread, the top multiplied", "Load [x10?gf]", {}, 12000, 12000, 1},
        {"misread, in another unit", "Load [x10?mN]", ForceUnit::newton, 0.12, 0.12, 1, true},
        {"misread, and a millionfold", "Load [x10?gf]", {}, 1.2e8, 1.2e8, 1},
        {"none", "Load [gf]", ForceUnit::gramForce, {}, 120, 1}}) {
    INFO(row.what);
    auto looked = readWithoutCurves(s);
    writeBelow(looked.view, s);
    writeLeft(looked.view, s);
    looked.view.texts.push_back({"Travel [mm]", {420, 545, 520, 562}, 0});
    looked.view.texts.push_back({row.force, {20, 220, 38, 320}, 90});
    AxisHints hints;
    hints.yUnit = row.unit, hints.yMax = row.top;
    if (row.top) hints.yMin = 0;
    const auto axes = readAxes(looked.view, looked.frame, hints);
    REQUIRE(axes);
    const AxisCalibration& c = axes->calibration.value;
    CHECK(c.y.otherQuantity.empty());
    CHECK(c.y.max == Approx(row.max));
    CHECK(c.y.factor == Approx(row.factor));
    CHECK(c.y.factorUnread == row.unread);
    CHECK(c.toUnits({s.left, s.top}).y ==
          Approx(row.max * newtonsPer(*forceUnitFrom(c.y.unit))).epsilon(1e-3));
  }
}

TEST_CASE("beside one given end the other is the printed one, in the same power of ten") {
  struct Row {
    double from;  // printed at the bottom; 120 more at the top
    std::optional<double> bottom, top;
    double min, max;
  };
  for (const Row& row : {Row{0, {}, 120, 0, 120},
                         {0, {}, 0.12, 0, 0.12},
                         {20, {}, 0.14, 0.02, 0.14},
                         {20, 0.02, {}, 0.02, 0.14},
                         {20, {}, 75, 20, 75},      // no power of ten
                         {20, {}, 1.42, 20, 1.42},  // 1.4 % off one
                         {0, 0.1, {}, 0.1, 120},    // beside a printed zero
                         {20, {}, 14, 2, 14}}) {
    INFO(row.from << ", " << row.bottom.value_or(-1) << " to " << row.top.value_or(-1));
    PlotStyle s;
    s.yFrom = row.from;
    auto looked = readWithoutCurves(s);
    writeBelow(looked.view, s);
    writeLeft(looked.view, s);
    looked.view.texts.push_back({"Travel [mm]", {420, 545, 520, 562}, 0});
    looked.view.texts.push_back({"Force [N]", {20, 220, 38, 320}, 90});
    AxisHints hints;
    hints.yMin = row.bottom, hints.yMax = row.top;
    const auto axes = readAxes(looked.view, looked.frame, hints);
    REQUIRE(axes);
    const AxisCalibration& c = axes->calibration.value;
    CHECK(c.y.min == Approx(row.min));
    CHECK(c.y.max == Approx(row.max));
    const auto& corners = looked.frame.corners;
    const Point offset = looked.frame.drawnOffset_px;
    CHECK(c.toUnits({corners[3].x - offset.x, corners[3].y - offset.y}).y ==
          Approx(row.min).margin(1e-9 * row.max));
    CHECK(c.toUnits({corners[0].x - offset.x, corners[0].y - offset.y}).y == Approx(row.max));
  }
}

TEST_CASE("forces that fall upwards are read beside the other axis' zero in the corner") {
  PlotStyle s;
  s.yFrom = 120, s.yStep = -20;
  auto looked = readWithoutCurves(s);
  writeBelow(looked.view, s);
  writeLeft(looked.view, s);
  looked.view.texts.front().box = {74, 512, 104, 528};
  looked.view.texts.push_back({"Travel [mm]", {420, 545, 520, 562}, 0});
  looked.view.texts.push_back({"Force [cN]", {20, 220, 38, 320}, 90});
  const auto axes = readAxes(looked.view, looked.frame);
  REQUIRE(axes);
  CHECK(axes->calibration.value.y.min == Approx(120));
  CHECK(axes->calibration.value.y.max == Approx(0).margin(1e-9));
  CHECK(axes->calibration.confidence > 0.9);
  CHECK(axes->remarks.empty());
}

TEST_CASE("numbers that count on below zero are read without their signs") {
  PlotStyle s;
  double from = -4;  // at the left, with steps of 0.5 mm
  AxisHints hints;
  SECTION("to zero") {}
  SECTION("a margin beyond zero") { from = -3.9; }
  SECTION("given with signs") { hints.xMin = -4, hints.xMax = 0; }
  SECTION("given without signs") { hints.xMin = 4, hints.xMax = 0; }
  s.xFrom = from;
  auto looked = readWithoutCurves(s);
  writeBelow(looked.view, s);
  writeLeft(looked.view, s);
  looked.view.texts.push_back({"Depth / mm", {420, 545, 520, 562}, 0});
  looked.view.texts.push_back({"Force [cN]", {20, 220, 38, 320}, 90});
  const auto axes = readAxes(looked.view, looked.frame, hints);
  REQUIRE(axes);
  const AxisCalibration& c = axes->calibration.value;
  CHECK(c.x.min == Approx(-from));
  CHECK(c.x.max == Approx(-from - 4).margin(1e-9));
  CHECK(c.x.contradicting.empty());
  CHECK(c.toUnits({s.left, s.bottom}).x == Approx(-from).epsilon(1e-3));
  CHECK(c.toUnits({s.right, s.bottom}).x == Approx(-from - 4).margin(0.01));
  CHECK(std::ranges::count(axes->remarks, RemarkCode::signsLeftOut, &Remark::code) ==
        (hints.xMin == 4.0 ? 0 : 1));
}

TEST_CASE("an uneven scale is named as the reason even where some of its labels fit a line") {
  struct Scale {
    const char* says;
    std::vector<const char*> travels;
    std::vector<double> ticks;  // from the left edge
  };
  const Scale scales[] = {
      {"the x axis cannot be used: it has categories instead of a scale",
       {"0", "0.1", "0.2", "0.3", "0.8", "1.7", "2.6", "3.5", "4.6"},
       {0, 1, 2, 3, 4, 5, 6, 7, 8}},
      {"the x axis cannot be used: it has a break, after which the numbers stand at another spacing",
       {"0", "0.5", "1.0", "1.5", "2.0", "2.5", "3.0", "3.5", "4.0"},
       {0, 1, 2, 3, 4, 4.5, 5.2, 5.9, 6.6}}};
  PlotStyle s;
  AxisHints none, given;
  given.xMin = 0, given.xMax = 4.6;
  for (const Scale& scale : scales) {
    INFO(scale.says);
    auto looked = readWithoutCurves(s);
    writeLeft(looked.view, s);
    for (std::size_t k = 0; k < scale.travels.size(); ++k) {
      const double x = s.left + (s.right - s.left) * scale.ticks[k] / s.xSteps;
      looked.view.texts.push_back({scale.travels[k], {x - 15, 512, x + 15, 528}, 0});
    }
    looked.view.texts.push_back({"Travel [mm]", {420, 545, 520, 562}, 0});
    looked.view.texts.push_back({"Force [cN]", {20, 220, 38, 320}, 90});
    for (const AxisHints& hints : {none, given}) {
      const auto axes = readAxes(looked.view, looked.frame, hints);
      REQUIRE(axes);
      const auto doubts = otherQuantitiesOf(axes->calibration.value);
      REQUIRE(doubts.size() == 1);
      CHECK(english(messageOf(doubts.front())) == scale.says);
      CHECK_FALSE(doubts.front().remedies.include(RemedyKind::giveXUnit));  // no unit makes it even
      CHECK_FALSE(doubts.front().remedies.empty());
    }
  }
}

TEST_CASE("what cannot be read is refused with a sentence") {
  if (skipWithoutEngine()) return;
  const auto looked = readingOfWhole(drawn({}));
  SECTION("no numbers") {
    PlotStyle s;
    s.labels = false;
    auto view = looked.view;
    const cv::Mat grey = drawn(s);
    for (int y = 0; y < grey.rows; ++y)
      for (int x = 0; x < grey.cols; ++x)
        for (int k = 0; k < 3; ++k)
          view.raster.rgb[3 * (static_cast<std::size_t>(y) * 900 + static_cast<std::size_t>(x)) +
                          static_cast<std::size_t>(k)] = grey.at<std::uint8_t>(y, x);
    const auto axes = readAxes(view, looked.frame);
    REQUIRE_FALSE(axes.ok());
    CHECK(axes.failure().code == FailureCode::noForceGraph);
    CHECK((axes.failure().remedies.include(RemedyKind::giveXAxis) ||
           axes.failure().remedies.include(RemedyKind::giveYAxis)));
  }
  SECTION("numbers that make no progression") {
    auto view = looked.view;
    // The document's own text overrules pixels: numbers in no order.
    const char* odd[] = {"17", "903", "44", "12", "871", "3", "388", "56", "290"};
    for (int k = 0; k < 9; ++k) view.texts.push_back({odd[k], {85.0 + 90 * k, 510, 115.0 + 90 * k, 528}, 0});
    const auto axes = readAxes(view, looked.frame);
    REQUIRE_FALSE(axes.ok());
    CHECK(axes.failure().code == FailureCode::notCertain);
    CHECK(axes.failure().remedies.include(RemedyKind::giveXAxis));
  }
  SECTION("an empty range") {
    AxisHints hints;
    hints.xMin = hints.xMax = 3;
    const auto axes = readAxes(looked.view, looked.frame, hints);
    REQUIRE_FALSE(axes.ok());
    CHECK(axes.failure().code == FailureCode::wrongUsage);
  }
}

TEST_CASE("the document's own text is taken, not its pixels") {
  PlotStyle s;
  s.xStep = 0.25, s.yStep = 10;
  auto looked = readWithoutCurves(s);
  auto& view = looked.view;
  writeBelow(view, s);
  writeLeft(view, s);
  view.texts.push_back({"Weg [mm]", {420, 545, 500, 562}, 0});
  view.texts.push_back({"Kraft [mN]", {20, 220, 38, 320}, 90});
  const auto axes = readAxes(view, looked.frame);
  REQUIRE(axes.ok());
  CHECK(axes->calibration.value.x.max == Approx(2));
  CHECK(axes->calibration.value.y.max == Approx(60));
  CHECK(axes->calibration.value.y.unit == "mN");
  CHECK(axes->calibration.value.y.title == "Kraft [mN]");
}

TEST_CASE("a row of numbers without ticks makes a scale by itself where it is whole and even") {
  PlotStyle s;
  auto looked = readWithoutCurves(s);
  looked.frame.xLines.clear(), looked.frame.yLines.clear();
  writeBelow(looked.view, s), writeLeft(looked.view, s);
  // Units given by hand: this test is about the scales.
  AxisHints units;
  units.xUnit = LengthUnit::millimetre, units.yUnit = ForceUnit::newton;
  const auto sure = [&] { return readAxes(looked.view, looked.frame, units)->calibration.confidence; };
  REQUIRE(sure() > 0.6);
  auto& texts = looked.view.texts;
  SECTION("one stands aside") { texts[2].box.x0 += 4, texts[2].box.x1 += 4; }
  SECTION("one is missing") { texts.erase(texts.begin() + 2); }
  SECTION("the axis stands between two of their steps") {
    looked.frame.corners[0].x += 12, looked.frame.corners[3].x += 12;
  }
  CHECK(sure() < 0.55);
}

TEST_CASE("a misread label is kept, marked as not used") {
  PlotStyle s;
  auto looked = readWithoutCurves(s);
  auto& view = looked.view;
  writeBelow(view, s);
  view.texts.at(3).utf8 = "75";
  writeLeft(view, s);
  const auto axes = readAxes(view, looked.frame);
  REQUIRE(axes.ok());
  const auto& ticks = axes->calibration.value.x.ticks;
  REQUIRE(ticks.size() == 9);
  for (const auto& t : ticks) CHECK(t.used == (t.value != 75));
  CHECK(axes->calibration.value.x.max == Approx(4));
}

namespace {

/// Reads the axes and the texts in and beside the plot; `before`: texts that were read earlier.
Result<AxesFound> readWithTexts(const cv::Mat& grey, const std::vector<SeenText>& before = {}) {
  const auto looked = readingOfWhole(grey);
  auto axes = readAxes(looked.view, looked.frame);
  REQUIRE(axes.ok());
  axes->texts.insert(axes->texts.end(), before.begin(), before.end());
  readGraphTexts(looked.view, looked.frame, *axes);
  return axes;
}

}  // namespace

TEST_CASE("callouts and legend are read where they stand") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.width = 1100;
  Canvas c(s.width, s.height, 255);
  drawInto(c, s);
  c.fill(180, 90, 420, 120, 255);
  c.text("operating point", 300, 105, 0, 0.7);
  c.text("Press", 930, 200, 0, 0.6);
  c.text("Release", 940, 230, 0, 0.6);
  const auto axes = readWithTexts(c.grey());
  const auto at = [&](const std::string& word) {
    for (const auto& t : axes->texts)
      if (t.utf8.find(word) != std::string::npos) return t.box;
    return Box{};
  };
  CHECK(at("operating").contains(Point{300, 103}));
  CHECK(at("Release").contains(Point{940, 229}));
  CHECK_FALSE(at("Press").empty());
}

TEST_CASE("words are read across gridlines as dark as they are") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.gridGrey = s.lineGrey;
  Canvas c(s.width, s.height, 255);
  drawInto(c, s);
  c.text("operating point", 300, 95, 0, 0.7);  // lines of the grid at 280 and 370
  c.text("reset point", 640, 430, 0, 0.7);     // at 640, and at 423 along the words
  const auto axes = readWithTexts(c.grey());
  const auto isWhole = [&](Point first, Point last) {  // letters on a line may be misread
    return std::ranges::any_of(axes->texts, [&](const SeenText& t) {
      return t.box.contains(first) && t.box.contains(last) && t.utf8.ends_with(" point");
    });
  };
  CHECK(isWhole({225, 93}, {375, 93}));
  CHECK(isWhole({590, 428}, {690, 428}));
}

TEST_CASE("the heading of a panel beside is read where the plot's own names the press") {
  if (skipWithoutEngine()) return;
  const auto headed = [](const std::string& own) {
    PlotStyle s;
    s.width = 1600;
    s.height = 660;
    s.top = 200, s.right = 640, s.bottom = 580;
    Canvas c(s.width, s.height, 255);
    drawInto(c, s);
    c.text(own, 370, 30, 0, 0.7);
    c.text("release", 1300, 30, 0, 0.7);  // farther off than a legend stands
    const auto axes = readWithTexts(c.grey());
    return std::ranges::count(axes->texts, "release", &SeenText::utf8);
  };
  CHECK(headed("press") == 1);
  CHECK(headed("Red switch") == 0);
}

TEST_CASE("a legend's row is parted at its samples") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.height = 640;
  Canvas c(s.width, s.height, 255);
  drawInto(c, s);
  for (const double from : {300.0, 416.0}) c.row(600, from, from + 40, 2, 60);
  c.text("Press", 378, 600, 0, 0.6);
  c.text("Release", 505, 600, 0, 0.6);
  const auto axes = readWithTexts(c.grey());
  for (const char* word : {"Press", "Release"})
    CHECK(std::ranges::count(axes->texts, word, &SeenText::utf8) == 1);
}

TEST_CASE("names of two signs that were read with their samples are read without them") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.height = 640;
  Canvas c(s.width, s.height, 255);
  drawInto(c, s);
  for (const double from : {300.0, 416.0}) {
    c.row(600, from, from + 40, 2, 60);
    c.fill(from + 14, 594, from + 26, 606, 60);
  }
  c.text("K1", 360, 600, 0, 0.6);
  c.text("K2", 476, 600, 0, 0.6);
  const auto axes = readWithTexts(c.grey(), {{"-O- K1 -O- K2", {298, 590, 490, 610}, 0.7, 0}});
  for (const auto* texts : {&axes->texts, &axes->otherLines})
    CHECK(std::ranges::none_of(*texts, [](const SeenText& t) { return t.utf8.starts_with("-O-"); }));
}

TEST_CASE("a legend's row is parted at filled squares of another colour") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.height = 640;
  Canvas c(s.width, s.height, 255);
  drawInto(c, s);
  for (const double from : {300.0, 400.0}) c.fill(from, 592, from + 22, 608, 150);
  c.text("Press", 360, 600, 0, 0.6);
  c.text("Release", 470, 600, 0, 0.6);
  const auto axes = readWithTexts(c.grey());
  for (const char* word : {"Press", "Release"})
    CHECK(std::ranges::count(axes->texts, word, &SeenText::utf8) == 1);
}

TEST_CASE("names of two letters are read beside a legend key alone") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.width = 1100;
  const bool sampled = GENERATE(true, false);
  Canvas c(s.width, s.height, 255);
  drawInto(c, s);
  for (const double y : {200.0, 230.0}) {
    if (sampled) c.row(y, 900, 930, 2, 120);
    c.text(y < 210 ? "K1" : "K2", 955, y, 0, 0.6);
  }
  const auto axes = readWithTexts(c.grey());
  const auto isBeside = [](const SeenText& t) { return t.box.middle().x > 940; };
  const auto isRead = [&](const SeenText& t) { return isBeside(t) && t.utf8.starts_with("K"); };
  CHECK(std::ranges::count_if(axes->otherLines, isBeside) == (sampled ? 2 : 0));
  CHECK(std::ranges::count_if(axes->otherLines, isRead) == (sampled ? 2 : 0));
}

TEST_CASE("names that count on in a legend are no second scale") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.width = 1100;
  const double apart_px = GENERATE(24.0, 80.0);
  Canvas c(s.width, s.height, s.paperGrey);
  drawInto(c, s);
  for (int k = 0; k < 5; ++k) c.text(shown(30 + 5 * k), s.right + 30, s.top + 40 + apart_px * k, s.textGrey);
  CHECK((read(c.grey()).rightScale != RightScale::none) == (apart_px > 50));
}

TEST_CASE("units that only the heading names, said and not contradicted") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.top = 100, s.xTitle = "Travel", s.yTitle = "Force";
  bool taken = true;
  std::string heading = "Key force vs travel (cN, mm)";
  SECTION("both") {}
  SECTION("an axis that names another unit") { s.yTitle = "Force [N]", taken = false; }
  SECTION("an axis that measures something else") { s.xTitle = "Time (s)", taken = false; }
  SECTION("a stiffness") { heading = "Spring rates (cN/mm)", taken = false; }
  Canvas c(s.width, s.height, s.paperGrey);
  drawInto(c, s);
  c.text(heading, 0.5 * (s.left + s.right), 40, s.textGrey, 0.8);
  const auto axes = read(c.grey());
  const AxisCalibration& cal = axes.calibration.value;
  CHECK((cal.x.unitFound && cal.y.unit == "cN") == taken);
  CHECK(std::ranges::any_of(axes.calibration.evidence, [](const EvidenceItem& item) {
          return item.code == EvidenceCode::unitsOfHeading;
        }) == taken);
  if (taken) CHECK(worstCornerError_px(axes, s, 0.01) < 0.2);
}

TEST_CASE("units that stand behind the numbers are theirs where most of them say so") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.left = 150, s.xTitle = "Travel", s.yTitle = "Force";
  bool known = true;
  SECTION("both") { s.xUnit = " mm", s.yUnit = " cN"; }
  SECTION("without a blank") { s.xUnit = "mm", s.yUnit = "cN"; }
  SECTION("of something else") { s.xUnit = " s", s.yUnit = " V", known = false; }
  const auto axes = read(drawn(s));
  const AxisCalibration& cal = axes.calibration.value;
  CHECK(cal.x.unitFound == known);
  CHECK(cal.y.unitFound == known);
  if (!known) return;
  CHECK(cal.x.unit == "mm");
  CHECK(cal.y.unit == "cN");
  CHECK(worstCornerError_px(axes, s, 0.01) < 0.2);
}

TEST_CASE("a unit that stands instead of the last number but one is the axis'") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.left = 150, s.xTitle = "Travel", s.yTitle = "Force";
  std::string x = "mm", y = "cN";
  int fromTop = 1;
  bool known = true;
  SECTION("both") {}
  SECTION("of something else") { x = "ms", y = "mV", known = false; }
  SECTION("in another number's stead it may be anything") { fromTop = 3, known = false; }
  Canvas c(s.width, s.height, s.paperGrey);
  drawInto(c, s);
  const double atX = s.right - fromTop * (s.right - s.left) / s.xSteps,
               atY = s.top + fromTop * (s.bottom - s.top) / s.ySteps;
  c.fill(atX - 28, s.bottom + 9, atX + 28, s.bottom + 34, s.paperGrey);
  c.fill(s.left - 60, atY - 12, s.left - 9, atY + 12, s.paperGrey);
  c.text(x, atX, s.bottom + s.labelDrop, s.textGrey, 0.6);
  c.text(y, s.left - 27, atY, s.textGrey, 0.6);
  const auto axes = read(c.grey());
  const AxisCalibration& cal = axes.calibration.value;
  CHECK((cal.y.unitFound && cal.y.unit == "cN") == known);
  if (!known) return;
  CHECK(cal.x.unit == "mm");
  CHECK(cal.x.unitFound);
  CHECK(worstCornerError_px(axes, s, 0.01) < 0.2);
}

TEST_CASE("letters behind the numbers are no digits of them") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.left = 150, s.yStep = 50;
  s.yUnit = GENERATE(as<std::string>{}, "g", "gf", "cN", "N");
  CAPTURE(s.yUnit);
  const auto looked = readingOfWhole(drawn(s));
  const auto axes = readAxes(looked.view, looked.frame, {});
  if (!axes || axes->calibration.confidence < 0.5) return;  // doubted, not misread
  CHECK(axes->calibration.value.y.max == Approx(s.ySteps * s.yStep));
}

TEST_CASE("titles at the ends of the axes are read inside the plot, callouts are none") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.xTitle = s.yTitle = "", s.grid = s.box = false;
  Canvas c(s.width, s.height, s.paperGrey);
  drawInto(c, s);
  bool titles = true;
  std::string overEnd = "Travel [mm]", besideEnd = "Force [cN]";
  SECTION("titles") {}
  SECTION("callouts") { overEnd = "4.2 mm", besideEnd = "62 cN", titles = false; }
  c.text(overEnd, s.right - 65, s.bottom - 20, s.textGrey, 0.6);
  c.text(besideEnd, s.left + 20, s.top + 60, s.textGrey, 0.6, 1);
  const auto axes = read(c.grey());
  const AxisCalibration& cal = axes.calibration.value;
  CHECK((cal.x.unitFound && cal.x.unit == "mm") == titles);
  CHECK((cal.y.unitFound && cal.y.unit == "cN") == titles);
}

TEST_CASE("names of axes that end below the plot or run through its top are read") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.right = 700;
  SECTION("beside the end of a travel axis at zero") {
    s.xTitle = "", s.yFrom = -40;
    Canvas c(s.width, s.height, s.paperGrey);
    drawInto(c, s);
    c.text("Travel / mm", s.right + 80, s.bottom - 2 * (s.bottom - s.top) / s.ySteps, s.textGrey, 0.6);
    CHECK(read(c.grey()).calibration.value.x.unitFound);
  }
  SECTION("level beside the end of the force axis") {
    s.yTitle = "", s.grid = s.box = false;
    Canvas c(s.width, s.height, s.paperGrey);
    drawInto(c, s);
    c.text("Force (cN)", s.left + 75, s.top, s.textGrey, 0.6);
    const auto axes = read(c.grey());
    CHECK(axes.calibration.value.y.unitFound);
    CHECK(axes.calibration.value.y.unit == "cN");
  }
}

TEST_CASE(
    "a small unit in brackets is recognised by its shape behind letters that the engine does not know") {
  if (skipWithoutEngine()) return;
  PlotStyle s;
  s.yTitle = "";
  Canvas c(s.width, s.height, s.paperGrey);
  drawInto(c, s);
  const double lowEdge = 26, square_px = 11;
  for (const double x : {s.left - 40, s.left - 27}) {  // square letters of strokes that hang together
    for (const double row : {lowEdge - square_px, lowEdge - 6, lowEdge})
      c.row(row, x, x + square_px, 1, s.textGrey);
    c.column(x + 3, lowEdge - square_px, lowEdge, 1, s.textGrey);
    c.column(x + 8, lowEdge - 6, lowEdge, 1, s.textGrey);
  }
  const std::string unit = GENERATE(as<std::string>{}, "(gf)", "(cN)", "(N)");
  c.text(unit, s.left + 2, lowEdge - 4, s.textGrey, 0.4);
  const auto axes = read(c.grey());
  CAPTURE(unit);
  CHECK(axes.calibration.value.y.unitFound);
  CHECK("(" + axes.calibration.value.y.unit + ")" == unit);
}

TEST_CASE("a sign wider than its line is high is no letter") {
  if (skipWithoutEngine()) return;
  const auto readWith = [](double wider) {
    cv::Mat sign(40, 24, CV_8U, cv::Scalar(255)), line(60, 260, CV_8U, cv::Scalar(255));
    cv::putText(sign, "B", {2, 32}, cv::FONT_HERSHEY_SIMPLEX, 1, cv::Scalar(0), 2, cv::LINE_AA);
    cv::resize(sign, sign, cv::Size(), wider, 1, cv::INTER_AREA);
    sign.copyTo(line(cv::Rect(10, 10, sign.cols, sign.rows)));
    cv::putText(line, "[gf]", {20 + sign.cols, 42}, cv::FONT_HERSHEY_SIMPLEX, 1, cv::Scalar(0), 2,
                cv::LINE_AA);
    const auto document = documentOf(line);
    const auto view = document.view(document.page(1).value(), {-0.5, -0.5, 259.5, 59.5}).value();
    TextReader reader(view);
    return reader.readLine({8, 12, 100.0 + sign.cols, 52}, TextKind::words).utf8;
  };
  CHECK(readWith(1).substr(0, 1) == "B");
  CHECK(readWith(3.5).substr(0, 3) == "\uFFFD");
}

TEST_CASE("words are read in any quarter turn") {
  if (skipWithoutEngine()) return;
  Canvas c(300, 300, 255);
  const int turns = GENERATE(0, 1, 3);
  c.text("Kraft", 150, 150, 0, 1.0, turns);
  const auto document = documentOf(c.grey());
  const auto page = document.page(1).value();
  const auto view = document.view(page, {-0.5, -0.5, 299.5, 299.5}).value();
  TextReader reader(view);
  const Box box = turns == 0 ? Box{95, 130, 205, 175} : Box{125, 95, 175, 205};
  CHECK(reader.readLine(box, TextKind::words, 90.0 * turns).utf8 == "Kraft");
  CHECK(reader.readLine({10, 10, 40, 30}, TextKind::words).utf8.empty());
  CHECK(reader.readLine({-50, -50, -10, -10}, TextKind::words).utf8.empty());
}
