// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <iterator>
#include <numeric>

#include <opencv2/core.hpp>

#include "importer/axes/axis_calibration.h"
#include "importer/axes/axis_labels.h"
#include "importer/axes/axis_multiplier.h"
#include "importer/axes/axis_titles.h"
#include "importer/axes/button_sizes.h"
#include "importer/axes/graph_reading.h"
#include "importer/axes/label_units.h"
#include "importer/axes/printed_number.h"
#include "importer/axes/text_source.h"
#include "importer/axes/uneven_scale.h"
#include "importer/lexicon/printed_factor.h"
#include "importer/page/confidence_bar.h"
#include "model/text.h"

namespace detent::importer {
namespace {

constexpr double newtonAtMost =
    5;  // an unnamed force axis that ends at or below this is in newton: no button needs 5 gf

/// Values that the user gave for the ends of one axis.
struct AxisGiven {
  std::optional<double> min, max;
  bool range() const { return min && max; }
  bool any() const { return min || max; }
};

/// Values at the two ends of the frame along one axis: left/right, or top/bottom. Printed unit.
struct EndValues {
  double first = 0, last = 0;
};

RemedyKind rangeOf(Axis axis) { return axis == Axis::x ? RemedyKind::giveXAxis : RemedyKind::giveYAxis; }
RemedyKind unitOf(Axis axis) { return axis == Axis::x ? RemedyKind::giveXUnit : RemedyKind::giveYUnit; }
const char* nameOf(Axis axis) { return axis == Axis::x ? "x" : "y"; }
Message placeOf(Axis axis) { return Message("%1 axis", nameOf(axis)); }

Failure unread(const std::optional<AxisLabels>& labels, Axis axis, const std::vector<GridLine>& lines) {
  const std::string scale = isLogarithmic(lines) ? logarithmicScale
                            : labels             ? unevenScaleIn(*labels, axis)
                                                 : std::string();
  if (!scale.empty())
    return failureOf(otherQuantityOn(nameOf(axis), scale, unitOf(axis)), "plot frame", placeOf(axis));
  if (labels && labels->numbers() >= 2)
    return failureOf({DoubtCode::rangeUnreadable, {labels->numbers()}, rangeOf(axis)}, "plot frame",
                     placeOf(axis));
  return {FailureCode::noForceGraph, "plot frame", placeOf(axis),
          Message("no row of numbers was found along the axis"), rangeOf(axis)};
}

bool hasProgression(const std::optional<AxisLabels>& labels) { return labels && labels->progression; }

/// The labels of an axis, without a progression that arises by chance: of many numbers some two always fit a
/// scale.
std::optional<AxisLabels> credibleLabels(GraphReading& r, Axis axis) {
  auto labels = readAxisLabels(r, axis);
  if (hasProgression(labels) && labels->progression->labels == 2 && labels->numbers() > 4)
    labels->progression.reset();
  return labels;
}

/// Frames end at ticks, so a value within a pixel of a tick is rounded to it.
double settled(double value, const Progression& p) {
  const double nearest = std::round(value / p.substep) * p.substep;
  if (std::abs(p.position(nearest) - p.position(value)) > 1.2) return value;
  const double scale = std::pow(10.0, 9 - std::floor(std::log10(p.substep)));
  return std::round(nearest * scale) / scale + 0.0;  // no negative zero
}

std::vector<TickLabel> tickLabels(const AxisLabels& labels) {
  std::vector<TickLabel> out;
  const auto& p = *labels.progression;
  for (std::size_t i = 0; i < labels.words.size(); ++i) {
    if (labels.readings[i].empty()) continue;
    const int k = p.reading[i];
    TickLabel label;
    label.position_px = p.tickOf[i];
    label.value = labels.readings[i][k >= 0 ? static_cast<std::size_t>(k) : 0].value;
    label.text = labels.words[i].utf8;
    label.box = labels.words[i].box;
    label.used = label.agrees = k >= 0;
    out.push_back(std::move(label));
  }
  return out;
}

/// The power of ten between a printed value and the given one at the same place; 1 if none explains both.
double powerBetween(double printed, double given) {
  constexpr double rounding = 0.01;  // share of the given value
  if (!(printed * given > 0)) return 1;
  const double power = std::pow(10.0, std::round(std::log10(given / printed)));
  return std::abs(given - power * printed) <= rounding * std::abs(given) ? power : 1;
}

/// Values at the frame's ends: those given, else those of the labels. Beside a given end the other one is as
/// shown, at its tick, in the given one's power of ten: "1.250" may be printed for 1250 or for 1.25.
EndValues valuesAtEnds(const std::optional<AxisLabels>& labels, double first_px, double last_px,
                       std::optional<double> givenFirst, std::optional<double> givenLast) {
  EndValues v;
  if (hasProgression(labels)) v = {labels->progression->value(first_px), labels->progression->value(last_px)};
  if (hasProgression(labels) && givenFirst.has_value() != givenLast.has_value()) {
    v = {settled(v.first, *labels->progression), settled(v.last, *labels->progression)};
    const double power = givenFirst ? powerBetween(v.first, *givenFirst) : powerBetween(v.last, *givenLast);
    v = {power * v.first, power * v.last};
  }
  return {givenFirst.value_or(v.first), givenLast.value_or(v.last)};
}

/// Map from view pixels to values through the frame's four corners: affine for upright frames, projective for
/// tilted ones.
Homography homographyOf(const std::array<Point, 4>& corners, const EndValues& x, const EndValues& y) {
  const std::array<Point, 4> to{{{x.first, y.first}, {x.last, y.first}, {x.last, y.last}, {x.first, y.last}}};
  // Coordinates are scaled to about 1 so that rounding does not spoil the solution.
  const double size = std::max({std::abs(corners[2].x), std::abs(corners[2].y), 1.0});
  const double sx = std::max(std::abs(x.first), std::abs(x.last)),
               sy = std::max(std::abs(y.first), std::abs(y.last));
  cv::Matx<double, 8, 8> a = cv::Matx<double, 8, 8>::zeros();
  cv::Matx<double, 8, 1> b, h;
  for (int k = 0; k < 4; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double px = corners[i].x / size, py = corners[i].y / size, qx = to[i].x / sx, qy = to[i].y / sy;
    const std::array<double, 8> rowX{px, py, 1, 0, 0, 0, -qx * px, -qx * py},
        rowY{0, 0, 0, px, py, 1, -qy * px, -qy * py};
    for (int c = 0; c < 8; ++c) {
      a(2 * k, c) = rowX[static_cast<std::size_t>(c)];
      a(2 * k + 1, c) = rowY[static_cast<std::size_t>(c)];
    }
    b(2 * k) = qx;
    b(2 * k + 1) = qy;
  }
  cv::solve(a, b, h, cv::DECOMP_SVD);
  return {{sx * h(0) / size, sx * h(1) / size, sx * h(2), sy * h(3) / size, sy * h(4) / size, sy * h(5),
           h(6) / size, h(7) / size, 1}};
}

/// The value of the line nearest to a label, according to the labels that agree.
double lineValue(const Progression& p, double position_px) {
  return std::round(p.value(position_px) / p.substep) * p.substep + 0.0;
}

std::string shownNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

/// Returns true if a label is the rest of the expected number: "0" instead of 80. The engine lost a digit;
/// the page contradicts nothing.
bool isRestOf(const std::string& read, const std::string& expected) {
  const std::string digits = digitsOf(read);
  return !digits.empty() && digits.size() < digitsOf(expected).size() &&
         digitsOf(expected).find(digits) != std::string::npos;
}

/// Verdict on a readable label by the scale of the others.
enum class LabelVerdict {
  fits,  ///< at its value's line, or slightly beside it (the zero in the corner)
  rest,  ///< a part of the expected number, or a number of similar shape
  contradicts
};

LabelVerdict verdictOn(const AxisLabels& labels, std::size_t i) {
  const Progression& p = *labels.progression;
  if (p.reading[i] >= 0) return LabelVerdict::fits;
  const double expected = lineValue(p, p.tickOf[i]);
  for (const auto& reading : labels.readings[i])
    if (reading.weight >= 1 && std::abs(reading.value - expected) < 1e-6 * p.step) return LabelVerdict::fits;
  constexpr int many = 4;  // number of agreeing labels that outvote one possibly misread one
  const std::string shown = shownNumber(expected);
  constexpr double fully = 0.94;  // confidence of the engine from which a reading is no misreading
  const SeenText& word = labels.words[i];
  const bool isMisread = p.labels >= many && word.confidence < fully && resembles(word.utf8, shown);
  return isMisread || isRestOf(labels.words[i].utf8, shown) ? LabelVerdict::rest : LabelVerdict::contradicts;
}

/// Residual as for an axis of usual length: in an enlarged plot the same relative error is more pixels.
double residualAtUsualSize_px(double residual_px, double length_px) {
  constexpr double longestNeeded_px = 1500;
  return residual_px / std::max(1.0, length_px / longestNeeded_px);
}

/// Share of the scale's values between its outermost labels that are printed.
double printedShare(const AxisLabels& labels) {
  const Progression& p = *labels.progression;
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (std::size_t i = 0; i < p.reading.size(); ++i) {
    if (p.reading[i] < 0) continue;
    const double value = labels.readings[i][static_cast<std::size_t>(p.reading[i])].value;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return p.labels / ((high - low) / p.step + 1);
}

/// Plausibility of the agreeing labels' values: scales count in multiples of their step and usually begin
/// near zero. 48, 68 and 88 among other labels, or 6.1 to 6.3 alone, are digits misread in the same way.
double usualOf(const AxisLabels& labels, int readable) {
  constexpr double misreadAlike = 0.4, farFromZero = 5;  // plausibility; in spans of the labels
  const Progression& p = *labels.progression;
  double low = HUGE_VAL, high = -HUGE_VAL, offStep = 0;
  for (std::size_t i = 0; i < p.reading.size(); ++i) {
    if (p.reading[i] < 0) continue;
    const double value = labels.readings[i][static_cast<std::size_t>(p.reading[i])].value;
    low = std::min(low, std::abs(value)), high = std::max(high, std::abs(value));
    offStep = std::max(offStep, std::abs(value / p.step - std::round(value / p.step)));
  }
  const bool stray = offStep > 0.01 && p.labels < readable;
  return stray || low > farFromZero * (high - low) ? misreadAlike : 1;
}

/// Returns true if labels without ticks are a scale by themselves: a complete progression, each within a
/// fraction of a pixel of its place, with the axis at one of its steps.
bool isWholeRow(const Progression& p, double printed, double baseline_px) {
  constexpr int fewest = 4;
  constexpr double even_px = 0.75, onLine_px = 2;
  const double baseline = p.value(baseline_px), step = std::round(baseline / p.step) * p.step;
  return p.labels >= fewest && printed > 1 - 0.5 / p.labels && p.residual_px <= even_px &&
         std::abs(p.position(step) - baseline_px) <= onLine_px;
}

/// Confidence in an axis: 1 if all labels agree; less for labels that contradict or cannot be read, for few
/// labels, and for a large residual. `baseline_px`: where the axis begins.
double sureOf(const std::optional<AxisLabels>& labels, bool rangeGiven, double baseline_px,
              double length_px) {
  if (rangeGiven) return 1;
  const auto& p = *labels->progression;
  double agreed = 0, all = 0;
  int contradicting = 0, read = 0;
  for (std::size_t i = 0; i < labels->words.size(); ++i) {
    const bool readable = !labels->readings[i].empty();
    all += readable ? 1 : 0.25;
    if (!readable) continue;
    ++read;
    const LabelVerdict verdict = verdictOn(*labels, i);
    contradicting += verdict == LabelVerdict::contradicts && labels->words[i].confidence >= readWithCertainty;
    agreed += verdict == LabelVerdict::fits ? 1 : verdict == LabelVerdict::rest ? 0.5 : 0;
  }
  const double many = p.labels >= 4 ? 1.0 : p.labels == 3 ? 0.9 : 0.5;
  const double residual_px = residualAtUsualSize_px(p.residual_px, length_px);
  const double printed = printedShare(*labels);
  constexpr double ofRow = 0.85, ofSome = 0.6;  // factors of the confidence
  const double sharp = p.fromTicks                           ? std::clamp(1.15 - 0.25 * residual_px, 0.3, 1.0)
                       : isWholeRow(p, printed, baseline_px) ? ofRow
                                                             : ofSome;
  // One contradicting label that was read with certainty may be a misprint; two or more mean an uneven scale.
  constexpr double uneven = 0.4;
  const bool contradicted = contradicting >= 2 && 5 * contradicting >= p.labels;
  // 0, 102 and 1017 have a common step of 3: powers of ten, read as plain numbers, fit a line by chance.
  constexpr double leastPrinted = 0.1;
  const double even = contradicted || printed < leastPrinted ? uneven : 1;
  return std::sqrt(agreed / std::max(1.0, all)) * many * sharp * even * usualOf(*labels, read);
}

/// Returns true if the text beside the frame names displacement or force, though not their units.
bool namesForceOrTravel(const std::vector<SeenText>& texts) {
  return std::ranges::any_of(texts, [](const SeenText& text) {
    return namesQuantity(text.utf8, Quantity::force, sourceOf(text)) ||
           namesQuantity(text.utf8, Quantity::travel, sourceOf(text));
  });
}

constexpr double confidenceOfOther = 0.2;  // confidence of axes that measure something else

/// Confidence in the units: one assumed unit may be right. If both are assumed, the numbers may mean anything
/// unless words name the quantities.
double sureOfUnits(const AxisCalibration& found, const std::vector<SeenText>& texts) {
  if (!found.x.otherQuantity.empty() || !found.y.otherQuantity.empty()) return confidenceOfOther;
  if (found.x.unitFound && found.y.unitFound) return 1;
  if (found.x.unitFound || found.y.unitFound) return 0.7;
  return namesForceOrTravel(texts) ? 0.45 : 0.28;
}

EvidenceItem evidenceOf(Axis axis, const std::optional<AxisLabels>& labels, const AxisReading& reading,
                        bool rangeGiven) {
  if (!hasProgression(labels)) return {EvidenceCode::axisGiven, {nameOf(axis)}};
  if (rangeGiven)
    return {EvidenceCode::axisGivenAmongLabels,
            {nameOf(axis), std::ranges::count_if(reading.ticks, &TickLabel::agrees), labels->numbers()}};
  const auto& p = *labels->progression;
  return {EvidenceCode::labelsInProgression, {nameOf(axis), p.labels, labels->numbers(), p.ticks}};
}

void fillReading(AxisReading& reading, const std::optional<AxisLabels>& labels, bool rangeGiven) {
  if (!hasProgression(labels)) return;
  reading.ticks = tickLabels(*labels);
  reading.residual_px = labels->progression->residual_px;
  reading.thousandsUnclear = !rangeGiven && labels->thousands == ThousandsSign::possible;
}

/// Remarks on labels that were read with certainty and stand at another value's line. Some datasheets are
/// printed so; the grid counts.
void remarkContradictions(const std::optional<AxisLabels>& labels, Axis axis, std::vector<Remark>& remarks) {
  if (!hasProgression(labels)) return;
  const Progression& p = *labels->progression;
  for (std::size_t i = 0; i < labels->words.size(); ++i) {
    const SeenText& word = labels->words[i];
    const bool read = !labels->readings[i].empty() && word.confidence >= readWithCertainty;
    if (!read || verdictOn(*labels, i) != LabelVerdict::contradicts) continue;
    const double here = p.value(p.tickOf[i]), line = lineValue(p, p.tickOf[i]);
    const bool onLine = std::abs(here - line) < 0.2 * p.substep;
    remarks.push_back({RemarkCode::labelContradicts,
                       {word.utf8, nameOf(axis), shownNumber(onLine ? line : here)},
                       {{rangeOf(axis), "if the others are wrong"}}});
  }
}

/// The value at an end of the axis: rounded to the tick there unless one of its ends was given.
double endOf(double value, bool given, const std::optional<AxisLabels>& labels) {
  return given || !hasProgression(labels) ? value : settled(value, *labels->progression);
}

/// Boxes of the labels that agree with the scale.
std::vector<Box> agreedBoxes(const AxisLabels& labels) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < labels.words.size(); ++i)
    if (labels.progression && labels.progression->reading[i] >= 0) boxes.push_back(labels.words[i].box);
  return boxes;
}

Box joinedBox(const std::vector<Box>& boxes) {
  return std::accumulate(boxes.begin() + 1, boxes.end(), boxes.front(),
                         [](const Box& a, const Box& b) { return a.joined(b); });
}

LengthUnit xUnitOf(AxisReading& x, const AxisHints& hints, GraphReading& r,
                   const std::optional<AxisLabels>& labels, std::vector<Remark>& remarks) {
  x.unitFound = true;
  if (!hints.xUnit && labels && !labels->suffix.empty())
    if (const auto unit = lengthUnitIn(labels->suffix)) return unit->unit;
  const Box edge{r.box.x0, r.box.y1, r.box.x1, r.box.y1 + 1};
  const auto title = readXTitle(r, labels && !labels->words.empty() ? labels->extent : edge);
  x.title = title.text;
  x.factor = title.factor;
  x.factorUnread = title.factorUnread;
  x.otherQuantity = title.other;
  if (hints.xUnit) {
    x.unitBy = DecidedBy::given;
    return *hints.xUnit;
  }
  if (title.unit) return title.unit->unit;
  if (labels && title.other.empty()) {
    if (const auto unit = lengthUnitBehindNumbers(r, *labels)) return *unit;
    if (const auto unit = lengthUnitInPlaceOfNumber(r, *labels)) return *unit;
  }
  x.unitFound = false;
  remarks.push_back({RemarkCode::lengthUnitAssumed,
                     {"x", symbolOf(LengthUnit::millimetre)},
                     {{RemedyKind::giveXUnit, "if it is another"}}});
  return LengthUnit::millimetre;
}

ForceUnit yUnitOf(AxisReading& y, const AxisHints& hints, GraphReading& r,
                  const std::optional<AxisLabels>& labels, const EndValues& values,
                  std::vector<Remark>& remarks) {
  y.unitFound = true;
  if (!hints.yUnit && labels && !labels->suffix.empty())
    if (const auto unit = forceUnitIn(labels->suffix)) return unit->unit;
  const Box edge{r.box.x0 - 1, r.box.y0, r.box.x0, r.box.y1};
  const std::vector<Box> read = labels ? agreedBoxes(*labels) : std::vector<Box>{};
  r.setAside(read);
  const auto title = readYTitle(r, read.empty() ? edge : joinedBox(read));
  y.title = title.text;
  y.factor = title.factor;
  y.factorUnread = title.factorUnread;
  y.otherQuantity = title.other;
  if (hints.yUnit) {
    y.unitBy = DecidedBy::given;
    return *hints.yUnit;
  }
  if (title.unit) return title.unit->unit;
  if (labels && title.other.empty()) {
    if (const auto unit = forceUnitBehindNumbers(r, *labels)) return *unit;
    if (const auto unit = forceUnitInPlaceOfNumber(r, *labels)) return *unit;
  }
  y.unitFound = false;
  const bool newton = std::max(std::abs(values.first), std::abs(values.last)) <= newtonAtMost;
  remarks.push_back({newton ? RemarkCode::smallForcesTakenAsNewton : RemarkCode::largeForcesTakenAsGram,
                     {"y"},
                     {{RemedyKind::giveYUnit, "if it is another"}}});
  return newton ? ForceUnit::newton : ForceUnit::gramForce;
}

/// Returns true if one scale is the other in another unit of force: both have zero at the same position, and
/// their factor is a known one.
bool sameForces(const Progression& a, const Progression& b, double frameHeight_px) {
  constexpr double sameFactor = 0.015, samePlace = 0.02;  // relative difference; of the frame's height
  constexpr std::array units{ForceUnit::newton,       ForceUnit::centinewton, ForceUnit::gramForce,
                             ForceUnit::ounceForce,   ForceUnit::poundForce,  ForceUnit::millinewton,
                             ForceUnit::kilogramForce};
  if (std::abs(a.position(0) - b.position(0)) > samePlace * frameHeight_px) return false;
  const double factor = b.perPx / a.perPx;
  return std::any_of(units.begin(), units.end(), [&](ForceUnit from) {
    return std::any_of(units.begin(), units.end(), [&](ForceUnit to) {
      return std::abs(factor * newtonsPer(to) / newtonsPer(from) - 1) < sameFactor;
    });
  });
}

RightScale rightScaleBeside(GraphReading& r, const std::optional<AxisLabels>& left) {
  if (!hasProgression(left) || left->extent.x0 > r.box.x1) return RightScale::none;
  // If two scales share a frame, gridlines and ticks belong to the left one.
  const auto right = readRightLabels(r, {});
  if (!right || !reachesFar(*right, r.box)) return RightScale::none;
  if (right->progression && sameForces(*left->progression, *right->progression, r.box.height()))
    return RightScale::none;
  return readRightTitle(r, right->extent).unit ? RightScale::otherForces : RightScale::other;
}

std::vector<SeenText> allTexts(const GraphReading& r, const std::optional<AxisLabels>& x,
                               const std::optional<AxisLabels>& y) {
  std::vector<SeenText> texts;
  for (const auto* labels : {&x, &y})
    if (*labels)
      std::copy_if((*labels)->words.begin(), (*labels)->words.end(), std::back_inserter(texts),
                   [](const SeenText& t) { return !t.utf8.empty(); });
  texts.insert(texts.end(), r.texts.begin(), r.texts.end());
  for (const auto& t : r.view.texts) texts.push_back({t.utf8, t.box, 1.0, t.angle_deg});
  return texts;
}

/// The used labels of an axis, mapped to another view; the frame's edge if there are none.
Box labelsIn(const AxisReading& axis, const Homography& toView, const Box& edge, GraphReading& r) {
  std::vector<Box> boxes;
  for (const TickLabel& tick : axis.ticks)
    if (tick.used && !tick.box.empty()) boxes.push_back(toView.boxOf(tick.box));
  r.setAside(boxes);
  return boxes.empty() ? edge : joinedBox(boxes);
}

void forget(std::vector<Remark>& remarks, std::initializer_list<RemarkCode> codes) {
  std::erase_if(remarks, [&](const Remark& remark) {
    return std::find(codes.begin(), codes.end(), remark.code) != codes.end();
  });
}

/// Multiplies one coordinate of the map by a factor.
void scaleRow(Homography& map, std::size_t row, double factor) {
  for (std::size_t k = 3 * row; k < 3 * row + 3; ++k) map.m[k] *= factor;
}

/// Replaces the assumed unit by the found one and converts the scale.
void takeUnit(AxesFound& axes, LengthUnit unit) {
  AxisCalibration& cal = axes.calibration.value;
  scaleRow(cal.viewToUnits, 0, millimetresPer(unit) / millimetresPer(*lengthUnitFrom(cal.x.unit)));
  cal.x.unit = symbolOf(unit);
  cal.x.unitFound = true;
  forget(axes.remarks, {RemarkCode::lengthUnitAssumed});
}

void takeUnit(AxesFound& axes, ForceUnit unit) {
  AxisCalibration& cal = axes.calibration.value;
  scaleRow(cal.viewToUnits, 1, newtonsPer(unit) / newtonsPer(*forceUnitFrom(cal.y.unit)));
  cal.y.unit = symbolOf(unit);
  cal.y.unitFound = true;
  forget(axes.remarks, {RemarkCode::smallForcesTakenAsNewton, RemarkCode::largeForcesTakenAsGram});
}

/// Returns true if the axis' own title or numbers contain its unit, even an unreadable one; a heading's unit
/// does not apply then. `heading`: it may itself have been taken for the title.
bool saysItsUnit(const AxisReading& axis, const std::string& heading) {
  const auto unit = axis.title.find_first_of("([/,%");
  const auto isBare = [](const TickLabel& tick) {
    return !tick.used || printedNumber(tick.text).has_value();
  };
  return !axis.otherQuantity.empty() || !std::ranges::all_of(axis.ticks, isBare) ||
         (unit != std::string::npos && !heading.starts_with(axis.title.substr(0, unit)));
}

/// Takes the units of a heading above the plot for axes without a unit, unless an axis contradicts them. The
/// import reports this as a doubt.
void takeHeadingUnits(AxesFound& axes, GraphReading& r) {
  constexpr std::size_t fewLines = 4;
  AxisCalibration& cal = axes.calibration.value;
  if (cal.x.unitFound && cal.y.unitFound) return;
  const Box& b = r.box;
  const Box over{b.x0 - 0.2 * b.width(), b.y0 - 0.6 * b.height(), b.x1 + 0.2 * b.width(), b.y0 - 1};
  std::vector<SeenText> lines = r.ownTexts(over);
  if (lines.empty()) lines = r.readLines(over, 0, {0.5 * (b.x0 + b.x1), b.y0}, fewLines);
  for (const SeenText& line : lines) {
    const auto units = headingUnitsIn(line.utf8, sourceOf(line));
    if (!units) continue;
    if (saysItsUnit(cal.x, line.utf8) || saysItsUnit(cal.y, line.utf8)) return;
    if (cal.x.unitFound && lengthUnitFrom(cal.x.unit) != units->length) return;
    if (cal.y.unitFound && forceUnitFrom(cal.y.unit) != units->force) return;
    const double before = sureOfUnits(cal, axes.texts);
    if (!cal.x.unitFound) takeUnit(axes, units->length);
    if (!cal.y.unitFound) takeUnit(axes, units->force);
    axes.calibration.confidence *= sureOfUnits(cal, axes.texts) / before;
    axes.calibration.evidence.push_back({EvidenceCode::unitsOfHeading, {line.utf8}});
    return;
  }
}

/// Largest value of an axis of a button, mm or N.
struct AxisReach {
  double least = 0, most = 0;
};
constexpr double axisBeyondCurve = 2;  // axes are at most this many times as long as their curves
constexpr AxisReach travels_mm{leastTravel_mm, axisBeyondCurve*mostTravel_mm},
    forces_N{leastForce_N, axisBeyondCurve*mostForce_N};

/// Multiplies the values of the tick labels.
void multiply(AxisReading& axis, double factor) {
  const auto times = [factor](double value) { return value * factor + 0.0; };  // no negative zero
  axis.min = times(axis.min), axis.max = times(axis.max);
  for (TickLabel& tick : axis.ticks) tick.value = times(tick.value);
}

/// Multiplies the tick labels of an axis by a factor, and the scale with them.
void multiply(AxisCalibration& cal, Axis axis, double factor) {
  multiply(axis == Axis::x ? cal.x : cal.y, factor);
  scaleRow(cal.viewToUnits, axis == Axis::x ? 0 : 1, factor);
}

/// Multiplies an axis by the factor that its title prints.
void takeFactor(AxisCalibration& cal, Axis axis) {
  AxisReading& reading = axis == Axis::x ? cal.x : cal.y;
  multiply(cal, axis, reading.factor);
  reading.multiplied = true;
}

/// Takes the title of an axis that was found later, with the factor that it prints unless ends were given.
template <class Unit>
void takeTitle(AxisCalibration& cal, Axis axis, const AxisTitle<Unit>& title, const AxisGiven& given) {
  AxisReading& reading = axis == Axis::x ? cal.x : cal.y;
  reading.title = title.text;
  reading.factor = title.factor;
  reading.factorUnread = title.factorUnread;
  reading.otherQuantity.clear();
  if (!given.any()) takeFactor(cal, axis);
}

/// Box of an axis' labels; without labels its edge of the frame.
Box extentOf(const std::optional<AxisLabels>& labels, const Box& edge) {
  return labels && !labels->words.empty() ? labels->extent : edge;
}

/// Applies the powers of ten at the ends of the axes and in their titles where no ends were given. One that
/// stands at the end as well is the same one, and settled.
void applyMultipliers(AxisCalibration& cal, GraphReading& r, const std::optional<AxisLabels>& x,
                      const std::optional<AxisLabels>& y, const AxisHints& hints) {
  const Box& b = r.box;
  const auto apply = [&](AxisReading& reading, Axis axis, const Box& labels) {
    const double atEnd = multiplierAtEnd(r, axis, labels);
    if (atEnd != 1) reading.factor = 1, reading.factorUnread = false;
    multiply(cal, axis, atEnd);
    takeFactor(cal, axis);
  };
  if (!hints.xMin && !hints.xMax) apply(cal.x, Axis::x, extentOf(x, {b.x0, b.y1, b.x1, b.y1 + 1}));
  if (!hints.yMin && !hints.yMax) apply(cal.y, Axis::y, extentOf(y, {b.x0 - 1, b.y0, b.x0, b.y1}));
}

/// Factor for the tick labels where "1,000" may mean a thousand or three decimals: 1 or 1000 if only one of
/// them gives the size of a button. Otherwise it stays unclear.
double settleThousands(AxisReading& axis, double perUnit, const AxisReach& reach) {
  if (!axis.thousandsUnclear || !axis.unitFound) return 1;
  const double asDecimals = std::max(std::abs(axis.min), std::abs(axis.max)) * perUnit,
               asThousands = 1000 * asDecimals;
  const auto likely = [&](double end) { return end >= reach.least && end <= reach.most; };
  if (likely(asDecimals) == likely(asThousands)) return 1;
  axis.thousandsUnclear = false;
  if (likely(asDecimals)) return 1;
  multiply(axis, 1000);
  return 1000;
}

/// Returns true if an axis counts on below zero, but for a margin: its numbers are sizes with a minus sign.
bool countsBelowZero(const AxisReading& axis) {
  constexpr double margin = 0.1;  // share of the axis below zero
  const auto [low, high] = std::minmax(axis.min, axis.max);
  return low < 0 && high <= -margin * low;
}

/// Returns true if both ends have the same value, up to rounding: a given end beside a found one.
bool isEmptyRange(const EndValues& ends) {
  constexpr double rounding = 1e-3;  // share of the larger end
  return std::abs(ends.last - ends.first) <= rounding * std::max(std::abs(ends.first), std::abs(ends.last));
}

/// The scale through the ends of an axis of which at least one was given.
struct GivenScale {
  Axis axis = Axis::x;
  double first_px = 0, last_px = 0;
  EndValues ends;
  double value(double position_px) const {
    return std::lerp(ends.first, ends.last, (position_px - first_px) / (last_px - first_px));
  }
  bool isUneven(const AxisLabels& labels) const {
    return isUnevenBetween(labels, {first_px, ends.first}, {last_px, ends.last});
  }
};

/// Marks the labels that agree with the given scale if their numbers are multiplied by `factor`; returns how
/// many do. The frame's end and the label's tick may each be off as far as ticks among themselves.
std::ptrdiff_t markAgreeing(AxisReading& reading, const GivenScale& given, const Progression& p,
                            double factor) {
  const double tolerance = 2 * p.agree_px * std::abs(factor * p.perPx);
  for (TickLabel& tick : reading.ticks) {
    const double off = std::abs(given.value(tick.position_px) - factor * p.value(tick.position_px));
    tick.agrees = tick.used && off <= tolerance;
  }
  return std::ranges::count_if(reading.ticks, &TickLabel::agrees);
}

/// Value of the unit that the page prints in the unit of the reading; 1 if the page prints none.
double printedPerGiven(const AxisReading& reading, const AxisLabels& labels, Axis axis) {
  const auto factor = printedFactorIn(reading.title);
  for (const std::string& text : {labels.suffix, factor ? factor->title : reading.title}) {
    if (axis == Axis::x)
      if (const auto unit = lengthUnitIn(text))
        return millimetresPer(unit->unit) / millimetresPer(*lengthUnitFrom(reading.unit));
    if (axis == Axis::y)
      if (const auto unit = forceUnitIn(text))
        return newtonsPer(unit->unit) / newtonsPer(*forceUnitFrom(reading.unit));
  }
  return 1;
}

/// Compares ends that were given with the labels that agree with one another. Labels may be printed in
/// another unit, in thousands or with a power of ten at the end of the axis. Ends that are the very numbers
/// printed there are multiplied like them by the factor in the title.
void compareWithLabels(AxisCalibration& cal, const GivenScale& given, GraphReading& r,
                       const std::optional<AxisLabels>& labels) {
  if (!hasProgression(labels)) return;
  AxisReading& reading = given.axis == Axis::x ? cal.x : cal.y;
  const Progression& p = *labels->progression;
  const auto all = std::ranges::count_if(reading.ticks, &TickLabel::used);
  double factor = 1;
  std::ptrdiff_t most = markAgreeing(reading, given, p, factor);
  const auto trial = [&](double other) {
    if (most == all || other == 1) return;
    const std::ptrdiff_t agreeing = markAgreeing(reading, given, p, other);
    if (agreeing > most) most = agreeing, factor = other;
  };
  trial(printedPerGiven(reading, *labels, given.axis));
  if (labels->thousands == ThousandsSign::possible) trial(1000);
  trial(reading.factor);
  trial(-1);  // sizes, beside numbers with a minus sign
  if (most < all) trial(multiplierAtEnd(r, given.axis, labels->extent));
  const double known = factor;
  if (reading.factorUnread)
    for (int power = -6; power <= 6; ++power) trial(std::pow(10.0, power));
  markAgreeing(reading, given, p, factor);
  reading.repeated = most == all;
  if (factor == 1 && reading.repeated) takeFactor(cal, given.axis);
  if (factor == reading.factor) reading.factor = 1;
  if (!reading.repeated || factor != known) reading.factorUnread = false;
  if (reading.repeated) return;
  for (const TickLabel& tick : reading.ticks)
    if (tick.used && !tick.agrees) reading.contradicting.push_back(shownNumber(tick.value));
  const bool isX = given.axis == Axis::x;
  reading.contradictedBy =
      sureOf(labels, false, isX ? given.first_px : given.last_px, isX ? r.box.width() : r.box.height());
}

}  // namespace

void readMissingUnits(AxesFound& axes, const PageView& widerView, const PlotFrame& frame,
                      const Homography& toWide, const AxisHints& hints) {
  AxisCalibration& cal = axes.calibration.value;
  const double before = sureOfUnits(cal, axes.texts);
  GraphReading r(widerView, frame);
  const Box &b = r.box, below{b.x0, b.y1, b.x1, b.y1 + 1}, left{b.x0 - 1, b.y0, b.x0, b.y1};
  const Box xLabels = labelsIn(cal.x, toWide, below, r), yLabels = labelsIn(cal.y, toWide, left, r);
  if (!cal.x.unitFound)
    if (const auto title = readXTitle(r, xLabels); title.unit) {
      takeUnit(axes, title.unit->unit);
      takeTitle(cal, Axis::x, title, {hints.xMin, hints.xMax});
    }
  if (!cal.y.unitFound)
    if (const auto title = readYTitle(r, yLabels); title.unit) {
      takeUnit(axes, title.unit->unit);
      takeTitle(cal, Axis::y, title, {hints.yMin, hints.yMax});
    }
  axes.calibration.confidence *= sureOfUnits(cal, axes.texts) / before;
  takeHeadingUnits(axes, r);
}

void useNoTicksOfGivenRanges(AxisCalibration& calibration, const AxisHints& hints) {
  if (hints.xMin && hints.xMax)
    for (TickLabel& tick : calibration.x.ticks) tick.used = false;
  if (hints.yMin && hints.yMax)
    for (TickLabel& tick : calibration.y.ticks) tick.used = false;
}

Result<AxesFound> readAxes(const PageView& view, const PlotFrame& frame, const AxisHints& hints,
                           const Progress& progress) {
  const AxisGiven xGiven{hints.xMin, hints.xMax}, yGiven{hints.yMin, hints.yMax};
  GraphReading r(view, frame);
  // Labels are read even if a range was given: they show where the frame ends and what kind of scale it is.
  const auto xLabels = credibleLabels(r, Axis::x);
  if (!xGiven.range() && !hasProgression(xLabels)) return unread(xLabels, Axis::x, frame.xLines);
  const auto yLabels = credibleLabels(r, Axis::y);
  if (!yGiven.range() && !hasProgression(yLabels)) return unread(yLabels, Axis::y, frame.yLines);
  if (progress.isCancelled()) return Failure::cancelled();

  // Values belong to the intended position of an edge, not to the pixel it was rounded to.
  auto corners = frame.corners;
  for (auto& c : corners) c = {c.x - frame.drawnOffset_px.x, c.y - frame.drawnOffset_px.y};
  const EndValues x = valuesAtEnds(xLabels, corners[3].x, corners[2].x, xGiven.min, xGiven.max);
  const EndValues y = valuesAtEnds(yLabels, corners[0].y, corners[3].y, yGiven.max, yGiven.min);
  if (isEmptyRange(x) || isEmptyRange(y))
    return Failure{FailureCode::wrongUsage, "plot frame", placeOf(isEmptyRange(x) ? Axis::x : Axis::y),
                   Message("both ends of the axis have the same value"),
                   Message("Give two different values")};

  AxesFound found;
  auto& cal = found.calibration.value;
  const auto xUnit = xUnitOf(cal.x, hints, r, xLabels, found.remarks);
  const auto yUnit = yUnitOf(cal.y, hints, r, yLabels, y, found.remarks);
  // A unit given by hand settles which quantity one axis measures, but not whether the two axes are
  // exchanged.
  if (!areExchanged(cal)) {
    if (hints.xUnit) cal.x.otherQuantity.clear();
    if (hints.yUnit) cal.y.otherQuantity.clear();
  }
  cal.x.unit = symbolOf(xUnit);
  cal.y.unit = symbolOf(yUnit);
  fillReading(cal.x, xLabels, xGiven.range());
  fillReading(cal.y, yLabels, yGiven.range());
  cal.x.min = endOf(x.first, xGiven.any(), xLabels);
  cal.x.max = endOf(x.last, xGiven.any(), xLabels);
  cal.y.min = endOf(y.last, yGiven.any(), yLabels);
  cal.y.max = endOf(y.first, yGiven.any(), yLabels);
  const double mm = millimetresPer(xUnit), newton = newtonsPer(yUnit);
  cal.viewToUnits = homographyOf(corners, {x.first * mm, x.last * mm}, {y.first * newton, y.last * newton});
  applyMultipliers(cal, r, xLabels, yLabels, hints);
  scaleRow(cal.viewToUnits, 0, settleThousands(cal.x, mm, travels_mm));
  scaleRow(cal.viewToUnits, 1, settleThousands(cal.y, newton, forces_N));

  found.rightScale = rightScaleBeside(r, yLabels);
  found.texts = allTexts(r, xLabels, yLabels);
  const double xSure = sureOf(xLabels, xGiven.range(), corners[3].x, r.box.width()),
               ySure = sureOf(yLabels, yGiven.range(), corners[3].y, r.box.height());
  cal.x.sure = xSure, cal.y.sure = ySure;
  found.calibration.confidence = xSure * ySure * sureOfUnits(cal, found.texts);
  found.calibration.by = xGiven.range() && yGiven.range() ? DecidedBy::given : DecidedBy::found;
  const GivenScale xScale{Axis::x, corners[3].x, corners[2].x, x},
      yScale{Axis::y, corners[0].y, corners[3].y, y};
  if (xGiven.any()) compareWithLabels(cal, xScale, r, xLabels);
  if (yGiven.any()) compareWithLabels(cal, yScale, r, yLabels);
  found.calibration.evidence = {evidenceOf(Axis::x, xLabels, cal.x, xGiven.range()),
                                evidenceOf(Axis::y, yLabels, cal.y, yGiven.range())};
  for (const Axis axis : {Axis::x, Axis::y}) {
    const bool isX = axis == Axis::x, given = (isX ? xGiven : yGiven).range();
    const GivenScale& scaleOfEnds = isX ? xScale : yScale;
    const std::optional<AxisLabels>& labels = isX ? xLabels : yLabels;
    AxisReading& reading = isX ? cal.x : cal.y;
    // A given range does not make a nonlinear scale linear. Of such a scale some labels always fit a line.
    const bool labelsFit = !given && (isX ? xSure : ySure) >= confidenceBar;
    std::string scale = isLogarithmic(isX ? frame.xLines : frame.yLines) ? logarithmicScale
                        : !labels                                        ? std::string()
                        : labelsFit                                      ? unevenRowIn(*labels, axis)
                                                                         : unevenScaleIn(*labels, axis);
    if (scale.empty() && (isX ? xGiven : yGiven).any() && labels && scaleOfEnds.isUneven(*labels))
      scale = brokenScale;
    if (!scale.empty()) {
      reading.otherQuantity = scale;
      found.calibration.confidence *= confidenceOfOther;
    }
    if (given) continue;
    if (hasProgression(labels) && !labels->progression->fromTicks)
      found.remarks.push_back({RemarkCode::axisWithoutTicks, {nameOf(axis)}});
    remarkContradictions(labels, axis, found.remarks);
  }
  for (const Axis axis : {Axis::x, Axis::y}) {
    if (!countsBelowZero(axis == Axis::x ? cal.x : cal.y)) continue;
    multiply(cal, axis, -1);
    found.remarks.push_back({RemarkCode::signsLeftOut, {nameOf(axis)}});
  }
  takeHeadingUnits(found, r);
  return found;
}

}  // namespace detent::importer
