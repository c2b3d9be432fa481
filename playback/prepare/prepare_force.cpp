// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/prepare/prepare_force.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>

#include "model/damping.h"
#include "model/number_table.h"
#include "model/sections.h"
#include "model/speed_family.h"
#include "playback/prepare/damping.h"
#include "playback/prepare/speed_change.h"

namespace detent::playback {

namespace {

constexpr double shortestTravel_mm = 0.1, longestTravel_mm = 100;
constexpr double slowest_Hz = 50, fastest_Hz = 20000;
// Below its rest a state holds the handle where a button's cap would stop, over a distance and with a force
// too small to startle.
constexpr double restraint_N = 0.5, restraint_mm = 3, restraintEnd_mm = 1;
// A state within this distance of its rest has come back.
constexpr double settle_mm = 0.05;
constexpr double widestPlayOfTravel = 0.25;
constexpr double noticedCrossing_N = 0.001;
// Share of a press's work by which graphs at several speeds may deviate because of measuring noise, as
// strokes may (validation.h).
constexpr double mostFedShare = 0.02;
// Share of the drawn force up to the operating point that must be felt. The position of a moving handle is
// predicted to the next step, so the felt slope is about the drawn one.
constexpr double risenShare = 0.96;
// The push before the first force: more than the friction of a preset (for a measured device, of that
// device), but too little to hurt.
constexpr double largestPush_N = 0.1, pushedFrictions = 1.5, followedSteps = 4;
// An encoder is watched under forces above this, and above this multiple of the friction.
constexpr double leastWatched_N = 0.25, watchedFrictions = 5;

Failure outOfRange(const Subject& value, Message place, Message problem, const Message& remedy) {
  return {FailureCode::wrongUsage, value, std::move(place), std::move(problem), remedy};
}

Result<Done> checkDevice(const ForceDeviceProfile& d, double rate_Hz) {
  const struct {
    Subject name;
    double value, least, most;
  } rules[] = {{"rate in Hz", rate_Hz, slowest_Hz, fastest_Hz},
               {"mass of the device in kg", d.mass_kg, 1e-4, 100},
               {"friction of the device in N", d.friction_N, 0, 100},
               {"damping of the device in N·s/mm", d.damping_Ns_per_mm, 0, 1},
               {"encoder step in mm", d.step_mm, 1e-6, 1},
               {"delay of the device in s", d.delay_s, 0, 0.1},
               {"motor lag of the device in s", d.lag_s, 0, 0.1},
               {"steepest slope in N/mm", d.largestSlope_N_per_mm, 1e-3, 1e4},
               {"force limit in N", d.limits.force_N, 1e-3, 1000},
               {"limit of force change in N/s", d.limits.slew_N_per_s, 1, 1e7},
               {"speed limit in mm/s", d.limits.speed_mm_per_s, 1, 1e5}};
  for (const auto& rule : rules) {
    if (rule.value >= rule.least && rule.value <= rule.most) continue;
    return outOfRange(rule.name, {}, Message("the value is %1", rule.value),
                      Message("Give a value from %1 to %2", rule.least, rule.most));
  }
  return Done{};
}

/// Force below the start of a stroke: pulls the handle to the start, and releases one that is far away.
double restrained_N(double start_N, double below_mm, double slope_N_per_mm) {
  const double held_N = std::max(-restraint_N, start_N - slope_N_per_mm * below_mm);
  const double let_mm = below_mm - std::max(0.0, start_N) / slope_N_per_mm - restraint_mm;
  return let_mm <= 0 ? held_N : held_N * std::max(0.0, 1 - let_mm / restraintEnd_mm);
}

/// Force of a curve within the device's limit; beyond its end, that of the end stop.
double forceOn(const StrokeCurve& curve, double at_mm, double slope_N_per_mm, double largest_N) {
  const double above_mm = std::max(0.0, at_mm - curve.end_mm());
  return std::clamp(curve.force_N(at_mm), -largest_N, largest_N) + slope_N_per_mm * above_mm;
}

/// The force at the start of a curve; for a vertical rise there, its lower end.
double startForce_N(const StrokeCurve& curve, double largest_N) {
  return std::clamp(curve.knots().front().force_N, -largest_N, largest_N);
}

/// A state's graphs by increasing speed, or its single one.
using Graphs = std::vector<const ForceGraph*>;

ForceCurveRow& curveRow(ForceStateTable& t, std::size_t speed, std::size_t row) {
  if (speed == 0) return t.rows[row];
  return t.faster[speed - 1][row];
}

/// Energy that graphs at several speeds would create together, with its place.
struct FedBySpeeds {
  double fed_mJ = 0, at_mm = 0, value = 0, limit = 0;
  std::size_t pressed = 0, released = 0;  ///< speeds of the worst combination

  void add(double each_mJ, double size, const FedBySpeeds& there) {
    const double sum_mJ = fed_mJ + each_mJ;
    if (size > std::abs(value)) *this = there;
    fed_mJ = sum_mJ;
  }
};

class ForcePreparation {
 public:
  ForcePreparation(const Button& button, const ForceDeviceProfile& device, const ForceSettings& settings)
      : button_(button), device_(device), settings_(settings) {}

  Result<PreparedForce> run() {
    ForceProgram& p = prepared_.program;
    p.period_s = 1 / settings_.rate_Hz.value_or(device_.rate_Hz);
    p.step_mm = device_.step_mm;
    p.velocity = settings_.velocity;
    p.limits = device_.limits;
    p.guide = device_.guide;
    p.passivityController = settings_.passivityController;
    p.law.holdLead_s = 0.5 * p.period_s + device_.late_s();
    p.law.settle_mm = std::max(settle_mm, 2 * device_.step_mm);
    p.stateCount = static_cast<std::uint32_t>(button_.states().size());
    if (p.stateCount > 1) p.law.catchDamping_Ns_per_mm = largestDamping_Ns_per_mm(device_, 1 / p.period_s);
    prepared_.summary.slopeLimit_N_per_mm = slope_ = device_.largestSlope_N_per_mm;
    for (std::size_t s = 0; s < p.stateCount; ++s) prepareState(s);
    if (refused_) return *std::move(refused_);
    setPlayRadius();
    setRest();
    setChecks();
    return std::move(prepared_);
  }

 private:
  /// Data of device and button by which the guard distinguishes a fault from a press.
  void setChecks() {
    ForceProgram& p = prepared_.program;
    p.limits.movedMass_kg = device_.mass_kg;
    p.limits.travelEnd_mm = 0;
    for (std::size_t s = 0; s < p.stateCount; ++s)
      p.limits.travelEnd_mm = std::max(p.limits.travelEnd_mm, placeOf(p.states[s], p.states[s].rowCount - 1));
    if (device_.watchesEncoder)
      p.limits.deadCountAbove_N = std::max(leastWatched_N, watchedFrictions * device_.friction_N);
    p.limits.deadCountFrom_mm = std::max(p.limits.deadCountFrom_mm, 2 * device_.step_mm);
    // A force limit below the push itself is harmless, so no proof is needed.
    p.proof.present = device_.provesDirection && p.limits.force_N > largestPush_N;
    if (device_.measured) p.proof.push_N = std::max(p.proof.push_N, pushedFrictions * device_.friction_N);
    p.proof.push_N = std::min(p.proof.push_N, p.limits.force_N);
    p.proof.way_mm = std::max(p.proof.way_mm, followedSteps * device_.step_mm);
  }

  /// With several speeds, only the worst displacement is reported.
  void remark(ForceRemarkKind kind, std::size_t state, double at_mm, double value, double limit) {
    std::vector<ForceRemark>& remarks = prepared_.summary.remarks;
    if (prepared_.program.states[state].speedCount > 1) {
      const auto same = std::ranges::find_if(
          remarks, [&](const ForceRemark& r) { return r.kind == kind && r.state == state; });
      if (same != remarks.end()) {
        if (std::abs(value) > std::abs(same->value)) *same = {kind, state, at_mm, value, limit};
        return;
      }
    }
    remarks.push_back({kind, state, at_mm, value, limit});
  }

  void prepareState(std::size_t s) {
    const ButtonState& from = button_.states()[s];
    ForceStateTable& to = prepared_.program.states[s];
    // The law of Shrestha's paper depends on speed only through v itself.
    const bool graphs = settings_.law == ForceLawKind::graph;
    const std::vector<double> speeds = graphs ? speedsOf(from) : std::vector<double>{};
    Graphs members{&from.graph};
    for (std::size_t k = 0; k < speeds.size(); ++k) {
      to.speeds_mm_per_s[k] = speeds[k];
      if (k == 0) members.clear();
      members.push_back(&graphAt(from, k));
    }
    to.speedCount = static_cast<std::uint32_t>(speeds.size());
    const auto releaseOf = [&](const ForceGraph& graph) -> const StrokeCurve& {
      return graphs ? graph.curve(Stroke::release) : graph.press();
    };
    setPlaces(members, to);
    for (std::size_t k = 0; k < members.size(); ++k)
      setStrokes(members[k]->press(), releaseOf(*members[k]), to, s, k);
    setDamping(from, to, s);
    const StrokeCurve& press = members.front()->press();
    if (button_.selfLocking())
      for (std::size_t k = 0; k < members.size(); ++k)
        fill(members[k]->press(), restOf(members[k]->press()), to, &ForceCurveRow::pending_N, k);
    if (members.size() > 1) limitSpeeds(members, from, to, s);
    if (button_.selfLocking()) {
      setStored([&](std::size_t i) { return to.rows[i].pending_N; }, &ForceRow::pendingStored_mJ, to);
      setActuation(from, press, releaseOf(*members.front()), to);
    }
    setStored([&](std::size_t i) { return strongestRelease_N(to, members.size(), i); }, &ForceRow::stored_mJ,
              to);
    prepared_.summary.travel_mm = std::max(prepared_.summary.travel_mm, from.graph.travel_mm());
    prepared_.summary.rowSpacing_mm = std::max(prepared_.summary.rowSpacing_mm, to.spacing_mm);
  }

  /// Largest force that a finger can get back at a displacement, at any speed.
  static float strongestRelease_N(ForceStateTable& t, std::size_t speeds, std::size_t row) {
    float most_N = t.rows[row].release_N;
    for (std::size_t k = 1; k < speeds; ++k) most_N = std::max(most_N, curveRow(t, k, row).release_N);
    return most_N;
  }

  /// Range in which graphs are compared, without vertical rises, where a tiny displacement is a large force.
  static std::pair<double, double> comparedOn(const Graphs& members) {
    double from_mm = 0, to_mm = longestTravel_mm;
    for (const ForceGraph* graph : members)
      for (const StrokeCurve* curve : {&graph->press(), &graph->curve(Stroke::release)}) {
        const BottomOut bottomOut = bottomOutOf(*curve);
        from_mm = std::max(from_mm, curve->start_mm());
        to_mm = std::min(
            {to_mm, curve->end_mm(), bottomOut.isSteep ? bottomOut.displacement_mm : curve->end_mm()});
      }
    return {from_mm, to_mm};
  }

  // Ensures that pressing at one speed and releasing at another takes energy: no release lies above a press
  // of any speed. A force that decreases with speed drives the handle no more than its damper absorbs, and
  // one that increases damps no more than its mass allows.
  // docs/develop/decisions/1111-graphs-at-several-speeds.md
  void limitSpeeds(const Graphs& members, const ButtonState& from, ForceStateTable& to, std::size_t s) {
    const SpeedDamping allowed = renderedSpeedDamping(from, device_, 1 / prepared_.program.period_s);
    const auto [from_mm, to_mm] = comparedOn(members);
    const std::size_t speeds = members.size();
    std::vector<FedBySpeeds> crossed(speeds), driven(speeds);
    FedBySpeeds damped;
    std::vector<double> work_mJ(speeds, 0);
    for (std::size_t i = 0; i < to.rowCount; ++i) {
      const double at_mm = placeOf(to, i);
      const bool counts = at_mm >= from_mm && at_mm <= to_mm;
      const double way_mm = counts ? to.spacing_mm : 0;
      if (!from.graph.release()) shareLeast(to, speeds, i);
      std::size_t released = 0;
      for (std::size_t k = 1; k < speeds; ++k)
        if (curveRow(to, k, i).release_N > curveRow(to, released, i).release_N) released = k;
      const float given_N = curveRow(to, released, i).release_N;
      for (std::size_t k = 0; k < speeds; ++k) {
        ForceCurveRow& row = curveRow(to, k, i);
        work_mJ[k] += way_mm * static_cast<double>(std::abs(row.press_N));
        const double above_N = static_cast<double>(given_N - row.press_N);
        if (above_N <= 0) continue;
        if (counts) crossed[k].add(way_mm * above_N, above_N, {0, at_mm, above_N, 0, k, released});
        row.press_N = given_N;
      }
      for (std::size_t k = 1; k < speeds; ++k) {
        const ForceCurveRow& slower = curveRow(to, k - 1, i);
        ForceCurveRow& row = curveRow(to, k, i);
        const double by = to.speeds_mm_per_s[k] - to.speeds_mm_per_s[k - 1];
        const auto limit = [&](float& force_N, float slower_N, double sign) {
          const double change = sign * static_cast<double>(force_N - slower_N) / by,
                       felt = std::clamp(change, allowed.least, allowed.most);
          if (felt == change) return;
          force_N = static_cast<float>(static_cast<double>(slower_N) + sign * felt * by);
          const double off_N = by * std::abs(change - felt);
          const FedBySpeeds there{0, at_mm, change, felt, k, k - 1};
          if (counts && off_N > noticedCrossing_N)
            (change < 0 ? driven[k] : damped).add(way_mm * off_N, std::abs(change), there);
        };
        limit(row.press_N, slower.press_N, 1);
        limit(row.release_N, slower.release_N, -1);
        limit(row.pending_N, slower.pending_N, 1);
      }
      for (std::size_t k = 0; k < speeds; ++k)
        to.hysteresis = to.hysteresis || curveRow(to, k, i).release_N < curveRow(to, k, i).press_N;
    }
    for (std::size_t k = 0; k < speeds; ++k) {
      refuseIfFed(crossed[k], driven[k], work_mJ[k], from, to);
      if (crossed[k].value > noticedCrossing_N)
        remark(ForceRemarkKind::speedsCross, s, crossed[k].at_mm, crossed[k].value, 0);
      if (driven[k].value < 0)
        remark(ForceRemarkKind::speedLimited, s, driven[k].at_mm, driven[k].value, driven[k].limit);
    }
    if (damped.value > 0) remark(ForceRemarkKind::speedLimited, s, damped.at_mm, damped.value, damped.limit);
  }

  /// Without a release curve, all speeds are released with the smallest press force; otherwise a press at one
  /// speed would supply energy for a release at another.
  static void shareLeast(ForceStateTable& to, std::size_t speeds, std::size_t row) {
    float least_N = to.rows[row].press_N;
    for (std::size_t k = 1; k < speeds; ++k) least_N = std::min(least_N, curveRow(to, k, row).press_N);
    for (std::size_t k = 0; k < speeds; ++k) curveRow(to, k, row).release_N = least_N;
  }

  void refuseIfFed(const FedBySpeeds& crossed, const FedBySpeeds& driven, double work_mJ,
                   const ButtonState& from, const ForceStateTable& to) {
    if (refused_ || !(crossed.fed_mJ + driven.fed_mJ > mostFedShare * work_mJ)) return;
    const FedBySpeeds& worst = crossed.fed_mJ >= driven.fed_mJ ? crossed : driven;
    const double pressed = to.speeds_mm_per_s[worst.pressed], other = to.speeds_mm_per_s[worst.released];
    char text[320];
    if (&worst == &crossed)
      std::snprintf(text, sizeof text,
                    "the release at %g mm/s lies up to %.3g N above the press at %g mm/s, at %.2f mm: "
                    "pressed at one and "
                    "released at the other, the motor would give %.3g mJ a press",
                    other, worst.value, pressed, worst.at_mm, worst.fed_mJ);
    else
      std::snprintf(text, sizeof text,
                    "from %g to %g mm/s the force drives the handle by %.2g N·s/mm at %.2f mm; %s takes %.2g "
                    "N·s/mm, and %.3g mJ a press would come from the motor",
                    other, pressed, -worst.value, worst.at_mm, device_.name.c_str(), -worst.limit,
                    worst.fed_mJ);
    refused_ =
        outOfRange(from.name.empty() ? "graphs at several speeds" : "graphs of state " + from.name, {}, text,
                   "Draw the graphs closer together, give the button damping, or use a button of one speed "
                   "(detent-graph convert makes one)");
  }

  // A press below its release would create energy, so there both get the force of the release.
  void setStrokes(const StrokeCurve& press, const StrokeCurve& release, ForceStateTable& to, std::size_t s,
                  std::size_t speed) {
    fill(release, beforeRelease(press, release), to, &ForceCurveRow::release_N, speed);
    fill(press, beforePress(press, release), to, &ForceCurveRow::press_N, speed);
    double crossing_N = 0, crossing_mm = 0;
    for (std::size_t i = 0; i < to.rowCount; ++i) {
      ForceCurveRow& row = curveRow(to, speed, i);
      const double apart_N = static_cast<double>(row.release_N - row.press_N), at_mm = placeOf(to, i);
      if (apart_N > crossing_N && at_mm > std::max(press.start_mm(), release.start_mm()) + apart_N / slope_) {
        crossing_N = apart_N;
        crossing_mm = at_mm;
      }
      row.press_N = std::max(row.press_N, row.release_N);
      to.hysteresis = to.hysteresis || row.release_N < row.press_N;
    }
    if (crossing_N > noticedCrossing_N) remark(ForceRemarkKind::strokesCross, s, crossing_mm, crossing_N, 0);
    remarkSteepness(press, s);
    if (!(release == press)) remarkSteepness(release, s);
  }

  void setPlaces(const Graphs& members, ForceStateTable& to) {
    const auto held_mm = [&](const StrokeCurve& c) {
      const double ramp_mm = std::max(0.0, startForce_N(c, device_.limits.force_N)) / slope_;
      return c.start_mm() - (ramp_mm + restraint_mm + restraintEnd_mm);
    };
    double end_mm = 0;
    for (const ForceGraph* graph : members) {
      const StrokeCurve &press = graph->press(), &release = settings_.law == ForceLawKind::graph
                                                                ? graph->curve(Stroke::release)
                                                                : press;
      const double held = std::min(held_mm(press), held_mm(release)),
                   end = std::max(press.end_mm(), release.end_mm());
      to.first_mm = graph == members.front() ? held : std::min(to.first_mm, held);
      end_mm = graph == members.front() ? end : std::max(end_mm, end);
    }
    to.rowCount = maxForceRows;
    to.spacing_mm = (end_mm - to.first_mm) / (maxForceRows - 1);
    to.bottomOutSlope_N_per_mm = slope_;
  }

  using Force = std::function<double(double at_mm)>;

  /// Force that holds the handle at a curve's start.
  Force restOf(const StrokeCurve& curve) const {
    return [&curve, start_N = startForce_N(curve, device_.limits.force_N), slope = slope_](double at_mm) {
      return restrained_N(start_N, curve.start_mm() - at_mm, slope);
    };
  }

  // If a press begins deeper than the release ends, its force before that is unknown, and that of the release
  // is used.
  Force beforePress(const StrokeCurve& press, const StrokeCurve& release) const {
    if (release.start_mm() >= press.start_mm()) return restOf(press);
    return
        [&release, rest = restOf(release), slope = slope_, largest_N = device_.limits.force_N](double at_mm) {
          return at_mm < release.start_mm() ? rest(at_mm) : forceOn(release, at_mm, slope, largest_N);
        };
  }

  // A self-locking state comes to rest where its release ends; a momentary button must return to where its
  // press began.
  Force beforeRelease(const StrokeCurve& press, const StrokeCurve& release) const {
    if (button_.selfLocking() || press.start_mm() >= release.start_mm()) return restOf(release);
    const double largest_N = device_.limits.force_N, start_N = startForce_N(release, largest_N);
    return [&press, rest = restOf(press), start_N, slope = slope_, largest_N](double at_mm) {
      return std::min(start_N,
                      at_mm < press.start_mm() ? rest(at_mm) : forceOn(press, at_mm, slope, largest_N));
    };
  }

  static double placeOf(const ForceStateTable& t, std::size_t row) {
    return t.first_mm + static_cast<double>(row) * t.spacing_mm;
  }

  /// Fills a stroke's forces into the table, limiting slopes to what the device can render: steep rises start
  /// later, steep falls last longer, so a peak keeps its force.
  void fill(const StrokeCurve& curve, const Force& beforeStart, ForceStateTable& to,
            float ForceCurveRow::*force, std::size_t speed) const {
    const double change_N = slope_ * to.spacing_mm;
    double before_N = 0;
    for (std::size_t i = 0; i < to.rowCount; ++i) {
      const double at_mm = placeOf(to, i);
      const double wanted_N = at_mm < curve.start_mm()
                                  ? beforeStart(at_mm)
                                  : forceOn(curve, at_mm, slope_, device_.limits.force_N);
      before_N = i == 0 ? wanted_N : std::clamp(wanted_N, before_N - change_N, before_N + change_N);
      curveRow(to, speed, i).*force = static_cast<float>(before_N);
    }
  }

  void remarkSteepness(const StrokeCurve& curve, std::size_t s) {
    double rise = 0, rise_mm = 0, fall = 0, fall_mm = 0;
    // width of a row if the table is full; a vertical rise cannot be steeper than one row
    const double narrowest_mm = curve.travel_mm() / maxForceRows;
    for (std::size_t i = 1; i <= maxForceRows; ++i) {
      const double to_mm = curve.start_mm() + static_cast<double>(i) * narrowest_mm;
      const double slope = (curve.force_N(to_mm) - curve.forceBefore_N(to_mm - narrowest_mm)) / narrowest_mm;
      if (slope > rise) rise = slope, rise_mm = to_mm;
      if (-slope > fall) fall = -slope, fall_mm = to_mm;
    }
    constexpr double rounding = 1.001;
    if (rise > slope_ * rounding) remark(ForceRemarkKind::bottomOutSoftened, s, rise_mm, rise, slope_);
    if (fall > slope_ * rounding) remark(ForceRemarkKind::fallSoftened, s, fall_mm, fall, slope_);
    const auto [low_N, high_N] = curve.forceRange_N();
    const double strongest_N = std::max(std::abs(low_N), std::abs(high_N)),
                 largest_N = device_.limits.force_N;
    if (strongest_N > largest_N)
      remark(ForceRemarkKind::forceClipped, s, curve.end_mm(), strongest_N, largest_N);
  }

  void setDamping(const ButtonState& from, ForceStateTable& to, std::size_t s) {
    to.damped = std::any_of(from.damping.begin(), from.damping.end(),
                            [](const DampingPoint& d) { return d.damping_Ns_per_mm > 0; });
    if (!to.damped) return;
    const double largest = largestDamping_Ns_per_mm(device_, 1 / prepared_.program.period_s);
    double strongest = 0, strongest_mm = 0;
    for (std::size_t i = 0; i < to.rowCount; ++i) {
      const double at_mm = placeOf(to, i);
      const double damping = dampingAt(from.damping, at_mm);
      if (damping > strongest) strongest = damping, strongest_mm = at_mm;
      // The first row applies to every smaller displacement: a handle out there is let go.
      const double held = std::min(1.0, (at_mm - to.first_mm) / restraintEnd_mm);
      to.rows[i].damping_Ns_per_mm = static_cast<float>(held * std::min(damping, largest));
    }
    if (strongest > largest) remark(ForceRemarkKind::dampingLimited, s, strongest_mm, strongest, largest);
  }

  /// Distance behind the last row at which the end stop pushes back as strongly as the curve's end pulls; 0
  /// if it does not pull.
  static double pulledIntoStop_mm(const ForceStateTable& t, float end_N) {
    return std::max(0.0, -static_cast<double>(end_N)) / t.bottomOutSlope_N_per_mm;
  }
  static double givenByStop_mJ(const ForceStateTable& t, float end_N) {
    const double pulled_mm = pulledIntoStop_mm(t, end_N);
    return 0.5 * t.bottomOutSlope_N_per_mm * pulled_mm * pulled_mm;
  }

  template <class ForceOfRow>
  static void setStored(const ForceOfRow& force_N, float ForceRow::*stored, ForceStateTable& to) {
    double stored_mJ = 0, least_mJ = 0;
    std::vector<double> sums_mJ(to.rowCount, 0.0);
    for (std::size_t i = 1; i < to.rowCount; ++i) {
      stored_mJ += 0.5 * static_cast<double>(force_N(i) + force_N(i - 1)) * to.spacing_mm;
      sums_mJ[i] = stored_mJ;
      least_mJ = std::min(least_mJ, stored_mJ);
    }
    least_mJ = std::min(least_mJ, stored_mJ - givenByStop_mJ(to, force_N(to.rowCount - 1)));
    for (std::size_t i = 0; i < to.rowCount; ++i)
      to.rows[i].*stored = static_cast<float>(sums_mJ[i] - least_mJ);
  }

  void setActuation(const ButtonState& from, const StrokeCurve& press, const StrokeCurve& release,
                    ForceStateTable& to) {
    double acts_mm =
        press.end_mm();  // without a stated operating point: the end of the last jump, else the bottom
    for (const Section& section : sectionsOf(press, Stroke::press)) {
      if (section.kind == SectionKind::jump) acts_mm = section.to_mm;
    }
    to.rest_mm = release.start_mm();
    // If the operating point is a rest itself, a press must move beyond the rest before it can return to it.
    const double leave_mm = std::max(press.start_mm(), to.rest_mm) + 2 * prepared_.program.law.settle_mm;
    const double last_mm = press.end_mm() - 2 * device_.step_mm;
    const double drawn_mm = from.operatingPoint_mm.value_or(acts_mm);
    const double risen_mm = risenTo_mm(to, drawn_mm, press.force_N(drawn_mm));
    to.operating_mm = std::min(std::max(risen_mm, leave_mm), std::max(last_mm, leave_mm));
  }

  /// Displacement, starting at an operating point, at which a press first has its drawn force; a limited rise
  /// reaches it later than drawn.
  double risenTo_mm(const ForceStateTable& t, double operating_mm, double drawn_N) const {
    const double force_N = risenShare * std::min(drawn_N, device_.limits.force_N);
    const auto rowAt = static_cast<std::size_t>(std::max(0.0, (operating_mm - t.first_mm) / t.spacing_mm));
    for (std::size_t i = rowAt; i < t.rowCount; ++i) {
      if (static_cast<double>(t.rows[i].pending_N) >= force_N) return std::max(operating_mm, placeOf(t, i));
    }
    return operating_mm;
  }

  void setRest() {
    const ForceStateTable& t = prepared_.program.states[0];
    const auto held = button_.selfLocking() ? &ForceRow::pendingStored_mJ : &ForceRow::stored_mJ;
    const auto force = button_.selfLocking() ? &ForceCurveRow::pending_N : &ForceCurveRow::release_N;
    const auto end = t.rows.begin() + t.rowCount;
    const auto least = std::min_element(
        t.rows.begin(), end, [held](const ForceRow& a, const ForceRow& b) { return a.*held < b.*held; });
    prepared_.summary.rest_mm = placeOf(t, static_cast<std::size_t>(least - t.rows.begin()));
    const ForceRow& last = t.rows[t.rowCount - 1];
    if (static_cast<double>(last.*held) - givenByStop_mJ(t, last.*force) <
        static_cast<double>((*least).*held))
      prepared_.summary.rest_mm = placeOf(t, t.rowCount - 1) + pulledIntoStop_mm(t, last.*force);
  }

  // Inside its band the play is an additional spring, (press - release) / 2r, which together with the curve
  // must satisfy the slope limit.
  void setPlayRadius() {
    double radius_mm = 2 * device_.step_mm;
    for (std::size_t s = 0; s < prepared_.program.stateCount; ++s) {
      const ForceStateTable& t = prepared_.program.states[s];
      if (!t.hysteresis) continue;
      for (std::size_t i = 1; i < t.rowCount; ++i) {
        double apart_N = static_cast<double>(t.rows[i].press_N - t.rows[i].release_N);
        double rise = static_cast<double>(t.rows[i].press_N - t.rows[i - 1].press_N) / t.spacing_mm;
        // One of the two compared strokes has the lowest speed, the other any speed.
        for (std::size_t k = 1; k < t.speedCount; ++k) {
          const ForceCurveRow& row = t.faster[k - 1][i];
          apart_N = std::max({apart_N, static_cast<double>(row.press_N - t.rows[i].release_N),
                              static_cast<double>(t.rows[i].press_N - row.release_N)});
          rise = std::max(rise,
                          static_cast<double>(row.press_N - t.faster[k - 1][i - 1].press_N) / t.spacing_mm);
        }
        radius_mm = std::max(radius_mm, apart_N / (2 * std::max(slope_ - std::max(rise, 0.0), 0.5 * slope_)));
      }
    }
    const double widest_mm = std::max(2 * device_.step_mm, widestPlayOfTravel * prepared_.summary.travel_mm);
    if (radius_mm > widest_mm) {
      remark(ForceRemarkKind::wideReturn, 0, 0, radius_mm, widest_mm);
      radius_mm = widest_mm;
    }
    prepared_.program.law.playRadius_mm = prepared_.summary.playRadius_mm = radius_mm;
  }

  const Button& button_;
  const ForceDeviceProfile& device_;
  const ForceSettings& settings_;
  double slope_ = 0;
  std::optional<Failure> refused_;
  PreparedForce prepared_;
};

/// Beyond a device's reach every reading is rejected, so a full press would lose its force on the way.
Result<Done> checkTravel(const ButtonState& state, const ForceDeviceProfile& device) {
  const Message place = state.name.empty() ? Message() : Message("state %1", state.name);
  const double travel_mm = state.graph.travel_mm(), end_mm = state.graph.press().end_mm(),
               reach_mm = device.limits.highest_mm;
  if (!(travel_mm >= shortestTravel_mm && travel_mm <= longestTravel_mm)) {
    return outOfRange(
        "travel of the button", place, Message("the value is %1", millimetres(travel_mm)),
        Message("A force device can produce %1 to %2; scale the button (edit it, or convert its graph)",
                millimetres(shortestTravel_mm), millimetres(longestTravel_mm)));
  }
  if (end_mm > reach_mm) {
    return outOfRange(
        "travel of the button", place,
        Message("the travel ends at %1, but %2 reaches only %3", millimetres(end_mm), device.name,
                millimetres(reach_mm)),
        Message("Choose a device that reaches farther, or scale the button (edit it, or convert its graph)"));
  }
  return Done{};
}

}  // namespace

Result<PreparedForce> prepareForce(const Button& button, const ForceDeviceProfile& device,
                                   const ForceSettings& settings) {
  if (Result<Done> checked = checkDevice(device, settings.rate_Hz.value_or(device.rate_Hz)); !checked)
    return checked.failure();
  for (const ButtonState& state : button.states()) {
    if (Result<Done> fits = checkTravel(state, device); !fits) return fits.failure();
  }
  return ForcePreparation(button, device, settings).run();
}

}  // namespace detent::playback
