// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/prepare/prepare_program.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "playback/prepare/felt_level.h"
#include "playback/prepare/stroke_table.h"
#include "playback/realtime/biquad.h"

namespace detent::playback {

namespace {

constexpr double highestFrequency_Hz = 2000;
constexpr double lowestBottomOut_Hz = 1;  // a bottom-out vibration lasts at least half a wave
constexpr double sharpestResonance = 1e4;
// limit of a coefficient, N; large, because the quantity of a divider that it multiplies may be as small as
// 1e-3
constexpr double largestCoefficient = 1e9;
constexpr double largestNoise_N = 50, longestLatency_s = 10;
// -120 dB: with less, a profile's transducer could bear no signal at all
constexpr double faintestCeiling = 1e-6;

// For following the finger (docs/develop/decisions/0906). Readings are already steadied (force_steadier.h);
// these values keep the strokes apart where a sensor's steps or a tremor remain.
constexpr double unknownSensorsHysteresis_N = 0.02;  // above one count of 10 bit over 12 N (0.0117 N)
constexpr double smallestHysteresis_N = 0.005;
constexpr double noiseInHysteresis = 4;
constexpr double rearmInHysteresis = 2.5;

constexpr double gentlest_N_per_mm = 0.02;  // gentler slopes have the level of a slope of this steepness

constexpr double drownedBelow_dB = 6, silent_dB = -1000;
constexpr double unfeltChange_dB = 0.5;  // a third of the just noticeable difference of a vibration

/// Bounds of one setting.
struct Bound {
  const char* name;
  double value, low, high;
  bool lowIncluded;
};

Result<Done> checkBounds(const Subject& subject, std::initializer_list<Bound> bounds) {
  for (const Bound& b : bounds) {
    const bool inside = b.value <= b.high && (b.lowIncluded ? b.value >= b.low : b.value > b.low);
    if (inside) continue;  // false for NaN
    return Failure{FailureCode::wrongUsage, subject, b.name,
                   b.lowIncluded ? Message("%1 lies outside %2 to %3", b.value, b.low, b.high)
                                 : Message("%1 must be above %2 and at most %3", b.value, b.low, b.high),
                   Message("Give a value inside this range")};
  }
  return Done{};
}

/// Data of one stroke for building its table.
struct StrokePlan {
  const StrokeCurve& curve;
  Stroke stroke;
  std::vector<Section> sections;
};

class HapticPreparation {
 public:
  HapticPreparation(const Button& button, const DeviceProfile& profile, const PlaybackSettings& settings)
      : button_(button), profile_(profile), settings_(settings) {}

  PreparedProgram run() {
    HapticProgram& p = prepared_.program;
    setName();
    setHysteresis();
    setChain();
    p.stateCount = static_cast<std::uint32_t>(std::min(button_.states().size(), maxStates));
    p.gridOrigin_mm = button_.states().front().graph.press().start_mm();
    for (const ButtonState& state : button_.states())
      p.gridOrigin_mm = std::min(p.gridOrigin_mm, lowOf(state));
    for (std::size_t i = 0; i < p.stateCount; ++i) prepareState(button_.states()[i], p.states[i]);
    if (!drowned_.empty()) {
      warn(PrepareWarningCode::clickDrowned,
           Message("with the levels of the published method, the click at %2 cannot be felt, because the "
                   "slope or the bottom-out is more than %1 dB stronger. Use --feel clear to keep the click",
                   drownedBelow_dB, drowned_));
    }
    return std::move(prepared_);
  }

 private:
  bool clicks() const {
    return settings_.mode == FeedbackMode::full || settings_.mode == FeedbackMode::clickOnly;
  }
  bool clear() const { return settings_.feel == Feel::clear; }
  bool slopes() const {
    const bool wanted = settings_.mode == FeedbackMode::full || settings_.mode == FeedbackMode::slopeOnly;
    return wanted && settings_.grainsPerMm > 0;
  }
  void warn(PrepareWarningCode code, Message message) {
    prepared_.summary.warnings.push_back({code, std::move(message)});
  }

  /// Lowest displacement of a state's tables. A release may end at another place than its press began.
  static double lowOf(const ButtonState& state) {
    return std::min(state.graph.press().start_mm(), state.graph.curve(Stroke::release).start_mm());
  }

  void setName() {
    auto& name = prepared_.program.name;
    std::size_t length = std::min(button_.name().size(), name.size() - 1);
    // Never divides a UTF-8 character.
    const auto continues = [&](std::size_t i) {
      return (static_cast<unsigned char>(button_.name()[i]) & 0xC0) == 0x80;
    };
    while (length > 0 && length < button_.name().size() && continues(length)) --length;
    std::copy_n(button_.name().begin(), length, name.begin());
  }

  void setHysteresis() {
    double strongest_N = 0;
    for (const ButtonState& state : button_.states()) {
      const auto [low, high] = state.graph.press().forceRange_N();
      strongest_N = std::max({strongest_N, std::fabs(low), std::fabs(high)});
    }
    HapticProgram& p = prepared_.program;
    p.sensorNoise_N = profile_.sensor.knownNoise_N();
    const double fromNoise_N = p.sensorNoise_N > 0
                                   ? std::max(noiseInHysteresis * p.sensorNoise_N, smallestHysteresis_N)
                                   : unknownSensorsHysteresis_N;
    const double wanted_N = settings_.hysteresis_N > 0 ? settings_.hysteresis_N : fromNoise_N;
    p.hysteresis_N = wanted_N;
    if (strongest_N > 0 && p.hysteresis_N > strongest_N / 10) {
      p.hysteresis_N = strongest_N / 10;
      warn(PrepareWarningCode::hysteresisReduced,
           {"the button's %1 are little for a hysteresis of %2; a tenth of its force is used",
            newtons(strongest_N), newtons(wanted_N)});
    }
    rearm_N_ = settings_.rearm_N > 0 ? settings_.rearm_N : rearmInHysteresis * p.hysteresis_N;
    p.restForce_N = p.hysteresis_N / 4;
    p.hysteresis_mm = settings_.hysteresis_mm;
  }

  void setChain() {
    HapticProgram& p = prepared_.program;
    const PlaybackSettings& s = settings_;
    p.grainsPerMm = slopes() ? s.grainsPerMm : 0;
    p.grain = {s.grainFrequency_Hz, s.grainDuration_s, s.grainAmplitude, Envelope::falling};
    // A whole number of half cycles: the rising envelope ends at its maximum, so the sine must be zero there.
    const double halfCycles = std::max(1.0, std::round(2 * s.bottomOutFrequency_Hz * s.bottomOutDuration_s));
    p.bottomOut = {s.bottomOutFrequency_Hz, halfCycles / (2 * s.bottomOutFrequency_Hz), s.bottomOutAmplitude,
                   Envelope::rising};
    p.lowPass = {s.lowPassPlacement, s.lowPassCutoff_Hz, s.lowPassOrder};
    p.grainCarrier = s.grainCarrier;
    p.highPass_Hz = s.highPass_Hz;
    p.limiterCeiling = std::min(s.limiterCeiling, profile_.transducer.highestLevel());
    p.placement = s.placement;
    p.interpolationDelay_s = s.sensorPeriod_s;
    p.longestInterval_s = std::max(4 * s.sensorPeriod_s, 0.02);
    p.burstSpacing_s = s.burstSpacing_s;
    p.gain = profile_.gain;
    if (clear()) {
      p.loudestDensity_per_s = s.clear.loudestSpeed_mm_per_s * s.grainsPerMm;
      p.slopeUnderJump = s.clear.slopeUnderJump;
      p.longestBottomOutWait_s = s.clear.longestBottomOutWait_s;
    }
    setJumpFrequencies();
    setEqualizer();
    setDevice();
  }

  void setDevice() {
    HapticProgram& p = prepared_.program;
    p.fullScale_dB = fullScale_dB(profile_);
    for (const Resonance& r : profile_.resonances) {
      if (p.resonanceCount == p.resonances.size()) break;
      p.resonances[p.resonanceCount++] = {r.frequency_Hz, r.q, r.gain_dB};
    }
  }

  void setEqualizer() {
    if (settings_.equalizer == EqualizerUse::off) return;
    HapticProgram& p = prepared_.program;
    std::vector<Message> left;
    for (const EqualizerBand& band : profile_.equalizer) {
      if (settings_.equalizer == EqualizerUse::full || !touchesJumps(band)) {
        p.equalizer[p.equalizerBandCount++] = band;
      } else {
        left.push_back({"%1 Hz", band.frequency_Hz});
      }
    }
    if (left.empty()) return;
    warn(PrepareWarningCode::equalizerSpared, {"the profile's equalizer is left out where it would take the "
                                               "jumps' strength (%1); --equalizer full uses it",
                                               left});
  }

  bool touchesJumps(const EqualizerBand& band) const {
    constexpr double anyRate_Hz = 192000;  // the highest rate, at which the band is at its intended frequency
    const BiquadCoefficients section = peaking(anyRate_Hz, band.frequency_Hz, band.q, band.gain_dB);
    const auto change_dB = [&](double frequency_Hz) {
      return std::fabs(20 * std::log10(magnitude(section, anyRate_Hz, frequency_Hz)));
    };
    return std::max(change_dB(press_Hz_), change_dB(release_Hz_)) > unfeltChange_dB;
  }

  void setJumpFrequencies() {
    press_Hz_ = settings_.pressJumpFrequency_Hz;
    release_Hz_ = settings_.releaseJumpFrequency_Hz;
    if (settings_.jumpFrequencySource == JumpFrequencySource::paper) return;
    if (profile_.resonances.empty()) {
      warn(PrepareWarningCode::noResonance,
           {"the profile has no resonance; jumps use %1 and %2 Hz", press_Hz_, release_Hz_});
      return;
    }
    const double wanted = press_Hz_;
    const auto nearest = std::min_element(
        profile_.resonances.begin(), profile_.resonances.end(), [&](const Resonance& a, const Resonance& b) {
          return std::fabs(std::log(a.frequency_Hz / wanted)) < std::fabs(std::log(b.frequency_Hz / wanted));
        });
    release_Hz_ *= nearest->frequency_Hz / wanted;
    press_Hz_ = nearest->frequency_Hz;
  }

  void prepareState(const ButtonState& from, StateProgram& to) {
    to.start_mm = from.graph.press().start_mm();
    to.end_mm = from.graph.press().end_mm();
    to.low_mm = lowOf(from);
    to.rest_mm = button_.selfLocking()
                     ? std::clamp(from.graph.curve(Stroke::release).start_mm(), to.low_mm, to.end_mm)
                     : to.low_mm;
    const StrokePlan press{from.graph.press(), Stroke::press,
                           sectionsOf(from.graph.press(), Stroke::press, settings_.sections)};
    const StrokeCurve& releaseCurve = from.graph.curve(Stroke::release);
    const StrokePlan release{releaseCurve, Stroke::release,
                             sectionsOf(releaseCurve, Stroke::release, settings_.sections)};
    setContact(from, press, to);
    setBottomOut(press, to);
    prepareStroke(press, to, to.press);
    prepareStroke(release, to, to.release);
    clear() ? letJumpsThrough(to) : findDrowned(to);
    prepared_.summary.pressJumps += to.press.jumpCount;
    prepared_.summary.releaseJumps += to.release.jumpCount;
    prepared_.summary.bottomOuts += to.hasBottomOut ? 1 : 0;
    if (&to == &prepared_.program.states[0]) {
      for (std::size_t i = 0; i < to.press.slopeCount; ++i) {
        const GrainRange& r = to.press.slopes[i];
        if (r.last >= r.first) prepared_.summary.grains += static_cast<std::size_t>(r.last - r.first + 1);
      }
    }
  }

  /// Lowers the slope below the weakest jump of its stroke, and the bottom-out below the jump before it;
  /// still lower they would not be felt after a strong click. A stroke without jumps is unchanged.
  void letJumpsThrough(StateProgram& state) {
    const HapticProgram& p = prepared_.program;
    const auto below = [&](double jump_dB, double level_dB) {
      return std::pow(10, std::min(0.0, jump_dB - settings_.clear.jumpAbove_dB - level_dB) / 20);
    };
    const std::vector<double> press_dB = jumpLevels_dB(state.press);
    if (!press_dB.empty())
      state.bottomOutLevel = below(press_dB.back(), feltLevel_dB(p.bottomOut, profile_, p));
    for (StrokeTable* stroke : {&state.press, &state.release}) {
      const std::vector<double> jumps_dB = jumpLevels_dB(*stroke);
      double loudest = 0;
      for (std::size_t i = 0; i < stroke->slopeCount; ++i)
        loudest = std::max(loudest, stroke->slopes[i].level);
      if (loudest > 0 && !jumps_dB.empty())
        stroke->slopeLevel = below(*std::min_element(jumps_dB.begin(), jumps_dB.end()),
                                   feltSlopeLevel_dB(profile_, p) + 20 * std::log10(loudest));
    }
  }

  /// Felt levels of a stroke's audible jumps, in the order travelled.
  std::vector<double> jumpLevels_dB(const StrokeTable& stroke) const {
    std::vector<double> levels_dB;
    for (std::size_t i = 0; i < stroke.jumpCount; ++i) {
      if (stroke.jumps[i].burst.amplitude > 0)
        levels_dB.push_back(feltLevel_dB(stroke.jumps[i].burst, profile_, prepared_.program));
    }
    return levels_dB;
  }

  /// Records the jumps that the paper's levels put far below the slope or the bottom-out.
  void findDrowned(const StateProgram& state) {
    const HapticProgram& p = prepared_.program;
    for (const StrokeTable* stroke : {&state.press, &state.release}) {
      double loudest_dB = silent_dB;
      if (stroke->slopeCount > 0 && p.grain.amplitude > 0) loudest_dB = feltSlopeLevel_dB(profile_, p);
      if (stroke == &state.press && state.hasBottomOut && p.bottomOut.amplitude > 0)
        loudest_dB = std::max(loudest_dB, feltLevel_dB(p.bottomOut, profile_, p));
      for (std::size_t i = 0; i < stroke->jumpCount; ++i) {
        const JumpEntry& jump = stroke->jumps[i];
        if (!(jump.burst.amplitude > 0) ||
            feltLevel_dB(jump.burst, profile_, p) >= loudest_dB - drownedBelow_dB)
          continue;
        drowned_.push_back({"%1", millimetres(jump.from_mm)});
      }
    }
  }

  void setContact(const ButtonState& from, const StrokePlan& press, StateProgram& to) {
    to.hasOperatingPoint = from.operatingPoint_mm.has_value() || button_.selfLocking();
    if (!to.hasOperatingPoint) return;
    // A self-locking button without a stated operating point switches at the end of its last jump, else at
    // the bottom.
    double acts_mm = to.end_mm;
    for (const Section& s : press.sections) {
      if (s.kind == SectionKind::jump) acts_mm = s.to_mm;
    }
    to.operating_mm = std::clamp(from.operatingPoint_mm.value_or(acts_mm), to.start_mm, to.end_mm);
    // An operating point must be beyond the start, so that it can be reached.
    if (to.operating_mm <= to.start_mm) to.operating_mm = std::nextafter(to.start_mm, to.end_mm);
    to.hasResetPoint = true;
    to.reset_mm = std::clamp(from.resetPoint_mm.value_or(to.operating_mm), to.low_mm, to.end_mm);
    if (to.reset_mm >= to.end_mm) to.reset_mm = std::nextafter(to.end_mm, to.start_mm);
  }

  void setBottomOut(const StrokePlan& press, StateProgram& to) {
    if (!clicks()) return;
    for (const Section& s : press.sections) {
      if (s.kind != SectionKind::bottomOut) continue;
      to.hasBottomOut = true;
      to.bottomOut_mm = s.from_mm > to.start_mm ? s.from_mm : to.end_mm;
      to.bottomOutRearm_mm = rearmPlace(press.curve, to.bottomOut_mm, to.start_mm);
    }
  }

  /// Place where the force has decreased from the firing force by the re-arm force, searched back along the
  /// curve; at most half the way to `end_mm`.
  double rearmPlace(const StrokeCurve& curve, double fires_mm, double end_mm) const {
    constexpr int steps = 256;
    const double fires_N = curve.force_N(fires_mm);
    const double farthest_mm = (fires_mm + end_mm) / 2;
    for (int i = 1; i < steps; ++i) {
      const double x_mm = fires_mm + (farthest_mm - fires_mm) * i / steps;
      if (std::fabs(curve.force_N(x_mm) - fires_N) >= rearm_N_) return x_mm;
    }
    return farthest_mm;
  }

  void prepareStroke(const StrokePlan& plan, const StateProgram& state, StrokeTable& table) {
    if (slopes()) addSlopes(plan, state, table);
    if (clicks()) addJumps(plan, state, table);
    std::vector<double> kept;
    for (const Section& s : plan.sections) {
      kept.push_back(s.from_mm);
      kept.push_back(s.to_mm);
    }
    if (kept.size() > maxTablePoints / 4) kept.resize(maxTablePoints / 4);
    // A release ends where the finger no longer pushes, even if the printed curve ends at or below zero
    // force.
    const double lowest_N =
        plan.stroke == Stroke::release ? prepared_.program.restForce_N : -ForceGraph::maxForce_N;
    const TableFit fit = fitTable(plan.curve, state.low_mm, state.end_mm, lowest_N, kept);
    std::copy(fit.points.begin(), fit.points.end(), table.points.begin());
    table.pointCount = static_cast<std::uint32_t>(fit.points.size());
    prepared_.summary.tablePoints += fit.points.size();
    prepared_.summary.tableError_N = std::max(prepared_.summary.tableError_N, fit.error_N);
  }

  // Grains are on one grid over the whole travel ("evenly along the displacement range"); a slope has the
  // grid positions within it. Where one stroke has no curve, its table is constant: all grains there would
  // sound at one force, as one click, so they are left out.
  void addSlopes(const StrokePlan& plan, const StateProgram& state, StrokeTable& table) {
    const auto cell = [&](double x_mm) {
      return static_cast<std::int64_t>(
          std::floor((x_mm - prepared_.program.gridOrigin_mm) * settings_.grainsPerMm + 1e-9));
    };
    std::vector<GrainRange> ranges;
    for (std::size_t i = 0; i < plan.sections.size(); ++i) {
      const Section& s = plan.sections[i];
      if (s.kind != SectionKind::slope) continue;
      double low = std::min(s.from_mm, s.to_mm), high = std::max(s.from_mm, s.to_mm);
      const bool first = i == 0, last = i + 1 == plan.sections.size();
      const bool press = plan.stroke == Stroke::press;
      if (press ? first : last) low = plan.curve.start_mm();
      if (press ? last : first) high = plan.curve.end_mm();
      high = std::min(high, state.end_mm);
      if (high > low) ranges.push_back({cell(low) + 1, cell(high)});
    }
    std::sort(ranges.begin(), ranges.end(),
              [](const GrainRange& a, const GrainRange& b) { return a.first < b.first; });
    std::vector<GrainRange> slopes;
    for (const GrainRange& range : ranges) {
      if (!slopes.empty() && slopes.back().last + 1 >= range.first) {
        slopes.back().last = std::max(slopes.back().last, range.last);
      } else {
        slopes.push_back(range);
      }
    }
    if (clear()) slopes = splitBySteepness(plan.curve, slopes);
    table.slopeCount = static_cast<std::uint32_t>(std::min(slopes.size(), maxSlopes));
    std::copy_n(slopes.begin(), table.slopeCount, table.slopes.begin());
    if (slopes.size() > maxSlopes)
      warn(PrepareWarningCode::slopesLeftOut,
           {"more than the %1 slopes a program holds; the last ones are silent", maxSlopes});
  }

  /// Steepness at a displacement of a slope, measured over a fifth of a millimetre on both sides, but not
  /// beyond the slope or into the bottom-out.
  static double steepness_N_per_mm(const StrokeCurve& curve, double at_mm, double from_mm, double to_mm) {
    constexpr double reach_mm = 0.2;
    const double low_mm = std::max(at_mm - reach_mm, from_mm), high_mm = std::min(at_mm + reach_mm, to_mm);
    return high_mm > low_mm
               ? std::fabs(curve.forceBefore_N(high_mm) - curve.force_N(low_mm)) / (high_mm - low_mm)
               : 0;
  }

  double levelOf_dB(double steepness_N_per_mm) const {
    const ClearFeel& s = settings_.clear;
    const double share = std::max(steepness_N_per_mm, gentlest_N_per_mm) / s.plainSlope_N_per_mm;
    return std::min(20 * s.levelBySteepness * std::log10(share), 20 * std::log10(loudestGrain()));
  }

  /// Level factor at which a grain reaches full scale.
  double loudestGrain() const { return settings_.grainAmplitude > 0 ? 1 / settings_.grainAmplitude : 1; }

  /// Divides a slope where its steepness changes the level by a hardly noticeable amount, or more coarsely if
  /// a program cannot hold all pieces.
  std::vector<GrainRange> splitBySteepness(const StrokeCurve& curve,
                                           const std::vector<GrainRange>& slopes) const {
    constexpr double finest_dB = 0.5, coarsest_dB = 64;
    std::vector<SlopeLevels> felt;
    felt.reserve(slopes.size());
    for (const GrainRange& slope : slopes) felt.push_back(levelsAlong(curve, slope));
    std::vector<GrainRange> pieces;
    for (double step_dB = finest_dB; step_dB <= coarsest_dB; step_dB *= 2) {
      pieces.clear();
      for (const SlopeLevels& slope : felt) addPieces(slope, step_dB, pieces);
      if (pieces.size() <= maxSlopes) break;
    }
    return pieces;
  }

  /// Felt level of a slope, evaluated every `stride` grains.
  struct SlopeLevels {
    GrainRange range;
    std::int64_t stride = 1;
    std::vector<double> felt_dB;
  };

  SlopeLevels levelsAlong(const StrokeCurve& curve, const GrainRange& range) const {
    constexpr std::int64_t mostReadings = 1024;
    const auto placeOf = [&](std::int64_t grain) {
      const double x_mm =
          prepared_.program.gridOrigin_mm + static_cast<double>(grain) / settings_.grainsPerMm;
      return std::clamp(x_mm, curve.start_mm(), curve.end_mm());
    };
    const double half_mm = range.first == range.last ? 0.5 / settings_.grainsPerMm : 0;
    const double from_mm = std::max(placeOf(range.first) - half_mm, curve.start_mm());
    const double to_mm = std::min(placeOf(range.last) + half_mm, curve.end_mm());
    SlopeLevels slope{range, (range.last - range.first) / mostReadings + 1, {}};
    for (std::int64_t grain = range.first; grain <= range.last; grain += slope.stride)
      slope.felt_dB.push_back(levelOf_dB(steepness_N_per_mm(curve, placeOf(grain), from_mm, to_mm)));
    return slope;
  }

  void addPieces(const SlopeLevels& slope, double step_dB, std::vector<GrainRange>& pieces) const {
    std::int64_t grain = slope.range.first;
    for (const double felt_dB : slope.felt_dB) {
      const double level =
          std::min(std::pow(10, std::round(felt_dB / step_dB) * step_dB / 20), loudestGrain());
      const std::int64_t last = std::min(grain + slope.stride - 1, slope.range.last);
      const bool goesOn = grain > slope.range.first && pieces.back().level == level;
      if (goesOn) {
        pieces.back().last = last;
      } else {
        pieces.push_back({grain, last, level});
      }
      grain = last + 1;
    }
  }

  void addJumps(const StrokePlan& plan, const StateProgram& state, StrokeTable& table) {
    struct Candidate {
      Section section;
      double area_mJ;
    };
    std::vector<Candidate> found;
    for (const Section& s : plan.sections) {
      if (s.kind == SectionKind::jump) found.push_back({s, jumpArea_mJ(plan.curve, s)});
    }
    if (found.size() > maxJumps) {
      // Of equal jumps, those met first are kept; the kept ones stay in the order travelled.
      std::vector<std::size_t> byArea(found.size());
      std::iota(byArea.begin(), byArea.end(), std::size_t{0});
      std::stable_sort(byArea.begin(), byArea.end(),
                       [&](std::size_t a, std::size_t b) { return found[a].area_mJ > found[b].area_mJ; });
      std::sort(byArea.begin() + maxJumps, byArea.end());
      std::vector<Message> left;
      for (auto i = byArea.begin() + maxJumps; i != byArea.end(); ++i)
        left.push_back({"%1", millimetres(found[*i].section.from_mm)});
      warn(PrepareWarningCode::jumpsLeftOut,
           {"%1 jumps on one stroke; the %2 strongest are kept, left out are those at %3", found.size(),
            maxJumps, left});
      std::sort(byArea.begin(), byArea.begin() + maxJumps);
      std::vector<Candidate> kept;
      for (std::size_t i = 0; i < maxJumps; ++i) kept.push_back(found[byArea[i]]);
      found = std::move(kept);
    }
    for (const Candidate& c : found)
      table.jumps[table.jumpCount++] = jumpEntry(c.section, c.area_mJ, plan, state);
  }

  JumpEntry jumpEntry(const Section& section, double area_mJ, const StrokePlan& plan,
                      const StateProgram& state) {
    const PlaybackSettings& s = settings_;
    const bool press = plan.stroke == Stroke::press;
    JumpEntry entry;
    entry.from_mm = std::clamp(section.from_mm, state.low_mm, state.end_mm);
    entry.to_mm = std::clamp(section.to_mm, state.low_mm, state.end_mm);
    entry.rearm_mm = rearmPlace(plan.curve, entry.from_mm, press ? state.start_mm : state.end_mm);
    entry.burst.frequency_Hz = press ? press_Hz_ : release_Hz_;
    entry.burst.duration_s =
        std::clamp(s.jumpDurationPerTravel_s_per_mm * std::fabs(section.to_mm - section.from_mm),
                   s.shortestJump_s, s.longestJump_s);
    const double wanted = s.jumpAmplitudePerArea_per_mJ * area_mJ;
    if (wanted > 1) {
      warn(PrepareWarningCode::jumpClipped,
           {"the jump at %1 asks for %2 times full scale and gets 1; lower the jump amplitude per area",
            millimetres(section.from_mm), wanted});
    }
    entry.burst.amplitude = std::clamp(wanted, s.faintestJump, 1.0);
    if (clear() && s.clear.jumpsByRoot) entry.burst.amplitude = std::sqrt(entry.burst.amplitude);
    entry.burst.quietensSlope = clear();
    entry.burst.envelope = Envelope::falling;
    return entry;
  }

  const Button& button_;
  const DeviceProfile& profile_;
  const PlaybackSettings& settings_;
  PreparedProgram prepared_;
  double press_Hz_ = 0, release_Hz_ = 0;
  double rearm_N_ = 0;
  std::vector<Message> drowned_;
};

}  // namespace

const char* nameOf(PrepareWarningCode code) {
  switch (code) {
    case PrepareWarningCode::hysteresisReduced:
      return "hysteresis-reduced";
    case PrepareWarningCode::noResonance:
      return "no-resonance";
    case PrepareWarningCode::slopesLeftOut:
      return "slopes-left-out";
    case PrepareWarningCode::jumpsLeftOut:
      return "jumps-left-out";
    case PrepareWarningCode::jumpClipped:
      return "jump-clipped";
    case PrepareWarningCode::clickDrowned:
      return "click-drowned";
    case PrepareWarningCode::equalizerSpared:
      break;
  }
  return "equalizer-spared";
}

std::string PrepareSummary::line() const {
  char text[240];
  std::snprintf(text, sizeof text,
                "%zu grains, %zu press jump%s, %zu release jump%s, %s; table %zu points, error %.2g N",
                grains, pressJumps, pressJumps == 1 ? "" : "s", releaseJumps, releaseJumps == 1 ? "" : "s",
                bottomOuts > 0 ? "bottom-out" : "no bottom-out", tablePoints, tableError_N);
  return text;
}

Result<Done> checkSettings(const PlaybackSettings& s) {
  Result<Done> bounds = checkBounds(
      "playback setting",
      {{"grainsPerMm", s.grainsPerMm, 0, 1000, true},
       {"grainFrequency_Hz", s.grainFrequency_Hz, 0, highestFrequency_Hz, false},
       {"grainDuration_s", s.grainDuration_s, 0, 1, false},
       {"grainAmplitude", s.grainAmplitude, 0, 1, true},
       {"lowPassCutoff_Hz", s.lowPassCutoff_Hz, 0, 20000, false},
       {"lowPassOrder", static_cast<double>(s.lowPassOrder), 1, 2, true},
       {"jumpDurationPerTravel_s_per_mm", s.jumpDurationPerTravel_s_per_mm, 0, 1000, false},
       {"longestJump_s", s.longestJump_s, 0, 1, false},
       {"shortestJump_s", s.shortestJump_s, 0, s.longestJump_s, false},
       {"jumpAmplitudePerArea_per_mJ", s.jumpAmplitudePerArea_per_mJ, 0, 1e9, false},
       {"faintestJump", s.faintestJump, 0, 1, true},
       {"pressJumpFrequency_Hz", s.pressJumpFrequency_Hz, 0, highestFrequency_Hz, false},
       {"releaseJumpFrequency_Hz", s.releaseJumpFrequency_Hz, 0, highestFrequency_Hz, false},
       {"bottomOutFrequency_Hz", s.bottomOutFrequency_Hz, lowestBottomOut_Hz, highestFrequency_Hz, true},
       {"clear.jumpAbove_dB", s.clear.jumpAbove_dB, 0, 60, false},
       {"clear.slopeUnderJump", s.clear.slopeUnderJump, 0, 1, true},
       {"clear.longestBottomOutWait_s", s.clear.longestBottomOutWait_s, 0, 1, true},
       {"clear.plainSlope_N_per_mm", s.clear.plainSlope_N_per_mm, 0, 1e7, false},
       {"clear.levelBySteepness", s.clear.levelBySteepness, 0, 2, true},
       {"clear.loudestSpeed_mm_per_s", s.clear.loudestSpeed_mm_per_s, 0, 1e5, false},
       {"bottomOutDuration_s", s.bottomOutDuration_s, 0, 1, false},
       {"bottomOutAmplitude", s.bottomOutAmplitude, 0, 1, true},
       {"highPass_Hz", s.highPass_Hz, 0, 100, true},
       {"hysteresis_N", s.hysteresis_N, 0, 10, true},
       {"hysteresis_mm", s.hysteresis_mm, 0, 1, false},
       {"rearm_N", s.rearm_N, 0, 10, true},
       {"sensorPeriod_s", s.sensorPeriod_s, 1e-5, 0.25, true},
       {"burstSpacing_s", s.burstSpacing_s, 0, 0.1, true},
       {"limiterCeiling", s.limiterCeiling, 0, 1, false},
       {"sections.minProminence_N", s.sections.minProminence_N, 0, 1e7, true},
       {"sections.minProminenceOfSpan", s.sections.minProminenceOfSpan, 0, 0.999999, true},
       {"sections.bottomOutSlopeRatio", s.sections.bottomOutSlopeRatio, 1, 1e12, false}});
  return bounds;
}

/// Rejects values that no sensor or link has, because they would propagate into forces and hysteresis.
Result<Done> checkMeasured(const DeviceProfile& profile) {
  if (Result<Done> ok =
          checkBounds("device profile", {{"full_scale_dB", fullScale_dB(profile), -60, 140, true}});
      !ok)
    return ok;
  const SensorCalibration& sensor = profile.sensor;
  for (std::size_t i = 0; i < sensor.coefficientCount; ++i) {
    if (Result<Done> ok = checkBounds("device profile", {{"sensor.coefficients", sensor.coefficients[i],
                                                          -largestCoefficient, largestCoefficient, true}});
        !ok)
      return ok;
  }
  const MeasuredLatency latency = profile.latency.value_or(MeasuredLatency{});
  return checkBounds("device profile", {{"sensor.noise_N", sensor.noise_N, 0, largestNoise_N, true},
                                        {"sensor.residual_N", sensor.residual_N, 0, largestNoise_N, true},
                                        {"latency mean_s", latency.mean_s, 0, longestLatency_s, true},
                                        {"latency sd_s", latency.sd_s, 0, longestLatency_s, true},
                                        {"latency p95_s", latency.p95_s, 0, longestLatency_s, true}});
}

Result<Done> checkProfile(const DeviceProfile& profile) {
  if (Result<Done> gain = checkBounds("device profile", {{"gain", profile.gain, faintestCeiling, 10, true}});
      !gain)
    return gain;
  if (profile.equalizer.size() > maxEqualizerBands) {
    return Failure{FailureCode::wrongUsage, "device profile", "equalizer",
                   Message("the equalizer has %1 bands, but at most %2 are allowed", profile.equalizer.size(),
                           maxEqualizerBands),
                   Message("Keep only the strongest bands")};
  }
  for (const EqualizerBand& band : profile.equalizer) {
    if (Result<Done> ok =
            checkBounds("device profile", {{"equalizer frequency_Hz", band.frequency_Hz, 0, 96000, false},
                                           {"equalizer q", band.q, 0, 1000, false},
                                           {"equalizer gain_dB", band.gain_dB, -60, 24, true}});
        !ok) {
      return ok;
    }
  }
  for (const Resonance& r : profile.resonances) {
    if (Result<Done> ok = checkBounds(
            "device profile", {{"resonance frequency_Hz", r.frequency_Hz, 0, highestFrequency_Hz, false},
                               {"resonance q", r.q, 0, sharpestResonance, false},
                               {"resonance gain_dB", r.gain_dB, -60, 120, true}});
        !ok) {
      return ok;
    }
  }
  if (Result<Done> ok = checkMeasured(profile); !ok) return ok;
  // With every circuit, more force gives a larger reading.
  const SensorCalibration& sensor = profile.sensor;
  if (sensor.circuit != SensorCircuit::newtons || sensor.weights > 0) {
    const double low = 0.1 * sensor.fullScale_counts, high = 0.9 * sensor.fullScale_counts;
    if (sensor.coefficientCount > 1 && !(sensor.force_N(high) > sensor.force_N(low))) {
      return Failure{FailureCode::wrongUsage, "device profile", "sensor.coefficients",
                     Message("the force falls while the reading rises"),
                     Message("Swap the sensor's two wires, or calibrate again")};
    }
  } else if (sensor.coefficientCount > 1 && !(sensor.coefficients[1] > 0)) {
    return Failure{FailureCode::wrongUsage, "device profile", "sensor.coefficients",
                   Message("the force falls while the reading rises"), Message("Calibrate the sensor again")};
  }
  const Transducer& t = profile.transducer;
  return checkBounds("device profile", {{"transducer power_W", t.power_W, 0, 1000, true},
                                        {"transducer impedance_ohm", t.impedance_ohm, 0, 1e5, false},
                                        {"transducer full_scale_V", t.fullScale_V, 0, 1000, true},
                                        {"share of full scale that the transducer's power_W allows",
                                         t.highestLevel(), faintestCeiling, 1, true}});
}

Result<PreparedProgram> prepareProgram(const Button& button, const DeviceProfile& profile,
                                       const PlaybackSettings& settings) {
  if (Result<Done> ok = checkSettings(settings); !ok) return ok.failure();
  if (Result<Done> ok = checkProfile(profile); !ok) return ok.failure();
  return HapticPreparation(button, profile, settings).run();
}

}  // namespace detent::playback
