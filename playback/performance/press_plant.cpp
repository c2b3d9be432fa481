// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/performance/press_plant.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "playback/performance/elementary.h"

namespace detent::playback {

namespace {

constexpr double startHeight_m = 0.003;  // above the cap
constexpr double posture_N_per_m = 20;   // towards the start
constexpr double joint_Ns_per_m = 0.5;
constexpr double extensorDecay_s = 0.02;
constexpr double play_m = 0.00002;  // the way from the release to the press branch
constexpr double steps_per_s = 1 / plantStep_s;
constexpr double capStep_s_per_kg = plantStep_s / capMass_kg;
constexpr double settled_m_per_s =
    1e-9;  // change of a speed between two rounds: works agree to far better than 1e-6
constexpr int mostRounds = 40;

/// The muscle's force, step by step: a half sine, then an extensor that fades, both through a lag.
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

  /// Mean force over the step that begins at `time_s`; steps are asked for in order.
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

 private:
  double amplitude_N_, extensor_N_;
  SineCosine turn_, phase_;
  double end_s_, extensorStart_s_, fade_, rising_, falling_;
  double force_N_ = 0;
};

struct Moving {
  double finger_m = -startHeight_m, finger_m_per_s = 0;
  double cap_m = 0, cap_m_per_s = 0;
  double play = -1;                                   // -1 release branch, 1 press branch
  double pulp_m() const { return finger_m - cap_m; }  // compression where > 0
};

/// Forces that, held over one step, do exactly the work of what they stand for.
struct StepForces {
  double spring_N = 0, pulpDamper_N = 0, button_N = 0, play_N = 0, capDamper_N = 0, posture_N = 0,
         joint_N = 0;
  double capDamping_Ns_per_m = 0;  // behind capDamper_N
  double pulp_N() const { return spring_N + pulpDamper_N; }
};

/// Switches of the two ways to read a contact: points of the button, and rapid trigger.
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
    now_.cap_m = restOfCap_m();
    start_J_ = storedIn(now_);
  }

  /// Where the cap stood after each step, if it is kept.
  void keepDepths(std::vector<double>& depths_m) { depths_m_ = &depths_m; }

  /// `toContact`: no farther than the first activation, or to where none comes any more.
  PressOutcome run(bool toContact = false) {
    const auto goesOn = [&] { return !outcome_.ended && !(toContact && outcome_.activation_s); };
    for (int step = 0; step * plantStep_s < longestPress_s && goesOn(); ++step) {
      const double time_s = step * plantStep_s;
      const double muscle_N = muscle_.next_N(time_s);
      if (touched_)
        advance(muscle_N);
      else
        advanceInAir(muscle_N);
      observe(time_s + plantStep_s);
      if (depths_m_) depths_m_->push_back(now_.cap_m);
    }
    if (energy_) energy_->stored_J = storedIn(now_) - start_J_;
    return outcome_;
  }

 private:
  /// Where the stop carries the force of the start.
  double restOfCap_m() const {
    double low_m = -0.001 - key_.mean_N(0) / 20000, high_m = 0;
    for (int i = 0; i < 60; ++i) {
      const double middle_m = 0.5 * (low_m + high_m);
      (key_.mean_N(middle_m) < key_.halfWidth_N(middle_m) ? low_m : high_m) = middle_m;
    }
    return 0.5 * (low_m + high_m);
  }

  double pulpEnergy_J(double pulp_m) const {
    return pulp_m > 0 ? 0.5 * finger_.pulp_N_per_m * pulp_m * pulp_m : 0;
  }

  double storedIn(const Moving& at) const {
    const double posture_m = at.finger_m + startHeight_m;
    return 0.5 * finger_.mass_kg * at.finger_m_per_s * at.finger_m_per_s +
           0.5 * capMass_kg * at.cap_m_per_s * at.cap_m_per_s + pulpEnergy_J(at.pulp_m()) +
           0.5 * posture_N_per_m * posture_m * posture_m + key_.stored_J(at.cap_m);
  }

  double pulpSpring_N(const Moving& to) const {
    const double a_m = now_.pulp_m(), b_m = to.pulp_m();
    if (a_m >= 0 && b_m >= 0) return 0.5 * finger_.pulp_N_per_m * (a_m + b_m);
    if (a_m <= 0 && b_m <= 0) return 0;
    return (pulpEnergy_J(b_m) - pulpEnergy_J(a_m)) / (b_m - a_m);
  }

  double playAt(double depth_m) const {
    return std::clamp(now_.play + 2 * (depth_m - now_.cap_m) / play_m, -1.0, 1.0);
  }

  StepForces forcesTowards(const Moving& to) const {
    StepForces f;
    f.spring_N = pulpSpring_N(to);
    const double closing_m_per_s = (to.pulp_m() - now_.pulp_m()) * steps_per_s;
    if (f.spring_N > 0) f.pulpDamper_N = finger_.pulpDamping_Ns_per_m * std::max(0.0, closing_m_per_s);
    const double middle_m = 0.5 * (now_.cap_m + to.cap_m);
    f.button_N = key_.meanBetween_N(now_.cap_m, to.cap_m);
    f.play_N = key_.halfWidth_N(middle_m) * 0.5 * (now_.play + playAt(to.cap_m));
    f.capDamping_Ns_per_m = key_.damping_Ns_per_m(middle_m);
    f.capDamper_N = f.capDamping_Ns_per_m * 0.5 * (now_.cap_m_per_s + to.cap_m_per_s);
    f.posture_N = posture_N_per_m * (0.5 * (now_.finger_m + to.finger_m) + startHeight_m);
    f.joint_N = joint_Ns_per_m * 0.5 * (now_.finger_m_per_s + to.finger_m_per_s);
    return f;
  }

  /// The end of the step under these forces; positions by the mean speed, so that force times way is energy, exactly.
  Moving movedBy(const StepForces& f, double muscle_N) const {
    Moving to = now_;
    to.finger_m_per_s += fingerStep_s_per_kg_ * (muscle_N - f.pulp_N() - f.posture_N - f.joint_N);
    // The cap's damper by its factor, not by rounds: a strongly damped button would not settle.
    const double factor = 0.5 * capStep_s_per_kg * f.capDamping_Ns_per_m;
    to.cap_m_per_s =
        (now_.cap_m_per_s * (1 - factor) + capStep_s_per_kg * (f.pulp_N() - f.button_N - f.play_N)) /
        (1 + factor);
    to.finger_m += 0.5 * plantStep_s * (now_.finger_m_per_s + to.finger_m_per_s);
    to.cap_m += 0.5 * plantStep_s * (now_.cap_m_per_s + to.cap_m_per_s);
    return to;
  }

  /// How the pulp's force over the step answers to the speed of closing at its end, around the guess.
  double pulpAnswer_Ns_per_m() const {
    double answer = 0;
    if (now_.pulp_m() > 0 && guess_.pulp_m() > 0) answer += 0.25 * plantStep_s * finger_.pulp_N_per_m;
    if (last_.pulpDamper_N > 0) answer += 0.5 * finger_.pulpDamping_Ns_per_m;
    return answer;
  }

  /// What `wanted` would be had the pulp been taken at the end it leads to instead of at the guess: Newton's step for the
  /// stiffest of the forces, which couples both bodies. Where rounds end is the same, they get there in fewer.
  Moving withPulpFollowing(Moving wanted) const {
    const double answer = pulpAnswer_Ns_per_m();
    const double finger = answer * fingerStep_s_per_kg_, cap = answer * capStep_s_per_kg;
    const double closing_m_per_s =
        ((wanted.finger_m_per_s - guess_.finger_m_per_s) - (wanted.cap_m_per_s - guess_.cap_m_per_s)) /
        (1 + finger + cap);
    const double finger_m_per_s = -finger * closing_m_per_s, cap_m_per_s = cap * closing_m_per_s;
    wanted.finger_m_per_s += finger_m_per_s;
    wanted.cap_m_per_s += cap_m_per_s;
    wanted.finger_m += 0.5 * plantStep_s * finger_m_per_s;
    wanted.cap_m += 0.5 * plantStep_s * cap_m_per_s;
    return wanted;
  }

  void advance(double muscle_N) {
    guess_ = movedBy(last_, muscle_N);
    for (int round = 0; round < mostRounds; ++round) {
      last_ = forcesTowards(guess_);
      const Moving better = withPulpFollowing(movedBy(last_, muscle_N));
      const double change_m_per_s = std::abs(better.finger_m_per_s - guess_.finger_m_per_s) +
                                    std::abs(better.cap_m_per_s - guess_.cap_m_per_s);
      guess_ = better;
      if (change_m_per_s < settled_m_per_s) break;
    }
    guess_.play = playAt(guess_.cap_m);
    accept(muscle_N);
  }

  /// Before the touch: the cap rests, the finger is moved by linear forces.
  void advanceInAir(double muscle_N) {
    const double mass_per_s = finger_.mass_kg / plantStep_s;
    const double force_N = muscle_N - posture_N_per_m * (now_.finger_m + startHeight_m) -
                           joint_Ns_per_m * now_.finger_m_per_s -
                           0.5 * posture_N_per_m * plantStep_s * now_.finger_m_per_s;
    const double change_m_per_s =
        force_N / (mass_per_s + 0.5 * joint_Ns_per_m + 0.25 * posture_N_per_m * plantStep_s);
    guess_ = now_;
    guess_.finger_m_per_s += change_m_per_s;
    guess_.finger_m += 0.5 * plantStep_s * (now_.finger_m_per_s + guess_.finger_m_per_s);
    if (guess_.pulp_m() > 0) {  // the first step in touch is a step of both
      touched_ = true;
      last_ = forcesTowards(now_);
      advance(muscle_N);
      return;
    }
    last_ = {};
    last_.posture_N = posture_N_per_m * (0.5 * (now_.finger_m + guess_.finger_m) + startHeight_m);
    last_.joint_N = joint_Ns_per_m * 0.5 * (now_.finger_m_per_s + guess_.finger_m_per_s);
    accept(muscle_N);
  }

  void accept(double muscle_N) {
    if (energy_) account(muscle_N);
    now_ = guess_;
  }

  void account(double muscle_N) {
    const double finger_m = guess_.finger_m - now_.finger_m, cap_m = guess_.cap_m - now_.cap_m;
    const double play_J = last_.play_N * cap_m;
    energy_->muscle_J += muscle_N * finger_m;
    energy_->playTaken_J += play_J;
    energy_->taken_J += play_J + last_.capDamper_N * cap_m + last_.joint_N * finger_m +
                        last_.pulpDamper_N * (finger_m - cap_m);
    energy_->moved_J += std::abs(muscle_N * finger_m);
  }

  void observe(double time_s) {
    if (!touched_) return;
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
  Moving now_, guess_;
  StepForces last_;
  PressOutcome outcome_;
  std::vector<double>* depths_m_ = nullptr;
  double fingerStep_s_per_kg_ = plantStep_s / finger_.mass_kg;
  double start_J_ = 0;
  bool touched_ = false;
};

}  // namespace

PressOutcome simulatePress(const KeyTables& key, const ContactPoints& contact, const Finger& finger,
                           const PressCommand& command, PressEnergy* energy) {
  return Press(key, contact, finger, command, energy).run();
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
  return Press(key, contact, finger, command, nullptr).run(true).activation_s.has_value();
}

}  // namespace detent::playback
