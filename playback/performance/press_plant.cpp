// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/performance/press_plant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "playback/performance/elementary.h"

namespace detent::playback {

namespace {

constexpr double startHeight_m = 0.003;  // height of the finger above the cap
constexpr double posture_N_per_m = 20;   // stiffness of the spring that pulls the finger back to its start
constexpr double joint_Ns_per_m = 0.5;
constexpr double extensorDecay_s = 0.02;
constexpr double play_m = 0.00002;  // travel from the release branch to the press branch
constexpr double steps_per_s = 1 / plantStep_s;
constexpr double capStep_s_per_kg = plantStep_s / capMass_kg;
constexpr double settled_m_per_s =
    1e-9;  // change of a speed between two iterations; works are then accurate to far better than 1e-6
constexpr int mostRounds = 40;

/// The muscle's force, step by step: a half sine of the flexor, then a decaying pulse of the extensor, both
/// with a lag.
class Muscle {
 public:
  Muscle(const Finger& finger, const PressCommand& command)
      : amplitude_N_(command.amplitude_N),
        extensor_N_(extensorOfAmplitude * command.amplitude_N * finger.extensorShare),
        turn_(sineAndCosine(std::numbers::pi * plantStep_s / command.duration_s)),
        end_s_(command.duration_s),
        extensorStart_s_(command.duration_s + command.lift_s),
        fade_(exponential(-plantStep_s / extensorDecay_s)),
        rising_(1 - exponential(-plantStep_s / finger.muscleRise_s)),
        falling_(1 - exponential(-plantStep_s / finger.muscleFall_s)) {}

  /// Mean force over the step that begins at `time_s`; steps must be requested in order.
  double next_N(double time_s) {
    double wanted_N = 0;
    if (time_s < end_s_) {
      wanted_N = amplitude_N_ * phase_.sine;
      phase_ = {phase_.sine * turn_.cosine + phase_.cosine * turn_.sine,
                phase_.cosine * turn_.cosine - phase_.sine * turn_.sine};
    }
    if (time_s >= extensorStart_s_) {
      wanted_N -= extensor_N_;
      extensor_N_ *= fade_;
    }
    const double before_N = force_N_;
    force_N_ += (std::abs(wanted_N) > std::abs(force_N_) ? rising_ : falling_) * (wanted_N - force_N_);
    return 0.5 * (before_N + force_N_);
  }

  /// Returns true if from now on the muscle only pulls away from the key.
  bool pullsAway(double time_s) const {
    return time_s >= end_s_ && time_s >= extensorStart_s_ && force_N_ <= 0;
  }

 private:
  double amplitude_N_, extensor_N_;
  SineCosine turn_, phase_;
  double end_s_, extensorStart_s_, fade_, rising_, falling_;
  double force_N_ = 0;
};

template <class Real>
struct MovingOf {
  Real finger_m{}, finger_m_per_s{};
  Real cap_m{}, cap_m_per_s{};
  Real play{};                                      // -1 release branch, 1 press branch
  Real pulp_m() const { return finger_m - cap_m; }  // compression where > 0
};
using Moving = MovingOf<double>;

/// Constant forces over one step that do exactly the same work as the actual ones.
template <class Real>
struct ForcesOf {
  Real spring_N{}, pulpDamper_N{}, button_N{}, play_N{}, posture_N{}, joint_N{};
  Real capDamping_Ns_per_m{};  // the cap's damper is handled by a factor instead
  Real pulp_N() const { return spring_N + pulpDamper_N; }
};
using StepForces = ForcesOf<double>;

/// Energy stored in the finger's pulp, J.
template <class Real>
Real pulpEnergy_J(const Finger& finger, const Real& pulp_m) {
  return select(pulp_m > 0, 0.5 * finger.pulp_N_per_m * pulp_m * pulp_m, Real{});
}

/// Finger and cap in contact, over one step. `Real`: for one press, or for two by the same finger on the same
/// key.
template <class Real>
class StepOf {
 public:
  using Moving = MovingOf<Real>;
  using Forces = ForcesOf<Real>;

  StepOf(const KeyTables& key, const Finger& finger, const Moving& now)
      : key_(key),
        finger_(finger),
        fingerStep_s_per_kg_(plantStep_s / finger.mass_kg),
        now_(now),
        from_(key.startAt(now.cap_m)) {}

  /// State at the end of the step. `forces`: those of the previous step; receives those of this one.
  Moving end(Forces& forces, const Real& muscle_N) const {
    Moving guess = movedBy(forces, muscle_N);
    auto settled = guess.cap_m != guess.cap_m;  // none yet
    for (int round = 0; round < mostRounds; ++round) {
      const Forces latest = forcesTowards(guess);
      const Moving better = withPulpFollowing(movedBy(latest, muscle_N), guess, latest);
      const Real change_m_per_s =
          size(better.finger_m_per_s - guess.finger_m_per_s) + size(better.cap_m_per_s - guess.cap_m_per_s);
      if (any(settled)) {  // of two presses, the one that has converged keeps its result
        keepSettled(settled, latest, forces);
        keepSettled(settled, better, guess);
      } else {
        forces = latest;
        guess = better;
      }
      settled = either(settled, change_m_per_s < settled_m_per_s);
      if (all(settled)) break;
    }
    guess.play = playAt(guess.cap_m);
    return guess;
  }

  Forces forcesTowards(const Moving& to) const {
    Forces f;
    f.spring_N = pulpSpring_N(to);
    const Real closing_m_per_s = (to.pulp_m() - now_.pulp_m()) * steps_per_s;
    f.pulpDamper_N =
        select(f.spring_N > 0,
               finger_.pulpDamping_Ns_per_m * select(closing_m_per_s > 0, closing_m_per_s, Real{}), Real{});
    const auto middle = key_.placeOf(0.5 * (now_.cap_m + to.cap_m));
    f.button_N = key_.meanBetween_N(from_, key_.placeOf(to.cap_m));
    f.play_N = key_.halfWidth_N(middle) * 0.5 * (now_.play + playAt(to.cap_m));
    f.capDamping_Ns_per_m = key_.damping_Ns_per_m(middle);
    f.posture_N = posture_N_per_m * (0.5 * (now_.finger_m + to.finger_m) + startHeight_m);
    f.joint_N = joint_Ns_per_m * 0.5 * (now_.finger_m_per_s + to.finger_m_per_s);
    return f;
  }

 private:
  template <class True>
  static void keepSettled(const True& settled, const Forces& latest, Forces& forces) {
    for (Real Forces::*force : {&Forces::spring_N, &Forces::pulpDamper_N, &Forces::button_N, &Forces::play_N,
                                &Forces::posture_N, &Forces::joint_N, &Forces::capDamping_Ns_per_m})
      forces.*force = select(settled, forces.*force, latest.*force);
  }
  template <class True>
  static void keepSettled(const True& settled, const Moving& better, Moving& guess) {
    for (Real Moving::*place :
         {&Moving::finger_m, &Moving::finger_m_per_s, &Moving::cap_m, &Moving::cap_m_per_s})
      guess.*place = select(settled, guess.*place, better.*place);
  }

  Real pulpSpring_N(const Moving& to) const {
    const Real a_m = now_.pulp_m(), b_m = to.pulp_m();
    const Real both_N = 0.5 * finger_.pulp_N_per_m * (a_m + b_m);
    const auto touching = allOf(a_m >= 0, b_m >= 0), apart = allOf(a_m <= 0, b_m <= 0);
    if (all(touching)) return both_N;
    const Real way_m = select(either(touching, apart), Real{} + 1, b_m - a_m);
    return select(touching, both_N,
                  select(apart, Real{}, (pulpEnergy_J(finger_, b_m) - pulpEnergy_J(finger_, a_m)) / way_m));
  }

  Real playAt(const Real& depth_m) const {
    return clamped(now_.play + 2 * (depth_m - now_.cap_m) / play_m, -1, 1);
  }

  /// End of the step under these forces. Positions follow the mean speed, so that force times distance is
  /// exactly the energy.
  Moving movedBy(const Forces& f, const Real& muscle_N) const {
    Moving to = now_;
    to.finger_m_per_s += fingerStep_s_per_kg_ * (muscle_N - f.pulp_N() - f.posture_N - f.joint_N);
    // The cap's damper enters by a factor instead of by iteration, which would not converge for a strongly
    // damped button.
    const Real factor = 0.5 * capStep_s_per_kg * f.capDamping_Ns_per_m;
    to.cap_m_per_s =
        (now_.cap_m_per_s * (1 - factor) + capStep_s_per_kg * (f.pulp_N() - f.button_N - f.play_N)) /
        (1 + factor);
    to.finger_m += 0.5 * plantStep_s * (now_.finger_m_per_s + to.finger_m_per_s);
    to.cap_m += 0.5 * plantStep_s * (now_.cap_m_per_s + to.cap_m_per_s);
    return to;
  }

  /// Derivative of the pulp's mean force with respect to the closing speed at the end of the step, around the
  /// guess.
  Real pulpAnswer_Ns_per_m(const Moving& guess, const Forces& f) const {
    const Real answer = select(allOf(now_.pulp_m() > 0, guess.pulp_m() > 0),
                               Real{} + 0.25 * plantStep_s * finger_.pulp_N_per_m, Real{});
    return answer + select(f.pulpDamper_N > 0, Real{} + 0.5 * finger_.pulpDamping_Ns_per_m, Real{});
  }

  /// `wanted` with the pulp's force taken at the end of the step instead of at the guess: a Newton step for
  /// the stiffest force, which couples both bodies. The iteration converges to the same result in fewer
  /// steps.
  Moving withPulpFollowing(Moving wanted, const Moving& guess, const Forces& f) const {
    const Real answer = pulpAnswer_Ns_per_m(guess, f);
    const Real finger = answer * fingerStep_s_per_kg_, cap = answer * capStep_s_per_kg;
    const Real closing_m_per_s =
        ((wanted.finger_m_per_s - guess.finger_m_per_s) - (wanted.cap_m_per_s - guess.cap_m_per_s)) /
        (1 + finger + cap);
    const Real finger_m_per_s = -finger * closing_m_per_s, cap_m_per_s = cap * closing_m_per_s;
    wanted.finger_m_per_s += finger_m_per_s;
    wanted.cap_m_per_s += cap_m_per_s;
    wanted.finger_m += 0.5 * plantStep_s * finger_m_per_s;
    wanted.cap_m += 0.5 * plantStep_s * cap_m_per_s;
    return wanted;
  }

  const KeyTables& key_;
  const Finger& finger_;
  double fingerStep_s_per_kg_;
  Moving now_;
  KeyTables::Start<Real> from_;
};

/// The two ways of reading a contact: with the button's fixed points, and with rapid trigger.
class Contacts {
 public:
  explicit Contacts(const ContactPoints& points) : points_(points) {}

  void follow(double depth_m, double time_s, PressOutcome& outcome) {
    if (!closed_ && depth_m >= points_.close_m) {
      closed_ = true;
      if (++outcome.closings == 1) outcome.activation_s = time_s;
    } else if (closed_ && depth_m <= points_.open_m) {
      closed_ = false;
      if (!outcome.opening_s) outcome.opening_s = time_s;
    }
    followRapid(depth_m, time_s, outcome);
  }
  bool closed() const { return closed_; }
  double close_m() const { return points_.close_m; }

 private:
  void followRapid(double depth_m, double time_s, PressOutcome& outcome) {
    turn_m_ = rapidClosed_ ? std::max(turn_m_, depth_m) : std::min(turn_m_, depth_m);
    if (!rapidClosed_ && depth_m >= points_.close_m && depth_m >= turn_m_ + rapidTravel_m) {
      rapidClosed_ = true;
      turn_m_ = depth_m;
      ++outcome.rapidClosings;
    } else if (rapidClosed_ && (depth_m <= turn_m_ - rapidTravel_m || depth_m <= points_.open_m)) {
      rapidClosed_ = false;
      turn_m_ = depth_m;
      if (!outcome.rapidOpening_s) outcome.rapidOpening_s = time_s;
    }
  }

  ContactPoints points_;
  bool closed_ = false, rapidClosed_ = false;
  double turn_m_ = 0;
};

class Press {
 public:
  Press(const KeyTables& key, const ContactPoints& contact, const Finger& finger, const PressCommand& command,
        PressEnergy* energy)
      : key_(key), finger_(finger), muscle_(finger, command), contacts_(contact), energy_(energy) {
    now_.finger_m = -startHeight_m;
    now_.cap_m = restOfCap_m();
    now_.play = -1;
    start_J_ = storedIn(now_);
  }

  /// Records the depth of the cap after each step.
  void keepDepths(std::vector<double>& depths_m) { depths_m_ = &depths_m; }

  /// Ends the simulation at the first activation, or when none is possible any more.
  void onlyToContact() { toContact_ = true; }

  PressOutcome run() {
    while (goesOn()) {
      const double muscle_N = muscle_.next_N(time_s());
      advanceAlone(muscle_N);
      observe();
    }
    if (energy_) energy_->stored_J = storedIn(now_) - start_J_;
    return outcome_;
  }

  /// Simulates two presses of the same finger on the same key, side by side as long as both touch it.
  static std::array<PressOutcome, 2> runBoth(Press& first, Press& second) {
    while (first.goesOn() && second.goesOn()) {
      const double first_N = first.muscle_.next_N(first.time_s()),
                   second_N = second.muscle_.next_N(second.time_s());
      if (first.touched_ && second.touched_) {
        advanceBoth(first, second, first_N, second_N);
      } else {
        first.advanceAlone(first_N);
        second.advanceAlone(second_N);
      }
      first.observe();
      second.observe();
    }
    return {first.run(), second.run()};
  }

 private:
  double time_s() const { return step_ * plantStep_s; }

  bool goesOn() const {
    if (!(time_s() < longestPress_s) || outcome_.ended) return false;
    return !toContact_ || !(outcome_.activation_s || retreats(time_s()));
  }

  void advanceAlone(double muscle_N) {
    if (touched_)
      advance(muscle_N);
    else
      advanceInAir(muscle_N);
  }

  /// Returns true if the contact cannot close any more: the finger moves up, its muscle only pulls up from
  /// now on, and it is more than `flight_m` above the closing point. In contact, the cap is no lower than the
  /// finger, and when they separate the press ends. In one step the cap moves at most `flight_m` (2 m/s).
  bool retreats(double time_s) const {
    constexpr double flight_m = 1e-4;
    return touched_ && muscle_.pullsAway(time_s) && now_.finger_m_per_s < 0 &&
           now_.finger_m < contacts_.close_m() - flight_m;
  }

  /// Depth at which the stop balances the force at the start.
  double restOfCap_m() const {
    double low_m = -0.001 - key_.mean_N(0) / KeyTables::stop_N_per_m, high_m = 0;
    for (int i = 0; i < 60; ++i) {
      const double middle_m = 0.5 * (low_m + high_m);
      (key_.mean_N(middle_m) < key_.halfWidth_N(middle_m) ? low_m : high_m) = middle_m;
    }
    return 0.5 * (low_m + high_m);
  }

  double storedIn(const Moving& at) const {
    const double posture_m = at.finger_m + startHeight_m;
    return 0.5 * finger_.mass_kg * at.finger_m_per_s * at.finger_m_per_s +
           0.5 * capMass_kg * at.cap_m_per_s * at.cap_m_per_s + pulpEnergy_J(finger_, at.pulp_m()) +
           0.5 * posture_N_per_m * posture_m * posture_m + key_.stored_J(at.cap_m);
  }

  void advance(double muscle_N) {
    const StepOf<double> step(key_, finger_, now_);
    accept(step.end(last_, muscle_N), muscle_N);
  }

  static void advanceBoth(Press& first, Press& second, double firstMuscle_N, double secondMuscle_N) {
    const StepOf<Two> step(first.key_, first.finger_, sideBySide(first.now_, second.now_));
    ForcesOf<Two> forces = sideBySide(first.last_, second.last_);
    const MovingOf<Two> end = step.end(forces, Two{firstMuscle_N, secondMuscle_N});
    for (const int of : {0, 1}) {
      Press& press = of == 0 ? first : second;
      press.last_ = {
          forces.spring_N[of],  forces.pulpDamper_N[of], forces.button_N[of],           forces.play_N[of],
          forces.posture_N[of], forces.joint_N[of],      forces.capDamping_Ns_per_m[of]};
      press.accept(
          {end.finger_m[of], end.finger_m_per_s[of], end.cap_m[of], end.cap_m_per_s[of], end.play[of]},
          of == 0 ? firstMuscle_N : secondMuscle_N);
    }
  }

  static MovingOf<Two> sideBySide(const Moving& a, const Moving& b) {
    return {Two{a.finger_m, b.finger_m}, Two{a.finger_m_per_s, b.finger_m_per_s}, Two{a.cap_m, b.cap_m},
            Two{a.cap_m_per_s, b.cap_m_per_s}, Two{a.play, b.play}};
  }
  static ForcesOf<Two> sideBySide(const StepForces& a, const StepForces& b) {
    return {Two{a.spring_N, b.spring_N},
            Two{a.pulpDamper_N, b.pulpDamper_N},
            Two{a.button_N, b.button_N},
            Two{a.play_N, b.play_N},
            Two{a.posture_N, b.posture_N},
            Two{a.joint_N, b.joint_N},
            Two{a.capDamping_Ns_per_m, b.capDamping_Ns_per_m}};
  }

  /// Before the contact: the cap rests, and only linear forces act on the finger.
  void advanceInAir(double muscle_N) {
    const double mass_per_s = finger_.mass_kg / plantStep_s;
    const double force_N = muscle_N - posture_N_per_m * (now_.finger_m + startHeight_m) -
                           joint_Ns_per_m * now_.finger_m_per_s -
                           0.5 * posture_N_per_m * plantStep_s * now_.finger_m_per_s;
    const double change_m_per_s =
        force_N / (mass_per_s + 0.5 * joint_Ns_per_m + 0.25 * posture_N_per_m * plantStep_s);
    Moving to = now_;
    to.finger_m_per_s += change_m_per_s;
    to.finger_m += 0.5 * plantStep_s * (now_.finger_m_per_s + to.finger_m_per_s);
    if (to.pulp_m() > 0) {  // the first step in contact is one of both bodies
      touched_ = true;
      last_ = StepOf<double>(key_, finger_, now_).forcesTowards(now_);
      advance(muscle_N);
      return;
    }
    last_ = {};
    last_.posture_N = posture_N_per_m * (0.5 * (now_.finger_m + to.finger_m) + startHeight_m);
    last_.joint_N = joint_Ns_per_m * 0.5 * (now_.finger_m_per_s + to.finger_m_per_s);
    accept(to, muscle_N);
  }

  void accept(const Moving& to, double muscle_N) {
    if (energy_) account(to, muscle_N);
    now_ = to;
  }

  void account(const Moving& to, double muscle_N) {
    const double finger_m = to.finger_m - now_.finger_m, cap_m = to.cap_m - now_.cap_m;
    const double play_J = last_.play_N * cap_m;
    const double capDamper_N = last_.capDamping_Ns_per_m * 0.5 * (now_.cap_m_per_s + to.cap_m_per_s);
    energy_->muscle_J += muscle_N * finger_m;
    energy_->playTaken_J += play_J;
    energy_->taken_J +=
        play_J + capDamper_N * cap_m + last_.joint_N * finger_m + last_.pulpDamper_N * (finger_m - cap_m);
    energy_->moved_J += std::abs(muscle_N * finger_m);
  }

  void observe() {
    if (depths_m_) depths_m_->push_back(now_.cap_m);
    const double end_s = time_s() + plantStep_s;
    ++step_;
    if (touched_) observe(end_s);
  }

  void observe(double time_s) {
    if (!outcome_.touch_s) outcome_.touch_s = time_s;
    const double tip_N = last_.pulp_N();
    if (tip_N > outcome_.peak_N) {
      outcome_.peak_N = tip_N;
      outcome_.peak_s = time_s;
    }
    outcome_.impulse_Ns += tip_N * plantStep_s;
    outcome_.deepest_m = std::max(outcome_.deepest_m, now_.cap_m);
    contacts_.follow(now_.cap_m, time_s, outcome_);
    if (now_.pulp_m() < 0 && !contacts_.closed() && now_.finger_m_per_s < 0) {
      outcome_.ended = true;
      outcome_.end_s = time_s;
    }
  }

  const KeyTables& key_;
  const Finger& finger_;
  Muscle muscle_;
  Contacts contacts_;
  PressEnergy* energy_;
  Moving now_;
  StepForces last_;
  PressOutcome outcome_;
  std::vector<double>* depths_m_ = nullptr;
  double start_J_ = 0;
  int step_ = 0;
  bool touched_ = false, toContact_ = false;
};

}  // namespace

PressOutcome simulatePress(const KeyTables& key, const ContactPoints& contact, const Finger& finger,
                           const PressCommand& command, PressEnergy* energy) {
  return Press(key, contact, finger, command, energy).run();
}

std::array<PressOutcome, 2> simulatePresses(const KeyTables& key, const ContactPoints& contact,
                                            const Finger& finger,
                                            const std::array<PressCommand, 2>& commands) {
  Press first(key, contact, finger, commands[0], nullptr), second(key, contact, finger, commands[1], nullptr);
  return Press::runBoth(first, second);
}

std::vector<double> depthsOfPress(const KeyTables& key, const ContactPoints& contact, const Finger& finger,
                                  const PressCommand& command) {
  std::vector<double> depths_m;
  Press press(key, contact, finger, command, nullptr);
  press.keepDepths(depths_m);
  (void)press.run();
  return depths_m;
}

bool closesContact(const KeyTables& key, const ContactPoints& contact, const Finger& finger,
                   const PressCommand& command) {
  Press press(key, contact, finger, command, nullptr);
  press.onlyToContact();
  return press.run().activation_s.has_value();
}

}  // namespace detent::playback
