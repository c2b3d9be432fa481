// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/stroke_tracker.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace detent::playback {

namespace {

// Largest number of grains of one reading that are kept separately; beyond it neighbours are merged, with
// their number. 900 grains between two readings of 425 Hz are 382,500 per second: two per sample at 192 kHz.
constexpr std::int64_t maxGrainsPerReading = 900;

// A smaller number of grid cells is the rounding of a decimal fraction (0.3 mm * 20 per mm), not a distance.
constexpr double cellRounding = 1e-9;

double lerp(double a, double b, double t) { return a + (b - a) * t; }
double clamped(double v, double low, double high) { return v < low ? low : (v > high ? high : v); }

}  // namespace

/// A part of the movement in which time is linear in displacement.
struct StrokeTracker::Piece {
  double from_mm, to_mm;
  double fromFraction, toFraction;

  double fractionAt(double x_mm) const {
    const double span = to_mm - from_mm;
    return span == 0 ? toFraction : lerp(fromFraction, toFraction, clamped((x_mm - from_mm) / span, 0, 1));
  }
};

void StrokeTracker::use(const HapticProgram* program) {
  program_ = program;
  position_ = StrokePosition{};
  crossings_.count = 0;
  pressFired_.reset();
  releaseFired_.reset();
  bottomOutArmed_ = true;
  actuated_ = false;
  extreme_N_ = 0;
  if (program_ == nullptr) return;
  position_.displacement_mm = extreme_mm_ = restingPlace_mm();
}

void StrokeTracker::exchange(const HapticProgram* program) {
  const bool atTop = position_.displacement_mm == restingPlace_mm();
  program_ = program;
  const StateProgram& now = state();
  double x = atTop ? restingPlace_mm() : clamped(position_.displacement_mm, now.low_mm, now.end_mm);
  // No finger can stay within a jump, so the jump is still to be met.
  for (std::size_t i = 0; i < now.press.jumpCount; ++i) {
    const JumpEntry& jump = now.press.jumps[i];
    if (jump.from_mm < x && x < jump.to_mm) x = jump.from_mm;
  }
  position_.displacement_mm = x;
  extreme_mm_ = atTop ? x : clamped(extreme_mm_, now.low_mm, now.end_mm);
  for (std::size_t i = 0; i < now.press.jumpCount; ++i) pressFired_[i] = x > now.press.jumps[i].from_mm;
  for (std::size_t i = 0; i < now.release.jumpCount; ++i)
    releaseFired_[i] = x < now.release.jumps[i].rearm_mm;
  bottomOutArmed_ = x < now.bottomOut_mm;
}

std::int64_t StrokeTracker::grainCell(double displacement_mm) const {
  return static_cast<std::int64_t>(
      std::floor((displacement_mm - program_->gridOrigin_mm) * program_->grainsPerMm + cellRounding));
}

// A self-locking button stays down after an actuation; a press without actuation comes back up.
double StrokeTracker::releaseEnd_mm() const { return actuated_ ? state().rest_mm : state().start_mm; }

// A self-locking button rests where the press of its present state starts, a momentary one at the higher end
// of both strokes.
double StrokeTracker::restingPlace_mm() const {
  return program_->stateCount > 1 ? state().start_mm : state().low_mm;
}

double StrokeTracker::forceAt(double displacement_mm) const {
  const StrokeTable& t = table();
  std::size_t low = 0, high = t.pointCount - 1;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (t.points[middle].displacement_mm <= displacement_mm ? low : high) = middle;
  }
  const TablePoint &a = t.points[low], &b = t.points[high];
  if (displacement_mm >= b.displacement_mm) return b.force_N;
  if (displacement_mm <= a.displacement_mm) return a.force_N;
  return lerp(a.force_N, b.force_N,
              (displacement_mm - a.displacement_mm) / (b.displacement_mm - a.displacement_mm));
}

void StrokeTracker::begin() {
  crossings_.count = 0;
  grainStride_ = 1;
}

const Crossings& StrokeTracker::updateForce(double force_N) {
  assert(program_ != nullptr && std::isfinite(force_N));
  begin();
  const double before_N = position_.force_N;
  position_.force_N = force_N;
  const bool atRest = force_N <= program_->restForce_N;
  if (!position_.releasing) {
    if (force_N > extreme_N_) extreme_N_ = force_N;
    const bool turned = force_N < extreme_N_ - program_->hysteresis_N;
    const bool down = position_.displacement_mm > releaseEnd_mm();
    // without force nobody presses, even if the curve has no force there
    if (atRest && !down) return crossings_;
    if (turned || atRest) turn(true, force_N);
  } else {
    // Not below 0, because an offset of the sensor must not use up the hysteresis of the next press.
    if (force_N < extreme_N_) extreme_N_ = force_N > 0 ? force_N : 0;
    if (!atRest && force_N > extreme_N_ + program_->hysteresis_N) turn(false, force_N);
  }
  advanceByForce(before_N, force_N);
  finish();
  return crossings_;
}

const Crossings& StrokeTracker::updateDisplacement(double displacement_mm) {
  assert(program_ != nullptr && std::isfinite(displacement_mm));
  begin();
  const double x = clamped(displacement_mm, state().low_mm, state().end_mm);
  if (!position_.releasing) {
    if (x > extreme_mm_) extreme_mm_ = x;
    if (x < extreme_mm_ - program_->hysteresis_mm || (x <= releaseEnd_mm() && x < extreme_mm_)) {
      turn(true, position_.force_N);
      extreme_mm_ = x;
    }
  } else {
    if (x < extreme_mm_) extreme_mm_ = x;
    if (x > extreme_mm_ + program_->hysteresis_mm || (x >= state().end_mm && x > extreme_mm_)) {
      turn(false, position_.force_N);
      extreme_mm_ = x;
    }
  }
  advanceByDisplacement(x);
  position_.force_N = forceAt(position_.displacement_mm);
  finish();
  return crossings_;
}

void StrokeTracker::turn(bool releasing, double extreme_N) {
  position_.releasing = releasing;
  extreme_N_ = extreme_N;
}

// Both strokes follow one rule in the direction of travel: with s = +1 (press) or -1 (release), s*x
// increases, and the movement continues while s*curve <= s*force. The time of a crossing is when the force
// reached the highest s*curve so far.
void StrokeTracker::advanceByForce(double from_N, double to_N) {
  const StrokeTable& t = table();
  const auto count = static_cast<std::ptrdiff_t>(t.pointCount);
  const double s = position_.releasing ? -1 : 1;
  const auto at = [&](std::ptrdiff_t k) -> const TablePoint& {
    return t.points[static_cast<std::size_t>(s > 0 ? k : count - 1 - k)];
  };
  const double target = s * to_N, origin = s * from_N;
  const double limit_mm = position_.releasing ? releaseEnd_mm() : state().end_mm;
  const auto fractionOf = [&](double level) {
    return target > origin ? clamped((level - origin) / (target - origin), 0, 1) : 1.0;
  };

  // Starts at the first vertex at or beyond the position, with the curve's force at the position itself.
  double x = position_.displacement_mm;
  std::ptrdiff_t low = 0, high = count - 1;
  while (low < high) {
    const std::ptrdiff_t middle = (low + high) / 2;
    if (s * at(middle).displacement_mm >= s * x) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  std::ptrdiff_t next = low;
  double level = s * at(next).force_N;
  if (at(next).displacement_mm == x) {
    ++next;
  } else if (next > 0) {
    const TablePoint &a = at(next - 1), &b = at(next);
    level = s * lerp(a.force_N, b.force_N, (x - a.displacement_mm) / (b.displacement_mm - a.displacement_mm));
  }
  if (level > target || s * x >= s * limit_mm) return;
  boundGrainsUpTo(at(count - 1).displacement_mm);

  double highest = level > origin ? level : origin;
  for (; next < count; ++next) {
    const TablePoint& b = at(next);
    double levelB = s * b.force_N;
    double xB = b.displacement_mm;
    const bool last = s * xB >= s * limit_mm;
    if (s * xB > s * limit_mm) {
      levelB = lerp(level, levelB, (limit_mm - x) / (xB - x));
      xB = limit_mm;
    }
    // If the level exceeds the highest so far, time continues, so the piece is divided there.
    if (levelB > highest && level < highest && xB != x) {
      const double xSplit = lerp(x, xB, (highest - level) / (levelB - level));
      cross({x, xSplit, fractionOf(highest), fractionOf(highest)});
      x = xSplit;
      level = highest;
    }
    if (levelB > target) {
      const double share = levelB > level ? (target - level) / (levelB - level) : 0;
      const double xStop = lerp(x, xB, clamped(share, 0, 1));
      cross({x, xStop, fractionOf(highest), 1});
      position_.displacement_mm = xStop;
      return;
    }
    const double reached = levelB > highest ? levelB : highest;
    cross({x, xB, fractionOf(highest), fractionOf(reached)});
    x = xB;
    level = levelB;
    highest = reached;
    if (last) break;
  }
  position_.displacement_mm = x;
}

void StrokeTracker::advanceByDisplacement(double to_mm) {
  const double s = position_.releasing ? -1 : 1;
  if (s * to_mm <= s * position_.displacement_mm) return;
  boundGrainsUpTo(to_mm);
  // The first reading of a stroke may already have passed several jumps; time is then linear in displacement.
  cross({position_.displacement_mm, to_mm, 0, 1});
  position_.displacement_mm = to_mm;
}

// Adds everything that is met on a piece, in the order travelled. Jumps are met on leaving their start, other
// events on arriving.
void StrokeTracker::cross(const Piece& piece) {
  if (piece.from_mm == piece.to_mm) return;
  const double s = position_.releasing ? -1 : 1;
  const StrokeTable& t = table();
  Piece rest = piece;
  const auto cutAt = [&](double x_mm) {
    Piece head = rest;
    head.to_mm = x_mm;
    head.toFraction = piece.fractionAt(x_mm);
    crossGrains(head);
    rest.from_mm = x_mm;
    rest.fromFraction = head.toFraction;
  };
  struct Mark {
    double at_mm;
    CrossingKind kind;
    std::size_t jump;
  };
  std::array<Mark, maxJumps + 2> marks;
  std::size_t markCount = 0;
  const auto arrives = [&](double p) { return s * piece.from_mm < s * p && s * p <= s * piece.to_mm; };
  const auto leaves = [&](double p) { return s * piece.from_mm <= s * p && s * p < s * piece.to_mm; };
  const auto insert = [&](Mark mark) {
    std::size_t i = markCount++;
    for (; i > 0 && s * marks[i - 1].at_mm > s * mark.at_mm; --i) marks[i] = marks[i - 1];
    marks[i] = mark;
  };
  for (std::size_t i = 0; i < t.jumpCount; ++i) {
    if (!leaves(t.jumps[i].from_mm)) continue;
    insert(
        {t.jumps[i].from_mm, position_.releasing ? CrossingKind::releaseJump : CrossingKind::pressJump, i});
  }
  const StateProgram& now = state();
  if (!position_.releasing) {
    if (now.hasOperatingPoint && arrives(now.operating_mm)) {
      insert({now.operating_mm, CrossingKind::contactClosed, 0});
    }
    if (now.hasBottomOut && arrives(now.bottomOut_mm)) insert({now.bottomOut_mm, CrossingKind::bottomOut, 0});
  } else if (now.hasResetPoint && arrives(now.reset_mm)) {
    insert({now.reset_mm, CrossingKind::contactOpened, 0});
  }
  for (std::size_t i = 0; i < markCount; ++i) {
    cutAt(marks[i].at_mm);
    add(marks[i].kind, marks[i].jump, marks[i].at_mm, piece);
  }
  crossGrains(rest);
}

void StrokeTracker::crossGrains(const Piece& piece) {
  if (!(program_->grainsPerMm > 0) || piece.from_mm == piece.to_mm) return;
  const bool up = !position_.releasing;
  const std::int64_t first = grainCell(up ? piece.from_mm : piece.to_mm) + 1;
  const std::int64_t last = grainCell(up ? piece.to_mm : piece.from_mm);
  if (last < first) return;
  const StrokeTable& t = table();
  for (std::size_t i = 0; i < t.slopeCount; ++i) {
    const GrainRange& slope = t.slopes[up ? i : t.slopeCount - 1 - i];
    const std::int64_t a = slope.first > first ? slope.first : first;
    const std::int64_t b = slope.last < last ? slope.last : last;
    for (std::int64_t done = 0; done <= b - a;) {
      const std::int64_t merged = b - a + 1 - done < grainStride_ ? b - a + 1 - done : grainStride_;
      done += merged;
      addGrain(up ? a + done - 1 : b - done + 1, merged, slope.level, piece);
    }
  }
}

void StrokeTracker::boundGrainsUpTo(double farthest_mm) {
  if (!(program_->grainsPerMm > 0)) return;
  const std::int64_t cells = grainCell(farthest_mm) - grainCell(position_.displacement_mm);
  grainStride_ = (cells < 0 ? -cells : cells) / maxGrainsPerReading + 1;
}

void StrokeTracker::addGrain(std::int64_t index, std::int64_t merged, double level, const Piece& piece) {
  const double x = program_->gridOrigin_mm + static_cast<double>(index) / program_->grainsPerMm;
  if (crossings_.count >= Crossings::capacity - maxJumps - 4) {
    // Keeps room for jumps: the last grain found takes over the number of those dropped.
    for (std::size_t i = crossings_.count; i-- > 0;) {
      if (crossings_.items[i].kind != CrossingKind::grain) continue;
      crossings_.items[i].count += static_cast<std::uint32_t>(merged);
      return;
    }
  }
  if (crossings_.count >= Crossings::capacity) return;
  Crossing& c = crossings_.items[crossings_.count++];
  c = {CrossingKind::grain,
       0,
       position_.state,
       static_cast<std::uint32_t>(merged),
       piece.fractionAt(x),
       x,
       level};
}

void StrokeTracker::add(CrossingKind kind, std::size_t jump, double at_mm, const Piece& piece) {
  switch (kind) {
    case CrossingKind::pressJump:
    case CrossingKind::releaseJump: {
      auto& fired = kind == CrossingKind::pressJump ? pressFired_ : releaseFired_;
      if (fired[jump]) {
        ++suppressed_;
        return;
      }
      fired[jump] = true;
      break;
    }
    case CrossingKind::bottomOut:
      if (!bottomOutArmed_) {
        ++suppressed_;
        return;
      }
      bottomOutArmed_ = false;
      break;
    case CrossingKind::contactClosed:
      if (position_.contact) return;
      position_.contact = true;
      actuated_ = true;
      break;
    case CrossingKind::contactOpened:
      if (!position_.contact) return;
      position_.contact = false;
      break;
    case CrossingKind::grain:
      break;
  }
  if (crossings_.count >= Crossings::capacity) return;
  Crossing& c = crossings_.items[crossings_.count++];
  c = {kind, static_cast<std::uint16_t>(jump), position_.state, 1, piece.fractionAt(at_mm), at_mm};
}

void StrokeTracker::finish() {
  rearm();
  spreadTies();
  // Without an operating point, a press that has left its start counts as actuated.
  if (!position_.releasing && !state().hasOperatingPoint && position_.displacement_mm > state().start_mm)
    actuated_ = true;
  if (!position_.releasing || position_.displacement_mm > releaseEnd_mm()) return;
  position_.contact = false;
  if (!actuated_) return;
  actuated_ = false;
  if (program_->stateCount < 2) return;
  // Self-locking: the next press uses the other state's graph (Kim & Lee: "alternating ... at each
  // actuation").
  position_.state = static_cast<std::uint8_t>((position_.state + 1U) % program_->stateCount);
  position_.displacement_mm = extreme_mm_ = state().start_mm;
  pressFired_.reset();
  releaseFired_.reset();
  bottomOutArmed_ = true;
}

void StrokeTracker::rearm() {
  const StateProgram& now = state();
  const double x = position_.displacement_mm;
  if (pressFired_.any()) {
    for (std::size_t i = 0; i < now.press.jumpCount; ++i) {
      if (x <= now.press.jumps[i].rearm_mm) pressFired_[i] = false;
    }
  }
  if (releaseFired_.any()) {
    for (std::size_t i = 0; i < now.release.jumpCount; ++i) {
      if (x >= now.release.jumps[i].rearm_mm) releaseFired_[i] = false;
    }
  }
  if (!bottomOutArmed_ && x <= now.bottomOutRearm_mm) bottomOutArmed_ = true;
}

// Grains on a flat part are all met at one force, hence at one instant; they are spread over the time up to
// the next event.
void StrokeTracker::spreadTies() {
  for (std::size_t i = 0; i < crossings_.count;) {
    std::size_t end = i + 1;
    const double fraction = crossings_.items[i].fraction;
    while (end < crossings_.count && crossings_.items[end].fraction - fraction < cellRounding) ++end;
    const double until = end < crossings_.count ? crossings_.items[end].fraction : 1.0;
    std::size_t grains = 0;
    for (std::size_t k = i; k < end; ++k) grains += crossings_.items[k].kind == CrossingKind::grain ? 1 : 0;
    const auto size = static_cast<double>(end - i);
    for (std::size_t k = i + 1; grains > 1 && k < end; ++k) {
      crossings_.items[k].fraction = lerp(fraction, until, static_cast<double>(k - i) / size);
    }
    i = end;
  }
  // Rounding may have put a crossing a last bit before its predecessor.
  for (std::size_t i = 1; i < crossings_.count; ++i)
    crossings_.items[i].fraction = std::max(crossings_.items[i].fraction, crossings_.items[i - 1].fraction);
}

void StrokeTracker::toRest() {
  const std::uint8_t keptState = position_.state < program_->stateCount ? position_.state : std::uint8_t{0};
  position_ = StrokePosition{};
  position_.state = keptState;
  position_.displacement_mm = restingPlace_mm();
  pressFired_.reset();
  releaseFired_.reset();
  bottomOutArmed_ = true;
  actuated_ = false;
  extreme_N_ = 0;
}

void StrokeTracker::placeAtForce(double force_N) {
  if (program_ == nullptr) return;
  const std::uint64_t keptSuppressed = suppressed_;
  toRest();
  begin();
  if (force_N > program_->restForce_N) {
    extreme_N_ = force_N;
    advanceByForce(0, force_N);
  }
  position_.force_N = force_N;
  extreme_mm_ = position_.displacement_mm;
  rearm();
  suppressed_ = keptSuppressed;
  crossings_.count = 0;
}

void StrokeTracker::placeAtDisplacement(double displacement_mm) {
  if (program_ == nullptr) return;
  const std::uint64_t keptSuppressed = suppressed_;
  toRest();
  extreme_mm_ = position_.displacement_mm;
  updateDisplacement(displacement_mm);
  suppressed_ = keptSuppressed;
  crossings_.count = 0;
}

}  // namespace detent::playback
