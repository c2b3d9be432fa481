// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/statistics/bradley_terry.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Dense>

#include "model/check.h"
#include "playback/measurement/normal.h"

namespace detent::playback {

namespace {

constexpr double addedEachWay = 0.5;
constexpr std::size_t fewestPersons = 6;  // the same as in participantBootstrap
constexpr int mostSteps = 100;
constexpr double smallestStep = 1e-12;

double shareOfLogOdds(double logOdds) { return 1 / (1 + std::exp(-logOdds)); }

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// Wins of the first of two things against the second, and number of their comparisons.
struct Duel {
  double wins = 0, all = 0;
};
using Duels = std::map<std::pair<std::size_t, std::size_t>, Duel>;

Duels duelsOf(const std::vector<Preference>& preferences) {
  Duels duels;
  for (const Preference& p : preferences) {
    Duel& duel = duels[std::minmax(p.winner, p.loser)];
    if (p.winner < p.loser) ++duel.wins;
    ++duel.all;
  }
  for (auto& [pair, duel] : duels) {
    duel.wins += addedEachWay;
    duel.all += 2 * addedEachWay;
  }
  return duels;
}

/// Gradient and information of the log likelihood.
struct Slopes {
  Vector gradient;
  Matrix information;
};

Slopes slopesAt(const Vector& scores, const Duels& duels) {
  const Eigen::Index n = scores.size();
  // fixes the mean of the scores
  Slopes s{Vector::Zero(n), Matrix::Constant(n, n, 1.0 / static_cast<double>(n))};
  for (const auto& [pair, duel] : duels) {
    const auto i = static_cast<Eigen::Index>(pair.first), k = static_cast<Eigen::Index>(pair.second);
    const double share = shareOfLogOdds(scores[i] - scores[k]), weight = duel.all * share * (1 - share);
    const double surplus = duel.wins - duel.all * share;
    s.gradient[i] += surplus;
    s.gradient[k] -= surplus;
    s.information(i, i) += weight;
    s.information(k, k) += weight;
    s.information(i, k) -= weight;
    s.information(k, i) -= weight;
  }
  return s;
}

/// Things that were not compared with the rest, even indirectly, leave a direction undetermined: it stays at
/// 0.
Matrix inverseOf(const Matrix& information) {
  return Eigen::CompleteOrthogonalDecomposition<Matrix>(information).pseudoInverse();
}

/// Contribution of each person's choices to the gradient.
Matrix pullsOf(const std::vector<Preference>& preferences, const Vector& scores, std::size_t persons) {
  Matrix pulls = Matrix::Zero(scores.size(), static_cast<Eigen::Index>(persons));
  for (const Preference& p : preferences) {
    const auto w = static_cast<Eigen::Index>(p.winner), l = static_cast<Eigen::Index>(p.loser);
    const double surprise = 1 - shareOfLogOdds(scores[w] - scores[l]);
    pulls(w, static_cast<Eigen::Index>(p.person)) += surprise;
    pulls(l, static_cast<Eigen::Index>(p.person)) -= surprise;
  }
  return pulls;
}

}  // namespace

PreferenceScores bradleyTerry(const std::vector<Preference>& preferences, std::size_t things,
                              double confidence) {
  DETENT_CHECK(things >= 2, "something to prefer to something");
  const Duels duels = duelsOf(preferences);
  Vector scores = Vector::Zero(static_cast<Eigen::Index>(things));
  for (int i = 0; i < mostSteps; ++i) {
    const Slopes s = slopesAt(scores, duels);
    Vector step = inverseOf(s.information) * s.gradient;
    const double longest = step.cwiseAbs().maxCoeff();
    if (longest > 1) step /= longest;  // far from the solution a Newton step overshoots
    scores += step;
    if (longest < smallestStep) break;
  }
  std::size_t persons = 0;
  for (const Preference& p : preferences) persons = std::max(persons, p.person + 1);
  Matrix spread = inverseOf(slopesAt(scores, duels).information);
  spread.array() -= 1.0 / static_cast<double>(things);  // the mean is fixed, not estimated
  PreferenceScores result;
  result.personsCounted = persons >= fewestPersons;
  double quantile = normalQuantile(0.5 + confidence / 2);
  if (result.personsCounted) {
    const Matrix pulls = spread * pullsOf(preferences, scores, persons);
    spread = pulls * pulls.transpose() * (static_cast<double>(persons) / static_cast<double>(persons - 1));
    quantile = studentQuantile(0.5 + confidence / 2, persons - 1);
  }
  for (Eigen::Index i = 0; i < scores.size(); ++i) {
    const double half = quantile * std::sqrt(std::max(spread(i, i), 0.0));
    result.scores.push_back(scores[i]);
    result.intervals.push_back({scores[i] - half, scores[i] + half});
  }
  return result;
}

}  // namespace detent::playback
