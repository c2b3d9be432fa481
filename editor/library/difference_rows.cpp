// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/library/difference_rows.h"

#include <algorithm>
#include <cmath>
#include <QCoreApplication>

#include "editor/quantity/quantity.h"
#include "model/key_figures.h"
#include "model/metrics.h"

namespace detent::editor {
namespace {

struct Differences {
  Q_DECLARE_TR_FUNCTIONS(Differences)
};

/// Named as in the panel of key figures, so that a figure has the same name everywhere.
QString nameOfFigure(KeyFigure figure) {
  return QCoreApplication::translate("detent", keyFigureNames()[static_cast<std::size_t>(figure)].term);
}

using Value = std::optional<double>;

/// Collects rows; those that no button has are dropped.
class Rows {
 public:
  /// `valueOf` gives the figure of one of `things`, or nothing.
  template <class Thing, class ValueOf>
  void add(const QString& name, Measure measure, const std::vector<Thing>& things, ValueOf valueOf) {
    std::vector<Value> values;
    for (const Thing& thing : things) values.push_back(valueOf(thing));
    const bool any = std::any_of(values.begin(), values.end(), [](const Value& v) { return v.has_value(); });
    if (any) rows_.push_back({name, measure, std::move(values)});
  }
  std::vector<DifferenceRow> take() { return std::move(rows_); }

 private:
  std::vector<DifferenceRow> rows_;
};

/// Null where a button has no such stroke.
using Strokes = std::vector<const StrokeMetrics*>;
/// Null where a stroke has no such tactile point.
using Events = std::vector<const TactileEvent*>;

/// A figure of a stroke or tactile point; empty if that is missing.
template <class Thing, class Get>
auto ifThere(Get get) {
  return [get](const Thing* thing) { return thing ? Value(get(*thing)) : Value(); };
}

// On the press a tactile point is a peak, on the release a valley.
void addTactilePoint(Rows& rows, const QString& prefix, bool press, const Events& events) {
  const auto add = [&](const QString& name, Measure measure, auto get) {
    rows.add(prefix + name, measure, events, ifThere<TactileEvent>(get));
  };
  add(press ? Differences::tr("peak travel") : Differences::tr("valley travel"), Measure::length,
      [](const TactileEvent& e) { return e.point.displacement_mm; });
  add(press ? Differences::tr("peak force") : Differences::tr("valley force"), Measure::force,
      [](const TactileEvent& e) { return e.point.force_N; });
  add(press ? Differences::tr("valley force") : Differences::tr("peak force"), Measure::force,
      [](const TactileEvent& e) { return e.following ? Value(e.following->force_N) : Value(); });
  add(Differences::tr("snap ratio"), Measure::share, [](const TactileEvent& e) { return e.snapRatio; });
  add(Differences::tr("jump length"), Measure::length, [](const TactileEvent& e) {
    return e.jump ? Value(std::abs(e.jump->to_mm - e.jump->from_mm)) : Value();
  });
  add(Differences::tr("jump energy"), Measure::work,
      [](const TactileEvent& e) { return e.jump ? Value(e.jumpArea_mJ) : Value(); });
}

// Mean slope up to the first tactile point, or to the bottom-out where there is none.
Value firstSlope(const StrokeMetrics& stroke) {
  if (stroke.sections.empty()) return {};
  const Section& first = stroke.sections.front();
  const double length_mm = first.to_mm - first.from_mm;
  if (first.kind != SectionKind::slope || length_mm == 0) return {};
  return (first.toForce_N - first.fromForce_N) / length_mm;
}

void addTactilePoints(Rows& rows, const QString& name, bool press, const Strokes& strokes) {
  std::size_t most = 0;
  for (const StrokeMetrics* stroke : strokes) most = std::max(most, stroke ? stroke->tactile.size() : 0);
  for (std::size_t i = 0; i < most; ++i) {
    Events events;
    for (const StrokeMetrics* stroke : strokes)
      events.push_back(stroke && i < stroke->tactile.size() ? &stroke->tactile[i] : nullptr);
    const QString number = most > 1 ? " " + QString::number(i + 1) : QString();
    addTactilePoint(rows, name + number + ": ", press, events);
  }
}

void addStroke(Rows& rows, const QString& name, bool press, const Strokes& strokes) {
  const auto add = [&](const QString& figure, Measure measure, auto get) {
    rows.add(name + ": " + figure, measure, strokes, ifThere<StrokeMetrics>(get));
  };
  const auto startForce = [](const StrokeMetrics& s) { return s.startForce_N; };
  if (press)
    rows.add(nameOfFigure(KeyFigure::initialForce), Measure::force, strokes,
             ifThere<StrokeMetrics>(startForce));
  else
    add(Differences::tr("force at rest"), Measure::force, startForce);
  // The release starts at the end force of the press, which is listed already.
  if (press)
    add(Differences::tr("largest force"), Measure::force,
        [](const StrokeMetrics& s) { return s.maxForce_N; });
  add(Differences::tr("initial slope"), Measure::slope, firstSlope);
  add(Differences::tr("tactile points"), Measure::count,
      [](const StrokeMetrics& s) { return static_cast<double>(s.tactile.size()); });
  addTactilePoints(rows, name, press, strokes);
  if (press)
    rows.add(nameOfFigure(KeyFigure::bottomOutTravel), Measure::length, strokes,
             ifThere<StrokeMetrics>([](const StrokeMetrics& s) { return s.bottomOut.displacement_mm; }));
  add(Differences::tr("work"), Measure::work, [](const StrokeMetrics& s) { return s.work_mJ; });
}

Value place(const std::optional<CurvePoint>& point) {
  return point ? Value(point->displacement_mm) : Value();
}

double inUnits(double value, Measure measure, const DisplayUnits& units) {
  switch (measure) {
    case Measure::length:
      return units.lengthFrom(value);
    case Measure::force:
      return units.forceFrom(value);
    case Measure::slope:
      return units.slopeFrom(value);
    case Measure::share:
      return value * 100;
    case Measure::work:
    case Measure::count:
      return value;
  }
  return value;
}

// Four significant digits, but no more decimals than a micrometre or a hundredth of a gram needs.
int decimalsOf(double value) {
  return value == 0 ? 0 : std::clamp(3 - static_cast<int>(std::floor(std::log10(std::abs(value)))), 0, 4);
}

QString number(double value) { return fixedText(value, decimalsOf(value)); }

const QString nothing = QStringLiteral("\u2013");

}  // namespace

std::vector<DifferenceRow> differencesOf(const std::vector<const ButtonState*>& states) {
  std::vector<StateMetrics> figures;
  for (const ButtonState* state : states) figures.push_back(metricsOf(*state));
  Strokes presses, releases;
  for (const StateMetrics& each : figures) {
    presses.push_back(&each.press);
    releases.push_back(each.release ? &*each.release : nullptr);
  }
  Rows rows;
  rows.add(nameOfFigure(KeyFigure::totalTravel), Measure::length, figures,
           [](const StateMetrics& s) { return Value(s.travel_mm); });
  rows.add(nameOfFigure(KeyFigure::preTravel), Measure::length, figures,
           [](const StateMetrics& s) { return place(s.operatingPoint); });
  rows.add(nameOfFigure(KeyFigure::resetTravel), Measure::length, figures,
           [](const StateMetrics& s) { return place(s.resetPoint); });
  addStroke(rows, Differences::tr("Press"), true, presses);
  addStroke(rows, Differences::tr("Release"), false, releases);
  rows.add(nameOfFigure(KeyFigure::hysteresis), Measure::work, figures,
           [](const StateMetrics& s) { return s.hysteresisArea_mJ; });
  return rows.take();
}

QString shownValue(std::optional<double> value, Measure measure, const DisplayUnits& units) {
  if (!value) return nothing;
  if (measure == Measure::count) return numberText(static_cast<int>(*value));
  return number(inUnits(*value, measure, units));
}

QString shownDifference(const DifferenceRow& row, std::size_t other, const DisplayUnits& units) {
  const Value &first = row.values.front(), &second = row.values[other];
  if (!first || !second) return nothing;
  const double difference = inUnits(*second - *first, row.measure, units);
  // As exact as the larger of the two values is shown.
  const double larger = inUnits(std::max(std::abs(*first), std::abs(*second)), row.measure, units);
  const int decimals = row.measure == Measure::count ? 0 : decimalsOf(larger);
  if (std::abs(difference) < 0.5 * std::pow(10, -decimals)) return numberText(0);
  return (difference > 0 ? QStringLiteral("+") : QStringLiteral("\u2212")) +
         fixedText(std::abs(difference), decimals);
}

QString shownUnit(Measure measure, const DisplayUnits& units) {
  switch (measure) {
    case Measure::length:
      return units.lengthSymbol();
    case Measure::force:
      return units.forceSymbol();
    case Measure::slope:
      return units.slopeSymbol();
    case Measure::work:
      return QStringLiteral("mJ");
    case Measure::share:
      return QStringLiteral("%");
    case Measure::count:
      return {};
  }
  return {};
}

QString shownDistance(const GraphDistance& distance, const DisplayUnits& units) {
  const auto line = [&](const QString& name, const StrokeDistance& stroke) {
    const QString most = number(stroke.maxOfSpan * 100);
    const QString before = number(stroke.maxBeforeBottomOutOfSpan * 100);
    const QString all =
        Differences::tr(
            "%1: the curves differ by %2 % of the first button's force range on average and by %3 % at "
            "most (up to %4 %5, %6 %7)")
            .arg(name, number(stroke.meanOfSpan * 100), most, number(units.lengthFrom(stroke.max_mm)),
                 units.lengthSymbol(), number(units.forceFrom(stroke.max_N)), units.forceSymbol());
    return before == most ? all
                          : Differences::tr("%1; before the bottom-out by %2 % at most").arg(all, before);
  };
  QStringList lines;
  if (distance.press) lines << line(Differences::tr("Press"), *distance.press);
  if (distance.release) lines << line(Differences::tr("Release"), *distance.release);
  return lines.join('\n');
}

}  // namespace detent::editor
