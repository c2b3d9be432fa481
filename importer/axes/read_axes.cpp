#include <algorithm>
#include <cmath>
#include <iterator>

#include <opencv2/core/matx.hpp>
#include <opencv2/imgproc.hpp>

#include "importer/axes/axis_calibration.h"
#include "importer/axes/printed_unit.h"
#include "importer/axes/progression.h"
#include "importer/axes/read_text.h"
#include "importer/axes/text_lines.h"
#include "importer/frame/darkness.h"
#include "importer/frame/glyph_marks.h"
#include "importer/frame/label_rows.h"

namespace detent::importer {
namespace {

constexpr int rowAttempts = 3;  // rows of words tried per axis before giving up
constexpr double newtonAtMost =
    5;  // an unnamed force axis that ends below this is in newton: no button pushes 5 gf

/// Everything the reading of one graph shares.
struct Reading {
  const PageView& view;
  const PlotFrame& frame;
  Box box;
  std::vector<Box> glyphs;  ///< all blobs of the view up to the size of large letters
  TextReader reader;
  std::vector<SeenText> texts;
  std::vector<std::string> warnings;
};

std::vector<double> positions(const std::vector<GridLine>& lines) {
  std::vector<double> out;
  for (const auto& line : lines) out.push_back(line.position_px);
  return out;
}

double largestGlyph(const Box& frame) { return 0.16 * std::min(frame.width(), frame.height()) + 10; }

/// One axis with its numbers.
struct AxisFit {
  Progression progression;
  std::vector<SeenText> words;  ///< the labels, in order along the axis
  Box extent;                   ///< around the labels
};

SeenText readNumber(Reading& r, const Box& word) {
  for (const auto& t : r.view.texts) {
    const double cx = 0.5 * (t.box.x0 + t.box.x1), cy = 0.5 * (t.box.y0 + t.box.y1);
    if (word.contains({cx, cy}) && printedNumber(t.utf8)) return {t.utf8, word, 1.0, 0.0};
  }
  return r.reader.readLine(word, TextKind::number);
}

/// Words of the document's own text that are numbers, and words of ink where there is no text.
std::vector<Box> numberWords(Reading& r, const Box& band) {
  std::vector<Box> words;
  for (const auto& t : r.view.texts)
    if (std::abs(t.angle_deg) < 20 && t.box.x1 > band.x0 && t.box.x0 < band.x1 && t.box.y1 > band.y0 &&
        t.box.y0 < band.y1 && printedNumber(t.utf8))
      words.push_back(t.box);
  if (words.size() >= 2) return words;
  const double largest = 0.12 * std::min(r.box.width(), r.box.height()) + 10;
  return wordBoxes(glyphsIn(r.glyphs, band, largest), labelGapInHeights);
}

std::optional<AxisFit> fitRow(Reading& r, const LabelRow& row, const std::vector<GridLine>& ticks,
                              bool horizontal) {
  AxisFit fit;
  std::vector<LabelPlace> labels;
  double height = 0;
  for (const auto& w : row.words) height = std::max(height, w.height());
  for (const auto& w : row.words) {
    if (w.height() < 0.5 * height) continue;
    auto seen = readNumber(r, w);
    LabelPlace place;
    place.center_px = horizontal ? 0.5 * (w.x0 + w.x1) : 0.5 * (w.y0 + w.y1);
    place.reach_px = 0.45 * height + 1.5;
    place.readings = numberReadings(seen.utf8);
    fit.extent = fit.words.empty() ? w
                                   : Box{std::min(fit.extent.x0, w.x0), std::min(fit.extent.y0, w.y0),
                                         std::max(fit.extent.x1, w.x1), std::max(fit.extent.y1, w.y1)};
    labels.push_back(std::move(place));
    fit.words.push_back(std::move(seen));
  }
  auto progression = fitProgression(labels, ticks, horizontal);
  if (!progression) return std::nullopt;
  fit.progression = std::move(*progression);
  return fit;
}

bool better(const AxisFit& a, const std::optional<AxisFit>& b) {
  return !b || a.progression.labels > b->progression.labels;
}

/// Rows of labels are tried from the most regular one on, until one makes a progression.
std::optional<AxisFit> readAxis(Reading& r, bool horizontal) {
  const Box& b = r.box;
  const double w = b.width(), h = b.height();
  const Box band = horizontal ? Box{b.x0 - 0.12 * w, b.y1 + 1, b.x1 + 0.12 * w, b.y1 + 0.3 * h}
                              : Box{b.x0 - 0.36 * w, b.y0 - 0.1 * h, b.x0 - 1, b.y1 + 0.08 * h};
  auto words = numberWords(r, band);
  auto lines = horizontal ? r.frame.xLines : r.frame.yLines;
  for (auto& line : lines)
    line.position_px -= horizontal ? r.frame.drawnOffset_px.x : r.frame.drawnOffset_px.y;
  const auto ticks = positions(lines);
  std::optional<AxisFit> best;
  for (int n = 0; n < rowAttempts; ++n) {
    const auto row = horizontal ? labelsBelow(words, b, ticks) : labelsLeft(words, b, ticks);
    if (row.words.size() < 2) break;
    if (auto fit = fitRow(r, row, lines, horizontal); fit && better(*fit, best)) best = std::move(fit);
    if (best && best->progression.labels >= 3 &&
        2 * best->progression.labels > static_cast<int>(best->words.size()))
      break;
    std::erase_if(words, [&](const Box& word) {
      return std::find(row.words.begin(), row.words.end(), word) != row.words.end();
    });
  }
  return best;
}

Failure noNumbers(const char* axis) {
  return {FailureCode::noForceGraph, "plot frame", std::string(axis) + " axis",
          "no row of numbers stands along it", std::string("Give the range with --") + axis + "-axis"};
}

Box turnedBack(const Box& b, int turns) { return turned(b, 4 - turns); }

/// Reads lines in a region, nearest to `towards` first; every line goes to the texts.
std::vector<SeenText> readLinesIn(Reading& r, const Box& region, double angle_deg, Point towards,
                                  std::size_t atMost) {
  const int turns = angle_deg == 90 ? 1 : 0;
  auto glyphs = glyphsIn(r.glyphs, region, largestGlyph(r.box));
  for (auto& g : glyphs) g = turned(g, turns);
  auto lines = textLines(glyphs, 1.3);
  for (auto& line : lines) line = turnedBack(line, turns);
  const auto distance = [&](const Box& b) {
    return std::hypot(0.5 * (b.x0 + b.x1) - towards.x, 0.5 * (b.y0 + b.y1) - towards.y);
  };
  std::sort(lines.begin(), lines.end(),
            [&](const Box& a, const Box& b) { return distance(a) < distance(b); });
  if (lines.size() > atMost) lines.resize(atMost);
  std::vector<SeenText> read;
  for (const auto& line : lines) {
    auto seen = r.reader.readLine(line, TextKind::words, angle_deg);
    if (seen.utf8.empty()) continue;
    r.texts.push_back(seen);
    read.push_back(std::move(seen));
  }
  return read;
}

std::vector<SeenText> ownTextsIn(Reading& r, const Box& region) {
  std::vector<SeenText> out;
  for (const auto& t : r.view.texts)
    if (region.contains({0.5 * (t.box.x0 + t.box.x1), 0.5 * (t.box.y0 + t.box.y1)}))
      out.push_back({t.utf8, t.box, 1.0, t.angle_deg});
  return out;
}

template <class Unit>
struct TitleUnit {
  std::optional<PrintedUnit<Unit>> unit;
  std::string title;
};

template <class Unit, class Parse>
void consider(TitleUnit<Unit>& best, const std::vector<SeenText>& lines, Parse parse) {
  for (const auto& line : lines) {
    const auto unit = parse(line.utf8);
    if (unit && (!best.unit || unit->sure > best.unit->sure)) {
      best.unit = unit;
      best.title = line.utf8;
    }
    if (best.title.empty()) best.title = line.utf8;
  }
}

TitleUnit<LengthUnit> readXTitle(Reading& r, const AxisFit& x) {
  const Box& b = r.box;
  TitleUnit<LengthUnit> best;
  const Box below{b.x0 - 0.05 * b.width(), x.extent.y1 + 1, b.x1 + 0.15 * b.width(),
                  std::max(x.extent.y1 + 0.2 * b.height(), x.extent.y1 + 6 * (x.extent.y1 - x.extent.y0))};
  const Box beside{x.extent.x1 + 2, b.y1 - 0.15 * b.height(), b.x1 + 0.45 * b.width(),
                   b.y1 + 0.25 * b.height()};
  consider(best, ownTextsIn(r, below), lengthUnitIn);
  consider(best, ownTextsIn(r, beside), lengthUnitIn);
  if (best.unit) return best;
  consider(best, readLinesIn(r, below, 0, {0.5 * (b.x0 + b.x1), x.extent.y1}, 3), lengthUnitIn);
  if (!best.unit) consider(best, readLinesIn(r, beside, 0, {b.x1, b.y1}, 4), lengthUnitIn);
  return best;
}

TitleUnit<ForceUnit> readYTitle(Reading& r, const AxisFit& y) {
  const Box& b = r.box;
  TitleUnit<ForceUnit> best;
  const Box left{b.x0 - 0.45 * b.width(), b.y0 - 0.05 * b.height(), y.extent.x0 - 1,
                 b.y1 + 0.05 * b.height()};
  const Box above{b.x0 - 0.4 * b.width(), b.y0 - 0.4 * b.height(), b.x0 + 0.5 * b.width(), b.y0 - 1};
  const Box corner{b.x0 - 0.35 * b.width(), b.y0 - 0.6 * b.height(), b.x0 + 0.12 * b.width(),
                   b.y0 + 0.02 * b.height()};
  const Box beside{left.x0, left.y0, b.x0, left.y1};
  consider(best, ownTextsIn(r, beside), forceUnitIn);
  consider(best, ownTextsIn(r, above), forceUnitIn);
  consider(best, ownTextsIn(r, corner), forceUnitIn);
  if (best.unit) return best;
  consider(best, readLinesIn(r, left, 90, {y.extent.x0, 0.5 * (b.y0 + b.y1)}, 2), forceUnitIn);
  if (!best.unit) consider(best, readLinesIn(r, above, 0, {b.x0, b.y0}, 4), forceUnitIn);
  if (!best.unit) consider(best, readLinesIn(r, corner, 90, {b.x0, b.y0}, 3), forceUnitIn);
  if (!best.unit) consider(best, readLinesIn(r, left, 0, {y.extent.x0, b.y0}, 2), forceUnitIn);
  return best;
}

/// Printed values at the frame's corners along one axis.
struct EndValues {
  double atStart = 0, atEnd = 0;  ///< left/right or top/bottom
};

EndValues endValues(const Progression& p, double start, double end) { return {p.value(start), p.value(end)}; }

/// Frames end at ticks: a value within a pixel of one is that one.
double settled(double value, const Progression& p) {
  const double nearest = std::round(value / p.substep) * p.substep;
  const double scale = std::pow(10.0, 9 - std::floor(std::log10(std::max(1e-12, p.substep))));
  const double clean = std::round(nearest * scale) / scale + 0.0;  // no negative zero
  return std::abs(p.position(nearest) - p.position(value)) <= 1.2 ? clean : value;
}

std::vector<TickLabel> tickLabels(const AxisFit& fit) {
  std::vector<TickLabel> out;
  for (std::size_t i = 0; i < fit.words.size(); ++i) {
    const int k = fit.progression.reading[i];
    const auto readings = numberReadings(fit.words[i].utf8);
    if (readings.empty()) continue;
    TickLabel label;
    label.position_px = fit.progression.tickOf[i];
    label.value = readings[k >= 0 ? static_cast<std::size_t>(k) : 0].value;
    label.text = fit.words[i].utf8;
    label.box = fit.words[i].box;
    label.used = k >= 0;
    out.push_back(std::move(label));
  }
  return out;
}

/// Four corners to the values there: exact for upright frames, projective for leaning ones.
std::array<double, 9> homographyOf(const PlotFrame& frame, const EndValues& x, const EndValues& y) {
  const cv::Matx33d unitToValue(x.atEnd - x.atStart, 0, x.atStart, 0, y.atEnd - y.atStart, y.atStart, 0, 0,
                                1);
  std::vector<cv::Point2d> from, to{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  cv::Matx<double, 8, 8> a = cv::Matx<double, 8, 8>::zeros();
  cv::Matx<double, 8, 1> b;
  for (int k = 0; k < 4; ++k) {
    const Point& p = frame.corners[static_cast<std::size_t>(k)];
    const auto& q = to[static_cast<std::size_t>(k)];
    const std::array<double, 8> r1{p.x, p.y, 1, 0, 0, 0, -q.x * p.x, -q.x * p.y},
        r2{0, 0, 0, p.x, p.y, 1, -q.y * p.x, -q.y * p.y};
    for (int c = 0; c < 8; ++c) {
      a(2 * k, c) = r1[static_cast<std::size_t>(c)];
      a(2 * k + 1, c) = r2[static_cast<std::size_t>(c)];
    }
    b(2 * k) = q.x;
    b(2 * k + 1) = q.y;
  }
  cv::Matx<double, 8, 1> h;
  cv::solve(a, b, h, cv::DECOMP_SVD);
  const cv::Matx33d viewToUnit(h(0), h(1), h(2), h(3), h(4), h(5), h(6), h(7), 1);
  const cv::Matx33d m = unitToValue * viewToUnit;
  std::array<double, 9> out;
  for (int i = 0; i < 9; ++i) out[static_cast<std::size_t>(i)] = m.val[i];
  return out;
}

/// 1 if everything agrees; falls with labels that do not fit, few labels, a large residual.
double confidenceOf(const AxisFit& fit) {
  const auto& p = fit.progression;
  int read = 0;
  for (const auto& w : fit.words) read += !numberReadings(w.utf8).empty();
  const double agree = read > 0 ? static_cast<double>(p.labels) / read : 0;
  const double many = p.labels >= 4 ? 1.0 : p.labels == 3 ? 0.9 : 0.5;
  const double sharp = p.fromTicks ? std::clamp(1.15 - 0.25 * p.residual_px, 0.3, 1.0) : 0.6;
  return std::clamp(std::sqrt(agree), 0.0, 1.0) * many * sharp;
}

/// One unit by default may be right; with none, the numbers could be of anything.
double confidenceOfUnits(bool x, bool y) { return x && y ? 1.0 : x || y ? 0.7 : 0.28; }

}  // namespace

Result<AxesFound> readAxes(const PageView& view, const PlotFrame& frame, const AxisHints& hints,
                           const Progress&) {
  Reading r{view, frame, frame.box(), {}, TextReader(view), {}, {}};
  r.glyphs = glyphBoxes(withoutFrameInk(inkOf(darknessOf(view.raster)), r.box, positions(frame.xLines),
                                        positions(frame.yLines)),
                        1, largestGlyph(r.box));
  const auto xFit = readAxis(r, true);
  const auto yFit = readAxis(r, false);
  const bool xGiven = hints.xMin && hints.xMax, yGiven = hints.yMin && hints.yMax;
  if (!xFit && !xGiven) return noNumbers("x");
  if (!yFit && !yGiven) return noNumbers("y");

  AxesFound found;
  auto& cal = found.calibration.value;
  const AxisFit none{};
  const auto xTitle = readXTitle(r, xFit ? *xFit : none);
  const auto yTitle = readYTitle(r, yFit ? *yFit : none);
  const auto& c = frame.corners;
  EndValues x = xFit ? endValues(xFit->progression, c[3].x, c[2].x) : EndValues{};
  EndValues y = yFit ? endValues(yFit->progression, c[0].y, c[3].y) : EndValues{};
  if (xGiven) x = {*hints.xMin, *hints.xMax};
  if (yGiven) y = {*hints.yMax, *hints.yMin};

  const auto xUnit = hints.xUnit ? *hints.xUnit : xTitle.unit ? xTitle.unit->unit : LengthUnit::millimetre;
  const bool small = std::max(std::abs(y.atStart), std::abs(y.atEnd)) <= newtonAtMost;
  const auto yUnit = hints.yUnit   ? *hints.yUnit
                     : yTitle.unit ? yTitle.unit->unit
                     : small       ? ForceUnit::newton
                                   : ForceUnit::gramForce;
  cal.x.unit = symbolOf(xUnit);
  cal.y.unit = symbolOf(yUnit);
  cal.x.unitFound = xTitle.unit.has_value() || hints.xUnit;
  cal.y.unitFound = yTitle.unit.has_value() || hints.yUnit;
  if (hints.xUnit) cal.x.unitBy = DecidedBy::given;
  if (hints.yUnit) cal.y.unitBy = DecidedBy::given;
  if (!cal.x.unitFound)
    r.warnings.push_back("no unit found on the x axis: taken as mm; pass --x-unit if it is another");
  if (!cal.y.unitFound)
    r.warnings.push_back(std::string("no unit found on the y axis: taken as ") +
                         (small ? "N (it ends at 5 or below)" : "gf (it ends above 5)") +
                         "; pass --y-unit if it is another");
  cal.x.title = xTitle.title;
  cal.y.title = yTitle.title;
  if (xFit) {
    cal.x.ticks = tickLabels(*xFit);
    cal.x.residual_px = xFit->progression.residual_px;
  }
  if (yFit) {
    cal.y.ticks = tickLabels(*yFit);
    cal.y.residual_px = yFit->progression.residual_px;
  }
  cal.x.min = xGiven ? x.atStart : settled(x.atStart, xFit->progression);
  cal.x.max = xGiven ? x.atEnd : settled(x.atEnd, xFit->progression);
  cal.y.min = yGiven ? y.atEnd : settled(y.atEnd, yFit->progression);
  cal.y.max = yGiven ? y.atStart : settled(y.atStart, yFit->progression);
  const double mm = millimetresPer(xUnit), newton = newtonsPer(yUnit);
  cal.viewToUnits =
      homographyOf(frame, {x.atStart * mm, x.atEnd * mm}, {y.atStart * newton, y.atEnd * newton});

  const double sureX = xGiven ? 1 : confidenceOf(*xFit), sureY = yGiven ? 1 : confidenceOf(*yFit);
  found.calibration.confidence = sureX * sureY * confidenceOfUnits(cal.x.unitFound, cal.y.unitFound);
  found.calibration.evidence =
      (xFit ? std::to_string(xFit->progression.labels) + " of " + std::to_string(xFit->words.size())
            : "given") +
      " labels on x, " +
      (yFit ? std::to_string(yFit->progression.labels) + " of " + std::to_string(yFit->words.size())
            : "given") +
      " on y";
  for (const auto* fit : {xFit ? &*xFit : nullptr, yFit ? &*yFit : nullptr})
    if (fit)
      std::copy_if(fit->words.begin(), fit->words.end(), std::back_inserter(found.texts),
                   [](const SeenText& t) { return !t.utf8.empty(); });
  found.texts.insert(found.texts.end(), r.texts.begin(), r.texts.end());
  for (const auto& t : view.texts) found.texts.push_back({t.utf8, t.box, 1.0, t.angle_deg});
  found.warnings = std::move(r.warnings);
  return found;
}

}  // namespace detent::importer
