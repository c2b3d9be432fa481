// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sections.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "model/check.h"
#include "model/known_bottom_out.h"

namespace detent {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// ---- bottom-out

// A short straight part of the curve, for finding the start of the bottom-out.
struct Chord {
  double from_mm, to_mm, fromForce_N, toForce_N;
  bool isVertical() const { return from_mm == to_mm; }
  double slope() const {
    if (isVertical()) return toForce_N > fromForce_N ? infinity : toForce_N < fromForce_N ? -infinity : 0;
    return (toForce_N - fromForce_N) / (to_mm - from_mm);
  }
};

// Splits every piece into chords, enough to locate the start of the bottom-out within a piece.
std::vector<Chord> chordsOf(const StrokeCurve& curve) {
  const std::vector<Knot>& knots = curve.knots();
  const std::size_t perPiece = std::clamp<std::size_t>(2048 / knots.size(), 1, 64);
  std::vector<Chord> chords;
  chords.reserve(knots.size() * perPiece);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const Knot &a = knots[i], &b = knots[i + 1];
    if (a.displacement_mm == b.displacement_mm) {
      chords.push_back({a.displacement_mm, b.displacement_mm, a.force_N, b.force_N});
      continue;
    }
    double x = a.displacement_mm, force = a.force_N;
    for (std::size_t k = 1; k <= perPiece; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(perPiece);
      const double next_mm = k == perPiece
                                 ? b.displacement_mm
                                 : a.displacement_mm + share * (b.displacement_mm - a.displacement_mm);
      if (next_mm <= x) continue;
      const double nextForce = k == perPiece ? b.force_N : curve.force_N(next_mm);
      chords.push_back({x, next_mm, force, nextForce});
      x = next_mm;
      force = nextForce;
    }
  }
  return chords;
}

// Force range (max - min) up to the start of each chord.
std::vector<double> rangesBefore(const std::vector<Chord>& chords) {
  std::vector<double> ranges;
  ranges.reserve(chords.size());
  double low = chords.front().fromForce_N, high = low;
  for (const Chord& chord : chords) {
    low = std::min(low, chord.fromForce_N);
    high = std::max(high, chord.fromForce_N);
    ranges.push_back(high - low);
  }
  return ranges;
}

// Index of the first chord of the bottom-out, or chords.size() if there is none.
std::size_t firstBottomOutChord(const std::vector<Chord>& chords, const SectionSettings& settings) {
  const double start = chords.front().from_mm, end = chords.back().to_mm, travel = end - start;
  const double endForce = chords.back().toForce_N;
  const std::vector<double> ranges = rangesBefore(chords);
  std::size_t first = chords.size();
  // least slope of the chords from i on, without the last percent of travel, where meters round off
  double leastSlope = infinity;
  for (std::size_t i = chords.size(); i-- > 0;) {
    const Chord& chord = chords[i];
    if (chord.slope() <= 0 || chord.from_mm - start < 0.5 * travel) break;
    if (end - chord.from_mm > 0.01 * travel) leastSlope = std::min(leastSlope, chord.slope());
    const double bar = settings.bottomOutSlopeRatio * ranges[i] / (chord.from_mm - start);
    const double gain = endForce - chord.fromForce_N;
    const bool highEnough = gain > settings.minProminenceOfSpan * ranges[i];
    const bool steepOnAverage = gain > bar * (end - chord.from_mm);
    if (chord.slope() > bar && leastSlope > 0.5 * bar && highEnough && steepOnAverage) first = i;
  }
  return first;
}

// Displacement in the chord before the bottom-out where the slope exceeds the limit; the chord's end if it
// does not.
double startBefore(const StrokeCurve& curve, const Chord& before, const Chord& rise, double slopeRatio,
                   double range) {
  double low = before.from_mm, high = rise.from_mm;
  const double bar = slopeRatio * range / (rise.from_mm - curve.start_mm());
  if (before.isVertical() || curve.slopeBefore_N_per_mm(high) <= bar || curve.slope_N_per_mm(low) > bar)
    return high;
  for (int i = 0; i < 60 && low < high; ++i) {
    const double middle = low + 0.5 * (high - low);
    if (middle <= low || middle >= high) break;
    (curve.slope_N_per_mm(middle) > bar ? high : low) = middle;
  }
  return high;
}

// ---- tactile points

// A stroke in the order travelled; the sign turns a release's minima into maxima.
struct Travelled {
  std::vector<MonotoneStretch>
      stretches;  // in the order travelled, with ends exchanged for a release, and force times `sign`
  double sign;
};

Travelled travelled(const StrokeCurve& curve, Stroke stroke) {
  Travelled out{curve.monotoneStretches(), stroke == Stroke::press ? 1.0 : -1.0};
  if (stroke == Stroke::press) return out;
  std::reverse(out.stretches.begin(), out.stretches.end());
  for (MonotoneStretch& s : out.stretches) {
    std::swap(s.from_mm, s.to_mm);
    std::swap(s.fromForce_N, s.toForce_N);
    s.fromForce_N = -s.fromForce_N;
    s.toForce_N = -s.toForce_N;
    // Travelled backwards and with the sign changed, a rising stretch still rises.
  }
  return out;
}

// One turn of a travelled stroke: the force rises up to it and falls after it.
struct Turn {
  double displacement_mm;
  double height_N;  // signed force
  std::size_t lastRising, firstFalling;
};

std::vector<Turn> turnsOf(const std::vector<MonotoneStretch>& stretches) {
  std::vector<Turn> turns;
  for (std::size_t i = 0; i + 1 < stretches.size(); ++i) {
    if (stretches[i].direction != 1) continue;
    std::size_t next = i + 1;
    while (next < stretches.size() && stretches[next].direction == 0) ++next;
    if (next == stretches.size() || stretches[next].direction != -1) continue;
    const double from = stretches[i].to_mm, to = stretches[next].from_mm;
    turns.push_back({std::midpoint(from, to), stretches[i].toForce_N, i, next});
  }
  return turns;
}

// Depth of the valley on one side, until the force passes the turn's again or the stroke ends.
double dropAfter(const std::vector<MonotoneStretch>& stretches, const Turn& turn) {
  double low = turn.height_N;
  for (std::size_t i = turn.firstFalling; i < stretches.size() && stretches[i].toForce_N <= turn.height_N;
       ++i)
    low = std::min(low, stretches[i].toForce_N);
  return turn.height_N - low;
}

double dropBefore(const std::vector<MonotoneStretch>& stretches, const Turn& turn) {
  double low = turn.height_N;
  for (std::size_t i = turn.lastRising + 1; i-- > 0 && stretches[i].fromForce_N <= turn.height_N;)
    low = std::min(low, stretches[i].fromForce_N);
  return turn.height_N - low;
}

double prominenceBar(const StrokeCurve& curve, const BottomOut& bottomOut, const SectionSettings& settings) {
  double low = infinity, high = -infinity;
  for (const MonotoneStretch& s : curve.monotoneStretches()) {
    if (s.from_mm > bottomOut.displacement_mm) break;
    const bool reachesBottomOut = bottomOut.isSteep && s.to_mm >= bottomOut.displacement_mm;
    for (double force : {s.fromForce_N, reachesBottomOut ? bottomOut.force_N : s.toForce_N}) {
      low = std::min(low, force);
      high = std::max(high, force);
    }
    if (reachesBottomOut) break;
  }
  return std::max(settings.minProminence_N, settings.minProminenceOfSpan * std::max(0.0, high - low));
}

struct ProminentTurn {
  Turn turn;
  double prominence_N;
};

std::vector<ProminentTurn> prominentTurns(const StrokeCurve& curve, const Travelled& way,
                                          const BottomOut& bottomOut, const SectionSettings& settings) {
  const double bar = prominenceBar(curve, bottomOut, settings);
  std::vector<ProminentTurn> found;
  for (const Turn& turn : turnsOf(way.stretches)) {
    if (bottomOut.isSteep && turn.displacement_mm > bottomOut.displacement_mm) continue;
    const double prominence = std::min(dropBefore(way.stretches, turn), dropAfter(way.stretches, turn));
    if (prominence > 0 && prominence >= bar) found.push_back({turn, prominence});
  }
  return found;
}

// ---- sections

// Displacement where the force passes that of a turn again; nullopt if it never does.
std::optional<double> regainedAt(const StrokeCurve& curve, const Travelled& way, const Turn& turn) {
  for (std::size_t i = turn.firstFalling; i < way.stretches.size(); ++i) {
    MonotoneStretch s = way.stretches[i];
    if (s.direction != 1 || s.toForce_N < turn.height_N) continue;
    if (s.from_mm > s.to_mm) std::swap(s.from_mm, s.to_mm);
    if (way.sign < 0) {
      std::swap(s.fromForce_N, s.toForce_N);
      s.fromForce_N = -s.fromForce_N;
      s.toForce_N = -s.toForce_N;
    }
    return curve.displacementIn(s, way.sign * turn.height_N);
  }
  return {};
}

Section sectionBetween(SectionKind kind, double from_mm, double to_mm, double fromForce_N, double toForce_N) {
  return {kind, from_mm, to_mm, fromForce_N, toForce_N};
}

// Appends a slope section up to a place, unless its length is 0.
void appendSlope(std::vector<Section>& sections, double& at_mm, double& atForce, double to_mm,
                 double toForce) {
  if (to_mm == at_mm && toForce == atForce) return;
  sections.push_back(sectionBetween(SectionKind::slope, at_mm, to_mm, atForce, toForce));
  at_mm = to_mm;
  atForce = toForce;
}

void checkSettings(const SectionSettings& settings) {
  DETENT_CHECK(settings.minProminence_N >= 0, "minProminence_N >= 0");
  DETENT_CHECK(settings.minProminenceOfSpan >= 0 && settings.minProminenceOfSpan < 1,
               "minProminenceOfSpan in [0, 1)");
  DETENT_CHECK(settings.bottomOutSlopeRatio > 1, "bottomOutSlopeRatio > 1");
}

}  // namespace

BottomOut bottomOutOf(const StrokeCurve& curve, const SectionSettings& settings) {
  checkSettings(settings);
  const std::vector<Chord> chords = chordsOf(curve);
  const std::size_t first = firstBottomOutChord(chords, settings);
  if (first == chords.size()) return {curve.end_mm(), curve.knots().back().force_N, false};
  const Chord& rise = chords[first];
  if (first == 0) return {rise.from_mm, rise.fromForce_N, true};
  const double range = rangesBefore(chords)[first];
  const double bottomOutStart_mm =
      startBefore(curve, chords[first - 1], rise, settings.bottomOutSlopeRatio, range);
  return {bottomOutStart_mm,
          bottomOutStart_mm == rise.from_mm ? rise.fromForce_N : curve.force_N(bottomOutStart_mm), true};
}

std::vector<TactilePoint> tactilePoints(const StrokeCurve& curve, Stroke stroke,
                                        const SectionSettings& settings) {
  return tactilePoints(curve, stroke, bottomOutOf(curve, settings), settings);
}

std::vector<TactilePoint> tactilePoints(const StrokeCurve& curve, Stroke stroke, const BottomOut& bottomOut,
                                        const SectionSettings& settings) {
  const Travelled way = travelled(curve, stroke);
  std::vector<TactilePoint> points;
  for (const auto& [turn, prominence] : prominentTurns(curve, way, bottomOut, settings))
    points.push_back({turn.displacement_mm, way.sign * turn.height_N, prominence});
  return points;
}

std::vector<Section> sectionsOf(const StrokeCurve& curve, Stroke stroke, const SectionSettings& settings) {
  return sectionsOf(curve, stroke, bottomOutOf(curve, settings), settings);
}

std::vector<Section> sectionsOf(const StrokeCurve& curve, Stroke stroke, const BottomOut& bottomOut,
                                const SectionSettings& settings) {
  const Travelled way = travelled(curve, stroke);
  const bool press = stroke == Stroke::press;
  const Knot& first = press ? curve.knots().front() : curve.knots().back();
  const Knot& last = press ? curve.knots().back() : curve.knots().front();

  std::vector<Section> sections;
  double at_mm = first.displacement_mm, atForce = first.force_N;
  if (!press && bottomOut.isSteep) {
    sections.push_back(
        sectionBetween(SectionKind::bottomOut, at_mm, bottomOut.displacement_mm, atForce, bottomOut.force_N));
    at_mm = bottomOut.displacement_mm;
    atForce = bottomOut.force_N;
  }
  const double forward = press ? 1 : -1;
  for (const auto& [turn, prominence] : prominentTurns(curve, way, bottomOut, settings)) {
    if (forward * turn.displacement_mm < forward * at_mm) continue;  // inside the previous jump
    const double height = way.sign * turn.height_N;
    appendSlope(sections, at_mm, atForce, turn.displacement_mm, height);
    const auto regained = regainedAt(curve, way, turn);
    const double to_mm = regained ? *regained : last.displacement_mm;
    const double toForce = regained ? height : last.force_N;
    sections.push_back(sectionBetween(SectionKind::jump, turn.displacement_mm, to_mm, height, toForce));
    at_mm = to_mm;
    atForce = toForce;
  }
  if (press) {
    const bool startsAhead =
        bottomOut.isSteep && (bottomOut.displacement_mm > at_mm ||
                              (bottomOut.displacement_mm == at_mm && bottomOut.force_N >= atForce));
    if (startsAhead)
      appendSlope(sections, at_mm, atForce, bottomOut.displacement_mm, bottomOut.force_N);
    else if (!bottomOut.isSteep)
      appendSlope(sections, at_mm, atForce, last.displacement_mm, last.force_N);
    sections.push_back(
        sectionBetween(SectionKind::bottomOut, at_mm, last.displacement_mm, atForce, last.force_N));
  } else {
    appendSlope(sections, at_mm, atForce, last.displacement_mm, last.force_N);
  }
  return sections;
}

double jumpArea_mJ(const StrokeCurve& curve, const Section& jump) {
  DETENT_CHECK(jump.kind == SectionKind::jump, "a jump section");
  // A press curve lies below its tactile force; a release curve, travelled backwards, lies above it. Both
  // signs cancel.
  return std::max(0.0, -curve.areaAbove_mJ(jump.fromForce_N, jump.from_mm, jump.to_mm));
}

}  // namespace detent
