// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn stands where the axes say, in every unit, zoom and theme.
#include <cmath>
#include <QSignalSpy>

#include "editor/canvas/curve_path.h"
#include "editor/canvas/displacement_force_view.h"
#include "editor/canvas/graph_painting.h"
#include "editor/canvas/unit_ticker.h"
#include "model/edits.h"
#include "model/file/button_file.h"
#include "model/unit_spread.h"
#include "tests/editor/window_tests.h"
#include "tests/editor/workspace_rig.h"

using namespace detent;
using namespace detent::editor;
using namespace detent::editor::tests;

namespace {

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

PlotMapping someMapping() { return {QRectF(50, 10, 700, 500), {50.5, 509.5}, 0, 0, 700 / 4.2, 500 / 1.4}; }

// A page on which one block of pixels is red: x 100..119, y 200..219.
std::shared_ptr<const importer::ImportReport> markedPage(const Button& button) {
  auto report = std::make_shared<importer::ImportReport>(button);
  auto evidence = std::make_shared<importer::GraphEvidence>();
  importer::Raster& raster = evidence->view.raster;
  raster.width_px = 800;
  raster.height_px = 600;
  raster.rgb.assign(std::size_t(800) * 600 * 3, 255);
  for (std::size_t y = 200; y < 220; ++y)
    for (std::size_t x = 100; x < 120; ++x) {
      raster.rgb[3 * (800 * y + x) + 1] = 0;
      raster.rgb[3 * (800 * y + x) + 2] = 0;
    }
  // The centre of the block, (109.5, 209.5), is 1 mm and 0.8 N.
  const double mmPerPx = 0.01, newtonPerPx = 0.004;
  evidence->axes.calibration.value.viewToUnits = {
      mmPerPx, 0, 1 - 109.5 * mmPerPx, 0, -newtonPerPx, 0.8 + 209.5 * newtonPerPx, 0, 0, 1};
  report->evidence = evidence;
  report->strokes.press.points = {{0, 0.3}, {1, 0.5}, {2, 0.45}, {3, 0.5}};
  return report;
}

QColor pixelOf(QWidget& widget, QPointF at) { return widget.grab().toImage().pixelColor(at.toPoint()); }

}  // namespace

class CanvasTest : public QObject {
  Q_OBJECT

 private slots:
  void mappingGoesBothWays();
  void gridlineOfAValueIsWhereTheMappingSays();
  void polylinesStayOnTheCurve();
  void manyKnotsMakeFewPoints();
  void polylinesLeaveOutWhatIsNotSeen();
  void steepZoomStaysFinite();
  void ticksAreRoundInTheUsersUnit();
  void unitsChangeLabelsAndNotTheView();
  void theReferenceIsSeenWhole();
  void pageLiesUnderTheAxes();
  void opacityHidesThePage();
  void darkThemeTurnsThePaper();
  void themeChangeRecolours();
  void residualsAreDrawnOnDemand();
  void fingerIsDrawnInBothViews();
  void bothStrokesAreSeenWhereTheyCoincide();
  void theLegendKeepsOffTheStrokes();
  void labelsKeepOffTheBottomOut();
  void wordsOfANoteLeaveItsNumberFree();
  void wordsOfANoteLeaveTheStrokesFree();
  void unitsScatterAsABandBehindTheirMean();
  void jumpIsAVerticalLine();
  void cursorIsReported();
  void magnifierShowsWhileDragging();
};

void CanvasTest::mappingGoesBothWays() {
  const PlotMapping map = someMapping();
  for (const QPointF at : {QPointF(0, 0), QPointF(1.3, 0.55), QPointF(4.2, 1.4)}) {
    const QPointF back = map.toPlot(map.toPixel(at));
    QVERIFY(near(back.x(), at.x(), 1e-12) && near(back.y(), at.y(), 1e-12));
    QCOMPARE(map.transform().map(at), map.toPixel(at));
  }
  const PlotMapping lens = map.magnified({1.3, 0.55}, QRectF(600, 300, 100, 100), 5);
  QCOMPARE(lens.toPixel(1.3, 0.55), QPointF(650, 350));
  QVERIFY(near(lens.pxPerX, 5 * map.pxPerX, 1e-9));
}

void CanvasTest::gridlineOfAValueIsWhereTheMappingSays() {
  WorkspaceRig rig(require(linearButton()));
  GraphCanvas& canvas = rig.canvas();
  // QCustomPlot names the left edge of a pixel; its centre is half a pixel further.
  const QPointF at = canvas.mapping().toPixel(2, 0.5);
  QVERIFY(near(at.x(), canvas.xAxis->coordToPixel(2) + 0.5, 1e-9));
  QVERIFY(near(at.y(), canvas.yAxis->coordToPixel(0.5) + 0.5, 1e-9));
}

void CanvasTest::polylinesStayOnTheCurve() {
  const StrokeCurve curve = require(clickyButton()).states()[0].graph.press();
  const PlotMapping map = someMapping();
  const auto lines = curvePolylines(curve, map, 0.1);
  QCOMPARE(lines.size(), std::size_t(1));
  for (qsizetype i = 0; i + 1 < lines[0].size(); ++i) {
    const QPointF middle = 0.5 * (lines[0][i] + lines[0][i + 1]);
    const double x = map.toPlot(middle).x();
    if (lines[0][i].x() == lines[0][i + 1].x()) continue;  // a vertical rise
    QVERIFY(near(middle.y(), map.toPixel(x, curve.force_N(x)).y(), 0.35));
  }
  QCOMPARE(lines[0].front(), map.toPixel(0, curve.knots().front().force_N));
  QCOMPARE(lines[0].back(), map.toPixel(curve.end_mm(), curve.knots().back().force_N));
}

void CanvasTest::manyKnotsMakeFewPoints() {
  const StrokeCurve plain = require(tactileButton()).states()[0].graph.press();
  std::vector<CurvePoint> points;
  for (int i = 0; i <= 1000; ++i) points.push_back({3.99 * i / 1000, plain.force_N(3.99 * i / 1000)});
  const auto curve = StrokeCurve::throughPoints(points);
  QVERIFY(curve.ok());
  const PlotMapping map = someMapping();
  const auto lines = curvePolylines(*curve, map, 0.2);
  QCOMPARE(lines.size(), std::size_t(1));
  QVERIFY2(lines[0].size() < 150, qPrintable(QString::number(lines[0].size())));
  for (const CurvePoint& p : points) {  // no point is missed
    const QPointF at = map.toPixel(p.displacement_mm, p.force_N);
    double nearest = 1e9;
    for (qsizetype i = 0; i + 1 < lines[0].size(); ++i) {
      const QPointF a = lines[0][i], along = lines[0][i + 1] - a;
      const double t =
          std::clamp(QPointF::dotProduct(at - a, along) / QPointF::dotProduct(along, along), 0.0, 1.0);
      const QPointF off = a + t * along - at;
      nearest = std::min(nearest, std::hypot(off.x(), off.y()));
    }
    QVERIFY(nearest < 0.4);
  }
}

void CanvasTest::polylinesLeaveOutWhatIsNotSeen() {
  const StrokeCurve curve = require(tactileButton()).states()[0].graph.press();
  PlotMapping map = someMapping();
  map.originX = 1.2;
  map.pxPerX = 700 / 0.2;  // 1.2 to 1.4 mm
  for (const QPolygonF& line : curvePolylines(curve, map))
    for (const QPointF& p : line) QVERIFY(map.clip_px.adjusted(-65, -65, 65, 65).contains(p));
  map.originY = 5;  // far above the curve
  QVERIFY(curvePolylines(curve, map).empty());
}

void CanvasTest::steepZoomStaysFinite() {
  WorkspaceRig rig(require(clickyButton()));
  GraphCanvas& canvas = rig.canvas();
  for (int i = 0; i < 120; ++i) canvas.zoomAt(rig.pixel(1.7, 0.6), 2, 2);
  canvas.grab();
  QVERIFY(canvas.shownRange().width() > 0 && std::isfinite(canvas.shownRange().left()));
  for (int i = 0; i < 240; ++i) canvas.zoomAt({200, 200}, 0.5, 0.5);
  canvas.grab();
  QVERIFY(std::isfinite(canvas.shownRange().width()));
}

void CanvasTest::ticksAreRoundInTheUsersUnit() {
  UnitTicker ticker;
  ticker.setUnit(25.4);  // inch on an axis in mm
  QVector<double> ticks;
  QVector<QString> labels;
  ticker.generate({0, 5}, QLocale::c(), 'g', 6, ticks, nullptr, &labels);
  QVERIFY(ticks.size() > 2);
  for (qsizetype i = 0; i < ticks.size(); ++i) QVERIFY(near(labels[i].toDouble() * 25.4, ticks[i], 1e-9));
  QVERIFY(near((ticks[1] - ticks[0]) / 25.4, 0.05, 1e-9) || near((ticks[1] - ticks[0]) / 25.4, 0.02, 1e-9));
}

void CanvasTest::theReferenceIsSeenWhole() {
  WorkspaceRig rig(require(tactileButton()));
  const auto press = StrokeCurve::fromKnots({{0, 0, 1, 1}, {5, 2, 0, 0}});
  const auto release = StrokeCurve::fromKnots({{0, -0.8, 0, 0}, {5, 1.5, 0, 0}});
  const auto graph = ForceGraph::fromCurves(*press, *release);
  rig.canvas().showReference(Reference{{"", *graph, {}, {}, {}}, "other"});
  for (const QPointF end : {QPointF(0, -0.8), QPointF(5, 2)})
    QVERIFY(rig.canvas().mapping().clip_px.contains(rig.pixel(end.x(), end.y())));
  QCoreApplication::processEvents();
  QSignalSpy drawn(&rig.canvas(), &QCustomPlot::afterReplot);
  rig.canvas().showPreview(ButtonState{"", *graph, {}, {}, {}});
  rig.canvas().showSpread({});
  QCoreApplication::processEvents();
  QCOMPARE(drawn.size(), 0);  // axes and page are as they were
  rig.canvas().showReference({});
  QVERIFY(!rig.canvas().mapping().clip_px.contains(rig.pixel(5, 2)));
}

void CanvasTest::unitsChangeLabelsAndNotTheView() {
  WorkspaceRig rig(require(tactileButton()));
  const QRectF shown = rig.canvas().shownRange();
  rig.settings.setUnits({LengthUnit::inch, ForceUnit::gramForce});
  QVERIFY(rig.canvas().yAxis->label().contains("gf"));
  QVERIFY(rig.canvas().xAxis->label().contains("in"));
  QCOMPARE(rig.canvas().shownRange(), shown);
}

void CanvasTest::pageLiesUnderTheAxes() {
  const Button button = require(linearButton());
  WorkspaceRig rig(button);
  rig.document.setOrigin(markedPage(button));
  rig.settings.setUnderlayOpacity(1);
  QCoreApplication::processEvents();
  const auto redAt = [&](double mm, double N) {
    const QColor color = pixelOf(rig.canvas(), rig.pixel(mm, N));
    return color.red() > 150 && color.green() < 90;
  };
  QVERIFY(rig.canvas().hasUnderlay());
  for (const double zoom : {1.0, 3.0, 0.5}) {
    rig.canvas().zoomAt(rig.pixel(1, 0.8), zoom, zoom);  // zooms at the middle of the block
    QCoreApplication::processEvents();
    // The block spans ±0.1 mm and ±0.04 N around (1, 0.8).
    QVERIFY(redAt(0.95, 0.82) && redAt(1.05, 0.78));
    QVERIFY(!redAt(0.85, 0.82) && !redAt(1.15, 0.82) && !redAt(0.95, 0.85) && !redAt(0.95, 0.75));
  }
}

void CanvasTest::opacityHidesThePage() {
  const Button button = require(linearButton());
  WorkspaceRig rig(button);
  rig.document.setOrigin(markedPage(button));
  rig.settings.setUnderlayOpacity(0);
  QCoreApplication::processEvents();
  QCOMPARE(pixelOf(rig.canvas(), rig.pixel(0.96, 0.82)), rig.canvas().colors().background);
}

void CanvasTest::darkThemeTurnsThePaper() {
  const Button button = require(linearButton());
  WorkspaceRig rig(button);
  rig.document.setOrigin(markedPage(button));
  rig.settings.setUnderlayOpacity(1);
  QPalette dark;
  dark.setColor(QPalette::Window, QColor(30, 32, 36));
  dark.setColor(QPalette::WindowText, Qt::white);
  rig.canvas().setPalette(dark);
  QCoreApplication::processEvents();
  QVERIFY(pixelOf(rig.canvas(), rig.pixel(0.56, 0.7)).lightness() < 40);
  const QColor block = pixelOf(rig.canvas(), rig.pixel(0.96, 0.82));
  QVERIFY(block.red() > block.green() && block.red() > block.blue());  // the hue stays
}

void CanvasTest::themeChangeRecolours() {
  WorkspaceRig rig(require(tactileButton()));
  const QColor light = rig.canvas().colors().background;
  QPalette dark;
  dark.setColor(QPalette::Window, QColor(30, 32, 36));
  dark.setColor(QPalette::WindowText, Qt::white);
  rig.canvas().setPalette(dark);
  QCoreApplication::processEvents();
  QVERIFY(rig.canvas().colors().background != light);
  QCOMPARE(pixelOf(rig.canvas(), rig.pixel(0.06, 1.13)), rig.canvas().colors().background);
}

void CanvasTest::residualsAreDrawnOnDemand() {
  const Button button = require(linearButton());
  WorkspaceRig rig(button);
  rig.document.setOrigin(markedPage(button));
  rig.settings.setUnderlayOpacity(0);
  QCoreApplication::processEvents();
  const QImage without = rig.canvas().grab().toImage();
  rig.action("viewResiduals")->setChecked(true);
  QVERIFY(rig.settings.residualsShown());
  QCoreApplication::processEvents();
  QVERIFY(rig.canvas().grab().toImage() != without);
}

void CanvasTest::fingerIsDrawnInBothViews() {
  WorkspaceRig rig(require(tactileButton()));
  rig.action("viewDisplacementForce")->setChecked(true);
  QCoreApplication::processEvents();
  auto* reverse = rig.workspace.findChild<DisplacementForceView*>();
  QVERIFY(reverse->isVisible());
  rig.workspace.showFinger(FingerPosition{0.8, 0.9, Stroke::press});
  QCOMPARE(pixelOf(rig.canvas(), rig.pixel(0.8, 0.9)), rig.canvas().colors().press);
  QCOMPARE(pixelOf(*reverse, reverse->mapping().toPixel(0.9, 0.8)), reverse->colors().press);
  // A finger that presses harder than the plot is high stays at its edge, and is whole there.
  rig.workspace.showFinger(FingerPosition{0, 99, Stroke::press});
  const QPointF corner = rig.canvas().mapping().inClip(rig.pixel(0, 99));
  for (const QPointF& aside : {QPointF(-4, 2), QPointF(4, -2)})
    QCOMPARE(pixelOf(rig.canvas(), corner + aside), rig.canvas().colors().press);
  const QPointF turned = reverse->mapping().inClip(reverse->mapping().toPixel(99, 0));
  QCOMPARE(pixelOf(*reverse, turned + QPointF(3, 1)), reverse->colors().press);
  rig.workspace.showFinger({});
  QVERIFY(pixelOf(rig.canvas(), rig.pixel(0.8, 0.9)) != rig.canvas().colors().press);
}

// Forces that fall from the start run where the legend usually stands.
void CanvasTest::theLegendKeepsOffTheStrokes() {
  const auto press = StrokeCurve::throughPoints({{0, 0.9}, {0.5, 1}, {1.5, 0.9}, {2.5, 0.4}, {4, 0.3}});
  const auto release = StrokeCurve::throughPoints({{0, 0.8}, {0.5, 0.9}, {1.5, 0.8}, {2.5, 0.3}, {4, 0.3}});
  QVERIFY(press.ok() && release.ok());
  const auto graph = ForceGraph::fromCurves(*press, *release);
  QVERIFY(graph.ok());
  std::vector<ButtonState> states = require(tactileButton()).states();
  states[0].graph = *graph;
  states[0].operatingPoint_mm = states[0].resetPoint_mm = {};
  WorkspaceRig rig(require(Button::fromStates("falling", states)));
  GraphCanvas canvas(rig.document, rig.settings);
  canvas.setHandlesShown(false);
  canvas.resize(420, 220);
  const QImage image = canvas.grab().toImage();
  const PlotMapping map = canvas.mapping();
  const QColor pressColor = canvas.colors().press;
  int seen = 0, all = 0;
  for (double at_mm = 0.05; at_mm < 1.4; at_mm += 0.05) {
    const QColor there = image.pixelColor(map.toPixel(at_mm, press->force_N(at_mm)).toPoint());
    ++all;
    seen += std::abs(there.red() - pressColor.red()) + std::abs(there.blue() - pressColor.blue()) < 120;
  }
  QVERIFY2(seen > 0.8 * all, qPrintable(QString("%1 of %2 places of the press are seen").arg(seen).arg(all)));
}

// The dashed release is drawn over the press: between its dashes the press is seen.
void CanvasTest::bothStrokesAreSeenWhereTheyCoincide() {
  std::vector<ButtonState> states = require(linearButton()).states();
  const StrokeCurve press = states[0].graph.press();
  const auto graph = ForceGraph::fromCurves(press, press);
  QVERIFY(graph.ok());
  states[0].graph = *graph;
  WorkspaceRig rig(require(Button::fromStates("coinciding", states)));
  GraphCanvas canvas(rig.document, rig.settings);
  canvas.setHandlesShown(false);
  canvas.resize(600, 400);
  const QImage image = canvas.grab().toImage();
  const PlotMapping map = canvas.mapping();
  const auto seen = [&](const QColor& color) {
    int count = 0;
    for (double at_mm = 1; at_mm < 3; at_mm += 0.02) {
      const QColor there = image.pixelColor(map.toPixel(at_mm, press.force_N(at_mm)).toPoint());
      count += std::abs(there.red() - color.red()) + std::abs(there.green() - color.green()) +
                   std::abs(there.blue() - color.blue()) <
               60;
    }
    return count;
  };
  const int ofPress = seen(canvas.colors().press), ofRelease = seen(canvas.colors().release);
  QVERIFY2(ofPress >= 10 && ofRelease >= 30,
           qPrintable(QString("press %1, release %2").arg(ofPress).arg(ofRelease)));
}

// Labels cover neither the press, also where it is steep, nor the line at the end of the travel.
void CanvasTest::labelsKeepOffTheBottomOut() {
  for (const char* name : {"B", "C", "D", "E", "F"}) {
    const Button button =
        require(readButtonFile(std::string(DETENT_SOURCE_DIR "/samples/buttons/") + name + ".button.json"));
    const ButtonState& state = button.states()[0];
    const ForceGraph& graph = state.graph;
    const GraphValues values = valuesOf(graph);
    const GraphColors colors = graphColors(false);
    const double most_N = std::max(graph.press().forceRange_N().second, 0.1);
    for (const QSizeF size : {QSizeF(1000, 560), QSizeF(700, 420)}) {
      const PlotMapping map{{QPointF(), size},
                            {0, size.height()},
                            0,
                            0,
                            size.width() / (1.05 * graph.travel_mm()),
                            size.height() / (1.1 * most_N)};
      std::vector<Flag> flags;
      const DisplayUnits units;
      const CanvasFeedback feedback;
      GraphScene scene{state, values, colors, units, feedback, {}, {}, nullptr, {}, {}, true, {}};
      scene.flags = &flags;
      QImage picture(size.toSize(), QImage::Format_RGB32);
      QPainter painter(&picture);
      paintGraph(painter, map, scene);
      QVERIFY(flags.size() >= 2);
      const double end_px = map.toPixel(graph.travel_mm(), 0).x();
      for (const Flag& flag : flags) {
        if (isContact(flag.mark.kind)) continue;  // arrows of dimensions, and labels on their own lines
        QVERIFY2(flag.box_px.right() < end_px || flag.box_px.left() > end_px,
                 qPrintable(QString("%1: a label from %2 to %3, the end at %4")
                                .arg(name)
                                .arg(flag.box_px.left())
                                .arg(flag.box_px.right())
                                .arg(end_px)));
        const StrokeCurve& press = graph.press();
        for (int i = 0; i <= 1000; ++i) {
          const double at_mm = press.start_mm() + press.travel_mm() * i / 1000;
          QVERIFY2(!flag.box_px.contains(map.toPixel(at_mm, press.force_N(at_mm))),
                   qPrintable(QString("%1 at %2 mm").arg(name).arg(at_mm)));
        }
      }
    }
  }
}

void CanvasTest::wordsOfANoteLeaveItsNumberFree() {
  WorkspaceRig rig(require(tactileButton()));
  Annotations noted;
  noted.notes = {{0, Stroke::press, 1.3, "the peak must stay below this, or it is felt as a click"}};
  rig.document.annotate(noted, "note");
  GraphCanvas canvas(rig.document, rig.settings);
  canvas.setHandlesShown(false);
  for (const int width : {280, 340, 420}) {
    canvas.resize(width, 240);
    const QImage image = canvas.grab().toImage();
    const double force_N = rig.document.graph().press().force_N(1.3);
    const QPointF flag = canvas.mapping().toPixel(1.3, force_N) - QPointF(0, 46);
    int dark = 0;  // dark pixels of the ring around the number
    for (int degrees = 0; degrees < 360; degrees += 30) {
      const double angle = degrees * 3.14159265 / 180;
      const QPoint at = (flag + 8 * QPointF(std::cos(angle), std::sin(angle))).toPoint();
      int darkest = 255;
      for (const QPoint& by : {QPoint(0, 0), QPoint(1, 0), QPoint(-1, 0), QPoint(0, 1), QPoint(0, -1)})
        darkest = std::min(darkest, qGray(image.pixel(at + by)));
      dark += darkest < 140;
    }
    QVERIFY2(dark >= 10, qPrintable(QString("%1 of 12 at a width of %2").arg(dark).arg(width)));
  }
}

// In the valley the words would lie over the rise behind it: they stand where the strokes are not.
void CanvasTest::wordsOfANoteLeaveTheStrokesFree() {
  WorkspaceRig rig(require(tactileButton()));
  const StrokeCurve press = rig.document.graph().press();
  GraphCanvas canvas(rig.document, rig.settings);
  canvas.setHandlesShown(false);
  canvas.resize(420, 260);
  for (const double at_mm : {0.3, 0.9, 1.7, 2.0, 2.6}) {
    rig.document.annotate({}, "none");
    const QImage before = canvas.grab().toImage();
    Annotations noted;
    noted.notes = {{0, Stroke::press, at_mm, "sample A: too hard?"}};
    rig.document.annotate(noted, "note");
    const QImage with = canvas.grab().toImage();
    int hidden = 0;
    for (double there_mm = 0.02; there_mm < press.end_mm(); there_mm += 0.02) {
      const QPoint at = canvas.mapping().toPixel(there_mm, press.force_N(there_mm)).toPoint();
      hidden += std::abs(there_mm - at_mm) > 0.1 && with.pixel(at) != before.pixel(at);
    }
    QVERIFY2(hidden <= 6, qPrintable(QString("%1 places of the press at %2 mm").arg(hidden).arg(at_mm)));
  }
}

void CanvasTest::unitsScatterAsABandBehindTheirMean() {
  const Button soft = require(tactileButton());
  const Button hard = require(scaleForce(soft, 1.5));
  const auto spread = spreadOf({soft, hard});
  QVERIFY(spread.ok());
  WorkspaceRig rig(spread->mean);
  GraphCanvas canvas(rig.document, rig.settings);
  canvas.resize(700, 500);
  canvas.setHandlesShown(false);
  const QImage before = canvas.grab().toImage();
  const BandPoint& middle = spread->states[0].press[100];
  const PlotMapping map = canvas.mapping();
  const QPointF inside = map.toPixel(middle.displacement_mm, middle.mean_N + 0.9 * middle.sd_N);
  const QPointF outside = map.toPixel(middle.displacement_mm, middle.mean_N + 1.3 * middle.sd_N);
  canvas.showSpread(spread->states);
  const QImage with = canvas.grab().toImage();
  QVERIFY(with.pixelColor(inside.toPoint()) != before.pixelColor(inside.toPoint()));
  QCOMPARE(with.pixelColor(outside.toPoint()), before.pixelColor(outside.toPoint()));
  const QPointF mean =
      map.toPixel(middle.displacement_mm, canvas.state().graph.press().force_N(middle.displacement_mm));
  QCOMPARE(with.pixelColor(mean.toPoint()), before.pixelColor(mean.toPoint()));  // the curve lies over it
  const QImage picture = canvas.renderImage({700, 500}, 1);
  canvas.showSpread({});
  QVERIFY(canvas.renderImage({700, 500}, 1) != picture);  // exported pictures show the spread, too
}

void CanvasTest::jumpIsAVerticalLine() {
  WorkspaceRig rig(require(tactileButton()));
  rig.action("viewDisplacementForce")->setChecked(true);
  QCoreApplication::processEvents();
  auto* reverse = rig.workspace.findChild<DisplacementForceView*>();
  const Section jump = rig.canvas().values().press.sections.at(1);
  QCOMPARE(jump.kind, SectionKind::jump);
  const QImage picture = reverse->grab().toImage();
  for (const double share : {0.2, 0.4, 0.8}) {
    const double x = jump.from_mm + share * (jump.to_mm - jump.from_mm);
    const QPointF at = reverse->mapping().toPixel(jump.fromForce_N, x);
    QCOMPARE(picture.pixelColor(at.toPoint()), reverse->colors().press);
  }
}

void CanvasTest::cursorIsReported() {
  WorkspaceRig rig(require(tactileButton()));
  std::optional<CurvePoint> seen;
  QObject::connect(&rig.workspace, &GraphWorkspace::cursorMoved,
                   [&](std::optional<CurvePoint> at) { seen = at; });
  rig.mouse(QEvent::MouseMove, rig.pixel(1.5, 0.8), Qt::NoButton);
  QVERIFY(seen && near(seen->displacement_mm, 1.5, 1e-9) && near(seen->force_N, 0.8, 1e-9));
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(&rig.canvas(), &leave);
  QVERIFY(!seen);
}

void CanvasTest::magnifierShowsWhileDragging() {
  WorkspaceRig rig(require(tactileButton()));
  const MarkId tactile{MarkKind::tactilePoint, Stroke::press, 0};
  const QPointF from = rig.pixel(tactile);
  rig.press(from);
  rig.move(from + QPointF(4, -4));
  const QImage with = rig.canvas().grab().toImage();
  rig.action("viewMagnifier")->setChecked(false);
  const QImage without = rig.canvas().grab().toImage();
  QVERIFY(with != without);
  rig.release(from + QPointF(4, -4));
}

DETENT_WINDOW_TEST(CanvasTest)
#include "canvas_test.moc"
