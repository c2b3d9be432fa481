// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/library/difference_rows.h"

#include <algorithm>
#include <cmath>
#include <QCoreApplication>

#include "editor/quantity/quantity.h"
#include "model/metrics.h"

namespace detent::editor {
namespace {

struct Differences {
  Q_DECLARE_TR_FUNCTIONS(Differences)
};

using Value = std::optional<double>;

/// Collects rows; those that neither button has are dropped.
class Rows {
 public:
  void add(const QString& name, Measure measure, Value a, Value b) {
    if (a || b) rows_.push_back({name, measure, a, b});
  }
  std::vector<DifferenceRow> take() { return std::move(rows_); }

 private:
  std::vector<DifferenceRow> rows_;
};

const TactileEvent* eventOf(const StrokeMetrics* stroke, std::size_t index) {
  return stroke && index < stroke->tactile.size() ? &stroke->tactile[index] : nullptr;
}

template <class Get>
Value of(const TactileEvent* event, Get get) {
  return event ? Value(get(*event)) : Value();
}

void addTactilePoint(Rows& rows, const QString& prefix, bool press, const TactileEvent* a,
                     const TactileEvent* b) {
  const auto both = [&](const QString& name, Measure measure, auto get) {
    rows.add(prefix + name, measure, of(a, get), of(b, get));
  };
  both(Differences::tr("displacement"), Measure::length,
       [](const TactileEvent& e) { return e.point.displacement_mm; });
  both(Differences::tr("force"), Measure::force, [](const TactileEvent& e) { return e.point.force_N; });
  const auto followingForce = [](const TactileEvent* e) {
    return e && e->following ? Value(e->following->force_N) : Value();
  };
  rows.add(prefix + (press ? Differences::tr("force of the valley after it")
                           : Differences::tr("force of the hump after it")),
           Measure::force, followingForce(a), followingForce(b));
  const auto snap = [](const TactileEvent* e) { return e ? e->snapRatio : Value(); };
  rows.add(prefix + Differences::tr("snap ratio"), Measure::share, snap(a), snap(b));
  const auto length = [](const TactileEvent* e) {
    return e && e->jump ? Value(std::abs(e->jump->to_mm - e->jump->from_mm)) : Value();
  };
  rows.add(prefix + Differences::tr("length of the jump"), Measure::length, length(a), length(b));
  const auto area = [](const TactileEvent* e) { return e && e->jump ? Value(e->jumpArea_mJ) : Value(); };
  rows.add(prefix + Differences::tr("area of the jump"), Measure::work, area(a), area(b));
}

// Mean slope up to the first tactile point, or to the bottom-out where there is none.
Value firstSlope(const StrokeMetrics* stroke) {
  if (!stroke || stroke->sections.empty()) return {};
  const Section& first = stroke->sections.front();
  const double length_mm = first.to_mm - first.from_mm;
  if (first.kind != SectionKind::slope || length_mm == 0) return {};
  return (first.toForce_N - first.fromForce_N) / length_mm;
}

void addStroke(Rows& rows, const QString& name, bool press, const StrokeMetrics* a, const StrokeMetrics* b) {
  const auto both = [&](const QString& figure, Measure measure, auto get) {
    rows.add(name + ": " + figure, measure, a ? Value(get(*a)) : Value(), b ? Value(get(*b)) : Value());
  };
  both(Differences::tr("force at the start of the travel"), Measure::force,
       [](const StrokeMetrics& s) { return s.startForce_N; });
  both(Differences::tr("largest force"), Measure::force, [](const StrokeMetrics& s) { return s.maxForce_N; });
  rows.add(name + ": " + Differences::tr("first slope"), Measure::slope, firstSlope(a), firstSlope(b));
  both(Differences::tr("tactile points"), Measure::count,
       [](const StrokeMetrics& s) { return static_cast<double>(s.tactile.size()); });
  const std::size_t count = std::max(a ? a->tactile.size() : 0, b ? b->tactile.size() : 0);
  for (std::size_t i = 0; i < count; ++i) {
    const QString number = count > 1 ? " " + QString::number(i + 1) : QString();
    addTactilePoint(rows, name + ": " + Differences::tr("tactile point%1, ").arg(number), press,
                    eventOf(a, i), eventOf(b, i));
  }
  if (press)
    both(Differences::tr("bottom-out begins at"), Measure::length,
         [](const StrokeMetrics& s) { return s.bottomOut.displacement_mm; });
  both(Differences::tr("work"), Measure::work, [](const StrokeMetrics& s) { return s.work_mJ; });
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
QString number(double value) {
  if (value == 0) return numberText(0);
  const int digits = std::clamp(3 - static_cast<int>(std::floor(std::log10(std::abs(value)))), 0, 4);
  return fixedText(value, digits);
}

const QString nothing = QStringLiteral("\u2013");

}  // namespace

std::vector<DifferenceRow> differencesOf(const ButtonState& a, const ButtonState& b) {
  const StateMetrics first = metricsOf(a), second = metricsOf(b);
  Rows rows;
  rows.add(Differences::tr("Travel"), Measure::length, first.travel_mm, second.travel_mm);
  rows.add(Differences::tr("Operating point"), Measure::length, place(first.operatingPoint),
           place(second.operatingPoint));
  rows.add(Differences::tr("Reset point"), Measure::length, place(first.resetPoint),
           place(second.resetPoint));
  addStroke(rows, Differences::tr("Press"), true, &first.press, &second.press);
  addStroke(rows, Differences::tr("Release"), false, first.release ? &*first.release : nullptr,
            second.release ? &*second.release : nullptr);
  rows.add(Differences::tr("Work lost between the strokes"), Measure::work, first.hysteresisArea_mJ,
           second.hysteresisArea_mJ);
  return rows.take();
}

QString shownValue(std::optional<double> value, Measure measure, const DisplayUnits& units) {
  if (!value) return nothing;
  if (measure == Measure::count) return numberText(static_cast<int>(*value));
  return number(inUnits(*value, measure, units));
}

QString shownDifference(const DifferenceRow& row, const DisplayUnits& units) {
  if (!row.a || !row.b) return nothing;
  const double difference = *row.b - *row.a;
  const QString shown = shownValue(std::abs(difference), row.measure, units);
  if (difference == 0) return shown;
  return (difference > 0 ? QStringLiteral("+") : QStringLiteral("\u2212")) + shown;
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
    return Differences::tr("%1: mean %2 % of A's range, largest %3 % (up to %4 %5, %6 %7)")
        .arg(name, number(stroke.meanOfSpan * 100), number(stroke.maxOfSpan * 100),
             number(units.lengthFrom(stroke.max_mm)), units.lengthSymbol(),
             number(units.forceFrom(stroke.max_N)), units.forceSymbol());
  };
  QStringList lines;
  if (distance.press) lines << line(Differences::tr("Press"), *distance.press);
  if (distance.release) lines << line(Differences::tr("Release"), *distance.release);
  return lines.join('\n');
}

}  // namespace detent::editor
