// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/identification/identify_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Dense>

namespace detent::playback {

namespace {

constexpr double motionMmPerM = 1000;
constexpr double longestSubstep_s = 100e-6;
// The record is divided into stretches with individual initial states: long enough to distinguish a force
// from a speed, short enough that an error of friction does not accumulate over many turns. The first rounds
// use shorter ones, because far from the solution long ones converge to a wrong minimum.
constexpr double stretch_s = 0.05, briefStretch_s = 0.02, goodOfStretch = 0.7, movedSteps = 6,
                 moved_mm = 0.02;
// Stretches are longer for slow links, because an initial state is determined by a number of samples, not by
// time.
constexpr double stretchPeriods = 16, briefStretchPeriods = 8;
constexpr std::size_t leastStretches = 12;
// After this many periods without an answer, the host or the link has paused. A device removes its force
// meanwhile, so the actual force is unknown.
constexpr double pausePeriods = 5;
constexpr int mostRounds = 60;
constexpr double converged = 1e-5;
constexpr double lightest_kg = 0.003, heaviest_kg = 3, roughDamping_Ns_per_mm = 5e-4, roughLag_ms2 = 0.04;
constexpr double oddTimes = 4, mostOdd = 0.25;
// Residuals may exceed rounding by this factor before something else must act on the handle.
constexpr double unexplainedTimes = 2.5, unexplained_mm = 0.004;

// A short lag resembles a delay of the same length, except for a part that grows with its square. Therefore
// the fit solves for the sum of delay and lag and for that square, in milliseconds.
enum Parameter : std::uint8_t { logMass, friction, damping, late_ms, lag_ms2, offset };
constexpr std::size_t parameters = 6;
using Globals = Eigen::Matrix<double, parameters, 1>;
using Square = Eigen::Matrix<double, parameters, parameters>;
using Start = Eigen::Vector2d;  ///< position in mm and speed in mm/s at the beginning of a stretch
using Locals = Eigen::Matrix<double, Eigen::Dynamic, 2>;
using MotionColumns = Eigen::Matrix<double, Eigen::Dynamic, parameters>;

// Steps of the numerical derivatives, and lower bounds of the parameters.
constexpr std::array<double, parameters> difference{1e-3, 1e-3, 1e-5, 0.02, 0.01, 1e-3};
// Errors that are not noise: static friction above the sliding friction, turns between two substeps. Measured
// on simulated handles with known values.
constexpr std::array<double, parameters> systematic{0.004, 0.0006, 8e-6, 0.012, 0.04, 1e-3};
constexpr std::array<double, parameters> least{-9.2, 0, 0, 0, 0, -100};

// The division of the lateness into delay and lag has at least this relative error, even without noise.
constexpr double msPerS = 1000, mostLag = 0.95, splitOfLate = 0.12;

double lagOf_s(const Globals& theta) {
  return std::min(std::sqrt(std::max(0.0, theta[lag_ms2])), theta[late_ms]) / msPerS;
}
double delayOf_s(const Globals& theta) { return theta[late_ms] / msPerS - lagOf_s(theta); }

struct Stretch {
  std::size_t first = 0, last = 0;  ///< sample indices, both included
  Start start;
};

/// The record on a time grid fine enough for the motor's dynamics, with the motor's force on it.
class Motor {
 public:
  explicit Motor(const MotionRecord& record) : record_(record) {
    firstSubstep_.push_back(0);
    for (std::size_t k = 0; k + 1 < record.time_s.size(); ++k) {
      const double period_s = record.time_s[k + 1] - record.time_s[k];
      const auto count = static_cast<std::size_t>(std::ceil(period_s / longestSubstep_s - 1e-9));
      firstSubstep_.push_back(firstSubstep_.back() + std::max<std::size_t>(count, 1));
    }
    force_N_.resize(firstSubstep_.back());
  }

  void follow(double delay_s, double lag_s) {
    if (followed_ == std::pair(delay_s, lag_s)) return;
    followed_ = {delay_s, lag_s};
    double motor_N = 0;
    std::size_t acting = 0;
    for (std::size_t k = 0; k + 1 < record_.time_s.size(); ++k) {
      const double dt_s = substep_s(k);
      const double kept = lag_s > 0 ? std::exp(-dt_s / lag_s) : 0.0, meanOff = lag_s / dt_s * (1 - kept);
      for (std::size_t i = firstSubstep_[k]; i < firstSubstep_[k + 1]; ++i) {
        const double from_s = record_.time_s[k] + static_cast<double>(i - firstSubstep_[k]) * dt_s - delay_s;
        const double requested_N = meanRequested_N(from_s, from_s + dt_s, acting);
        const double off_N = motor_N - requested_N;
        motor_N = requested_N + kept * off_N;
        force_N_[i] = requested_N + off_N * meanOff;
      }
    }
  }

  double substep_s(std::size_t k) const {
    return (record_.time_s[k + 1] - record_.time_s[k]) /
           static_cast<double>(firstSubstep_[k + 1] - firstSubstep_[k]);
  }
  std::size_t firstSubstep(std::size_t k) const { return firstSubstep_[k]; }
  double force_N(std::size_t substep) const { return force_N_[substep]; }

 private:
  double meanRequested_N(double from_s, double to_s, std::size_t& acting) const {
    const std::vector<double>& t = record_.time_s;
    while (acting + 1 < t.size() && t[acting + 1] <= from_s) ++acting;
    double sum = 0, at_s = from_s;
    for (std::size_t k = acting; at_s < to_s; ++k) {
      const bool last = k + 1 >= t.size();
      const double until_s = last ? to_s : std::min(to_s, t[k + 1]);
      if (until_s > at_s) {
        sum += (at_s < t.front() ? 0.0 : record_.force_N[k]) * (until_s - at_s);
        at_s = until_s;
      }
      if (last) break;
    }
    return sum / (to_s - from_s);
  }

  const MotionRecord& record_;
  std::vector<std::size_t> firstSubstep_;
  std::vector<double> force_N_;
  std::pair<double, double> followed_{-1, -1};
};

class MotionFit {
 public:
  explicit MotionFit(const MotionRecord& record)
      : record_(record),
        motor_(record),
        period_s_(usualPeriod_s(record)),
        pause_s_(pausePeriods * period_s_) {
    cut(std::max(briefStretch_s, briefStretchPeriods * period_s_));
  }

  std::size_t stretches() const { return stretches_.size(); }

  MotionIdentification run() {
    const Globals rough = solved(roughly());
    cut(std::max(stretch_s, stretchPeriods * period_s_));
    adaptStarts(rough);
    Globals theta = solved(rough);
    if (const std::size_t dropped = dropOdd(theta); dropped > 0) theta = solved(theta);
    return result(theta);
  }

 private:
  struct Part {
    MotionColumns global;
    Locals local;
    Eigen::VectorXd left;
    Eigen::Matrix2d inverse;  ///< inverse of local' local
  };
  struct Equations {
    Square normal = Square::Zero(), scatter = Square::Zero();
    Globals gradient = Globals::Zero();
    std::vector<Part> parts;
  };

  Globals solved(Globals theta) {
    double lambda = 1e-3, cost = costOf(theta);
    int still = 0;
    for (int round = 0; round < mostRounds; ++round) {
      const Equations e = equationsAt(theta);
      Square damped = e.normal;
      damped.diagonal() += lambda * e.normal.diagonal() + Globals::Constant(1e-12);
      Globals gradient = e.gradient;
      holdAtBounds(theta, damped, gradient);
      const Globals next = bounded(theta + damped.ldlt().solve(gradient));
      const std::vector<Stretch> before = stretches_;
      const double nextCost = moveStarts(e, next, next - theta);
      if (nextCost >= cost) {
        stretches_ = before;
        lambda *= 8;
        if (lambda > 1e8) break;
        continue;
      }
      still = lambda <= 1e-3 && cost - nextCost < converged * cost ? still + 1 : 0;
      cost = nextCost;
      theta = next;
      lambda = std::max(1e-9, lambda / 5);
      if (still >= 2) break;
    }
    return theta;
  }

  /// Holds a parameter at its bound if a step would leave its range.
  static void holdAtBounds(const Globals& theta, Square& normal, Globals& gradient) {
    for (std::size_t i = 0; i < parameters; ++i) {
      const auto p = static_cast<Eigen::Index>(i);
      if (theta[p] > least[i] || gradient[p] > 0) continue;
      normal.row(p).setZero();
      normal.col(p).setZero();
      normal(p, p) = 1;
      gradient[p] = 0;
    }
  }

  // The model does not include end stops. The few stretches in which the handle hits one have unusual
  // residuals and are dropped.
  std::size_t dropOdd(const Globals& theta) {
    motor_.follow(delayOf_s(theta), lagOf_s(theta));
    std::vector<double> squares;
    for (const Stretch& s : stretches_) {
      const Eigen::VectorXd left = leftOver(theta, s, s.start);
      squares.push_back(left.squaredNorm() / static_cast<double>(left.size()));
    }
    std::vector<double> sorted = squares;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double rounding = record_.step_mm * record_.step_mm / 12;
    const double most = oddTimes * oddTimes * std::max(*middle, rounding);
    std::vector<Stretch> kept;
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
      if (squares[i] <= most) kept.push_back(stretches_[i]);
    }
    const std::size_t dropped = stretches_.size() - kept.size();
    if (static_cast<double>(dropped) > mostOdd * static_cast<double>(stretches_.size())) return 0;
    stretches_ = std::move(kept);
    return dropped;
  }

  static Globals bounded(Globals theta) {
    for (std::size_t i = 0; i < parameters; ++i)
      theta[static_cast<Eigen::Index>(i)] = std::max(theta[static_cast<Eigen::Index>(i)], least[i]);
    // If the lag is the whole lateness, the direction of the correction is undetermined.
    theta[lag_ms2] = std::min(theta[lag_ms2], mostLag * mostLag * theta[late_ms] * theta[late_ms]);
    return theta;
  }

  void cut(double longest_s) {
    stretches_.clear();
    for (std::size_t first = 0; first + 1 < record_.time_s.size();) {
      std::size_t last = first, heard = first;
      while (last + 1 < record_.time_s.size() && record_.time_s[last] - record_.time_s[first] < longest_s &&
             record_.time_s[last + 1] - record_.time_s[heard] < pause_s_) {
        ++last;
        if (record_.good[last]) heard = last;
      }
      if (usable(first, last)) stretches_.push_back({first, last, startOf(first, last)});
      first = last + 1 < record_.time_s.size() && record_.time_s[last + 1] - record_.time_s[heard] >= pause_s_
                  ? afterPause(last + 1)
                  : last;
    }
  }

  /// First sample at which the motor gives the commanded force again: one pause's length after the first
  /// answer.
  std::size_t afterPause(std::size_t k) const {
    while (k < record_.time_s.size() && !record_.good[k]) ++k;
    const double until_s = k < record_.time_s.size() ? record_.time_s[k] + pause_s_ : 0;
    while (k < record_.time_s.size() && record_.time_s[k] < until_s) ++k;
    return k;
  }

  static double usualPeriod_s(const MotionRecord& record) {
    std::vector<double> periods_s;
    for (std::size_t k = 0; k + 1 < record.time_s.size(); ++k)
      periods_s.push_back(record.time_s[k + 1] - record.time_s[k]);
    const auto middle = periods_s.begin() + static_cast<std::ptrdiff_t>(periods_s.size() / 2);
    std::nth_element(periods_s.begin(), middle, periods_s.end());
    return *middle;
  }

  bool usable(std::size_t first, std::size_t last) const {
    std::size_t good = 0;
    double low_mm = std::numeric_limits<double>::max(), high_mm = std::numeric_limits<double>::lowest();
    for (std::size_t k = first; k <= last; ++k) {
      if (!record_.good[k]) continue;
      ++good;
      low_mm = std::min(low_mm, record_.position_mm[k]);
      high_mm = std::max(high_mm, record_.position_mm[k]);
    }
    return good >= 6 && static_cast<double>(good) >= goodOfStretch * static_cast<double>(last - first + 1) &&
           high_mm - low_mm > std::max(moved_mm, movedSteps * record_.step_mm);
  }

  /// Initial state by a straight line through the first few samples.
  Start startOf(std::size_t first, std::size_t last) const {
    Eigen::Matrix2d sums = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    int used = 0;
    for (std::size_t k = first; k <= last && used < 5; ++k) {
      if (!record_.good[k]) continue;
      const Eigen::Vector2d row(1, record_.time_s[k] - record_.time_s[first]);
      sums += row * row.transpose();
      right += row * record_.position_mm[k];
      ++used;
    }
    return sums.ldlt().solve(right);
  }

  /// Residuals of the model over a stretch's good samples; `motor_` must be up to date.
  Eigen::VectorXd leftOver(const Globals& theta, const Stretch& stretch, const Start& start) const {
    Eigen::VectorXd left(static_cast<Eigen::Index>(stretch.last - stretch.first + 1));
    Eigen::Index count = 0;
    double x = start[0], v = start[1];
    const double mass_kg = std::exp(theta[logMass]);
    for (std::size_t k = stretch.first; k <= stretch.last; ++k) {
      if (record_.good[k]) left[count++] = record_.position_mm[k] - x;
      if (k == stretch.last) break;
      const double dt_s = motor_.substep_s(k), perNewton = motionMmPerM * dt_s / mass_kg;
      const double half = 0.5 * perNewton * theta[damping], most = perNewton * theta[friction];
      for (std::size_t i = motor_.firstSubstep(k); i < motor_.firstSubstep(k + 1); ++i) {
        const double free = ((1 - half) * v + perNewton * (theta[offset] - motor_.force_N(i))) / (1 + half);
        const double next = std::abs(free) <= most ? 0 : free - std::copysign(most, free);
        x += 0.5 * (v + next) * dt_s;
        v = next;
      }
    }
    left.conservativeResize(count);
    return left;
  }

  double costOf(const Globals& theta) {
    motor_.follow(delayOf_s(theta), lagOf_s(theta));
    double cost = 0;
    for (const Stretch& s : stretches_) cost += leftOver(theta, s, s.start).squaredNorm();
    return std::isfinite(cost) ? cost : std::numeric_limits<double>::max();
  }

  /// Eliminates the initial state of each stretch: the remaining columns contain only what it cannot explain.
  Equations equationsAt(const Globals& theta) {
    Equations e;
    motor_.follow(delayOf_s(theta), lagOf_s(theta));
    for (const Stretch& s : stretches_) e.parts.push_back(partOf(theta, s));
    for (std::size_t p = 0; p < parameters; ++p) {
      const auto column = static_cast<Eigen::Index>(p);
      Globals moved = theta;
      moved[column] += difference[p];
      motor_.follow(delayOf_s(moved), lagOf_s(moved));
      for (std::size_t i = 0; i < stretches_.size(); ++i)
        e.parts[i].global.col(column) =
            (e.parts[i].left - leftOver(moved, stretches_[i], stretches_[i].start)) / difference[p];
    }
    for (Part& part : e.parts) {
      part.inverse = (part.local.transpose() * part.local + 1e-12 * Eigen::Matrix2d::Identity()).inverse();
      const auto without = [&](const auto& columns) {
        return (columns - part.local * (part.inverse * (part.local.transpose() * columns))).eval();
      };
      const MotionColumns own = without(part.global);
      const Globals score = own.transpose() * without(part.left);
      e.normal += own.transpose() * own;
      e.gradient += score;
      e.scatter += score * score.transpose();
    }
    return e;
  }

  Part partOf(const Globals& theta, const Stretch& s) const {
    constexpr double away_mm = 1e-3, faster_mm_per_s = 0.1;
    Part part;
    part.left = leftOver(theta, s, s.start);
    part.global.resize(part.left.size(), parameters);
    part.local.resize(part.left.size(), 2);
    part.local.col(0) = (part.left - leftOver(theta, s, s.start + Start(away_mm, 0))) / away_mm;
    part.local.col(1) =
        (part.left - leftOver(theta, s, s.start + Start(0, faster_mm_per_s))) / faster_mm_per_s;
    return part;
  }

  /// Moves the initial state of each stretch if that lowers its cost; where friction changes its direction,
  /// the linear step is wrong. Returns the cost.
  double moveStarts(const Equations& e, const Globals& theta, const Globals& by) {
    motor_.follow(delayOf_s(theta), lagOf_s(theta));
    double cost = 0;
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
      const Part& part = e.parts[i];
      const Start moved =
          stretches_[i].start + part.inverse * (part.local.transpose() * (part.left - part.global * by));
      cost += takeBetter(theta, stretches_[i], moved);
    }
    return std::isfinite(cost) ? cost : std::numeric_limits<double>::max();
  }

  double takeBetter(const Globals& theta, Stretch& s, const Start& moved) const {
    const double stays = leftOver(theta, s, s.start).squaredNorm(),
                 moves = leftOver(theta, s, moved).squaredNorm();
    if (!(moves < stays)) return stays;
    s.start = moved;
    return moves;
  }

  /// The best point of a coarse grid, each with its own initial states.
  Globals roughly() {
    const double period_s =
        (record_.time_s.back() - record_.time_s.front()) / static_cast<double>(record_.time_s.size() - 1);
    const std::vector<Stretch> all = std::exchange(stretches_, someOf(stretches_));
    const std::vector<Stretch> asRead = stretches_;
    Globals best = Globals::Zero();
    double bestCost = std::numeric_limits<double>::max();
    for (const double periods : {0.5, 1.5, 3.0}) {
      for (double mass_kg = lightest_kg; mass_kg < heaviest_kg; mass_kg *= 1.5) {
        for (const double friction_N : {0.0, 0.03, 0.1, 0.3}) {
          Globals theta;
          theta << std::log(mass_kg), friction_N, roughDamping_Ns_per_mm, periods * period_s * msPerS,
              roughLag_ms2, 0;
          stretches_ = asRead;
          adaptStarts(theta);
          const double cost = costOf(theta);
          if (cost < bestCost) bestCost = cost, best = theta;
        }
      }
    }
    stretches_ = all;
    adaptStarts(best);
    return best;
  }

  /// A selection that is evenly spread over the record.
  static std::vector<Stretch> someOf(const std::vector<Stretch>& all) {
    std::vector<Stretch> some;
    const std::size_t every = std::max<std::size_t>(1, all.size() / 32);
    for (std::size_t i = every / 2; i < all.size(); i += every) some.push_back(all[i]);
    return some;
  }

  void adaptStarts(const Globals& theta) {
    motor_.follow(delayOf_s(theta), lagOf_s(theta));
    for (Stretch& s : stretches_) {
      const Part part = partOf(theta, s);
      const Eigen::Matrix2d normal =
          part.local.transpose() * part.local + 1e-12 * Eigen::Matrix2d::Identity();
      takeBetter(theta, s, s.start + normal.ldlt().solve(part.local.transpose() * part.left));
    }
  }

  MotionIdentification result(const Globals& theta) {
    const double cost = costOf(theta);
    const Equations e = equationsAt(theta);
    MotionIdentification found;
    for (const Part& part : e.parts) found.samples += static_cast<std::size_t>(part.left.size());
    found.stretches = stretches_.size();
    const auto n = static_cast<double>(found.samples);
    const double used = static_cast<double>(2 * found.stretches + parameters);
    found.residual_mm = std::sqrt(cost / std::max(1.0, n - used));
    found.expected_mm = record_.step_mm / std::sqrt(12.0);
    // Errors within a stretch are correlated, so stretches count as independent, not readings. The variance
    // is at least that of independent rounding.
    const Square inverse = (e.normal + 1e-15 * Square::Identity()).inverse();
    const double m = static_cast<double>(found.stretches);
    const Square byStretches =
        inverse * (e.scatter * (m / std::max(1.0, m - static_cast<double>(parameters)))) * inverse;
    const Square independent = inverse * (found.residual_mm * found.residual_mm);
    const auto sigma = [&](const Globals& direction) {
      return std::sqrt(
          std::max({0.0, direction.dot(byStretches * direction), direction.dot(independent * direction)}));
    };
    const auto estimate = [&](Parameter p) {
      return Estimate{theta[p], std::hypot(sigma(Globals::Unit(p)), systematic[p])};
    };
    const Estimate mass = estimate(logMass);
    found.mass_kg = {std::exp(mass.value), std::exp(mass.value) * mass.sigma};
    found.friction_N = estimate(friction);
    found.damping_Ns_per_mm = estimate(damping);
    found.offset_N = estimate(offset);
    const double lateSigma_s = estimate(late_ms).sigma / msPerS;
    found.late_s = {theta[late_ms] / msPerS, lateSigma_s};
    // The error of the lag follows from that of its square.
    const Estimate square_ms2 = estimate(lag_ms2);
    const double lag_ms = std::sqrt(square_ms2.value),
                 more_ms = std::sqrt(square_ms2.value + square_ms2.sigma) - lag_ms,
                 less_ms = lag_ms - std::sqrt(std::max(0.0, square_ms2.value - square_ms2.sigma));
    const double lagSigma_s = std::hypot(std::max(more_ms, less_ms), splitOfLate * theta[late_ms]) / msPerS;
    found.lag_s = {lagOf_s(theta), lagSigma_s};
    found.delay_s = {delayOf_s(theta), std::hypot(lateSigma_s, lagSigma_s)};
    return found;
  }

  const MotionRecord& record_;
  Motor motor_;
  double period_s_, pause_s_;
  std::vector<Stretch> stretches_;
};

}  // namespace

bool MotionIdentification::explained() const {
  return residual_mm <= unexplainedTimes * expected_mm + unexplained_mm;
}

Result<MotionIdentification> identifyMotion(const MotionRecord& record) {
  const auto refused = [](const char* problem, const char* remedy) {
    return Failure{FailureCode::unreadableInput, "movement", "", problem, remedy};
  };
  const std::size_t n = record.time_s.size();
  if (n < 2 || record.position_mm.size() != n || record.force_N.size() != n || record.good.size() != n)
    return refused("holds no samples", "Record at least a second");
  MotionFit fit(record);
  if (fit.stretches() < leastStretches)
    return refused("is too little to tell anything", "Record longer, with more force, the handle free");
  return fit.run();
}

}  // namespace detent::playback
