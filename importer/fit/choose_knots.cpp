// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/fit/choose_knots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace detent::importer {
namespace {

constexpr std::size_t knotsAdapting = 3;  // knots on each side that adapt to a change

using Index = std::ptrdiff_t;

bool isExtremum(const KnotChain& chain, std::size_t k) {
  return (chain[k].v() - chain[k - 1].v()) * (chain[k + 1].v() - chain[k].v()) < 0;
}

/// Turns a smooth joint that has become an extremum into a corner. Keeps the shape.
void settleJoints(KnotChain& chain) {
  for (std::size_t k = 1; k + 1 < chain.size(); ++k)
    if (chain[k].joint == JointKind::smooth && isExtremum(chain, k)) {
      chain[k].joint = chain[k].at[2] == 0 ? JointKind::flat : JointKind::corner;
      chain[k].at[3] = chain[k].at[2];
    }
}

/// The chain with its points grouped by piece.
class Workpiece {
 public:
  Workpiece(KnotChain& chain, const std::vector<SigmaPoint>& points, const SolveSettings& settings)
      : chain_(chain),
        points_(points),
        settings_(settings),
        footpoints_(footpointsOn(chain, points)),
        refused_(chain.size(), 0) {
    sumUp();
  }

  const KnotChain& chain() const { return chain_; }
  double chiSquareOfPiece(std::size_t piece) const { return pieceChiSquare_[piece]; }

  /// Indices of the points on one piece, in order.
  std::vector<std::size_t> pointsOfPiece(std::size_t piece) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < footpoints_.size(); ++i)
      if (footpoints_[i].piece == piece) found.push_back(i);
    return found;
  }
  const Footpoint& footpoint(std::size_t point) const { return footpoints_[point]; }
  const SigmaPoint& point(std::size_t i) const { return points_[i]; }

  /// A trial change: knots [from, to] of the chain are replaced by `trial`, whose outermost knots stay unless
  /// they are ends.
  struct Trial {
    std::size_t from = 0, to = 0;
    KnotChain knots;
    double gain = -std::numeric_limits<double>::infinity();  ///< decrease of chi-square
  };

  /// Copies the knots around `knot` for a change; `at` is the index of `knot` in the trial.
  Trial around(std::size_t knot, std::size_t& at) const {
    Trial trial;
    trial.from = knot > knotsAdapting ? knot - knotsAdapting : 0;
    trial.to = std::min(chain_.size() - 1, knot + knotsAdapting);
    trial.knots.assign(chain_.begin() + static_cast<Index>(trial.from),
                       chain_.begin() + static_cast<Index>(trial.to) + 1);
    at = knot - trial.from;
    return trial;
  }

  /// Solves the trial on the points of its pieces.
  void judge(Trial& trial) const {
    std::vector<SigmaPoint> nearby;
    double before = 0;
    for (std::size_t piece = trial.from; piece < trial.to; ++piece) before += pieceChiSquare_[piece];
    for (std::size_t i = 0; i < footpoints_.size(); ++i)
      if (footpoints_[i].piece >= trial.from && footpoints_[i].piece < trial.to) nearby.push_back(points_[i]);
    if (nearby.empty()) {
      trial.gain = 0;
      return;
    }
    const std::size_t first = trial.from == 0 ? 0 : 1;
    const std::size_t last = trial.to + 1 == chain_.size() ? trial.knots.size() : trial.knots.size() - 1;
    solveChain(trial.knots, nearby, {first, last}, settings_);
    settleJoints(trial.knots);
    trial.gain = before - chiSquareOf(trial.knots, nearby, settings_.robustScale);
  }

  void accept(const Trial& trial) {
    replace(chain_, trial.from, trial.to, trial.knots);
    replace(refused_, trial.from, trial.to, std::vector<char>(trial.knots.size(), 0));
    std::vector<std::size_t> members;
    std::vector<SigmaPoint> nearby;
    const std::size_t shift = trial.knots.size() - 1;
    for (std::size_t i = 0; i < footpoints_.size(); ++i) {
      if (footpoints_[i].piece >= trial.to)
        footpoints_[i].piece = footpoints_[i].piece - trial.to + trial.from + shift;
      else if (footpoints_[i].piece >= trial.from)
        members.push_back(i), nearby.push_back(points_[i]);
    }
    const std::vector<Footpoint> footpoints = footpointsOn(trial.knots, nearby);
    for (std::size_t m = 0; m < members.size(); ++m) {
      footpoints_[members[m]] = footpoints[m];
      footpoints_[members[m]].piece += trial.from;
    }
    sumUp();
  }

  /// Returns true if removing the knot was refused and nothing near it has changed since.
  bool isRefused(std::size_t knot) const { return refused_[knot] != 0; }
  void refuse(std::size_t knot) { refused_[knot] = 1; }

  /// Chi-square of the points around a knot if it were removed and no other moved: an upper bound of the
  /// loss.
  double chiSquareWithout(std::size_t knot) const {
    ChainPiece merged(chain_[knot - 1], chain_[knot + 1]);
    double sum = 0;
    for (std::size_t i = 0; i < footpoints_.size(); ++i) {
      if (footpoints_[i].piece + 1 != knot && footpoints_[i].piece != knot) continue;
      const double r = points_[i].weight * std::sqrt(nearestOn(merged, points_[i]).squaredDistance);
      sum += std::min(r * r, 2 * settings_.robustScale * r);
    }
    return sum;
  }

 private:
  template <class T>
  static void replace(std::vector<T>& all, std::size_t from, std::size_t to, const std::vector<T>& with) {
    all.erase(all.begin() + static_cast<Index>(from), all.begin() + static_cast<Index>(to) + 1);
    all.insert(all.begin() + static_cast<Index>(from), with.begin(), with.end());
  }

  void sumUp() {
    pieceChiSquare_.assign(chain_.size() - 1, 0.0);
    for (std::size_t i = 0; i < footpoints_.size(); ++i) {
      const double r = points_[i].weight * std::sqrt(footpoints_[i].squaredDistance),
                   k = settings_.robustScale;
      pieceChiSquare_[footpoints_[i].piece] += r <= k ? r * r : k * (2 * r - k);
    }
  }

  KnotChain& chain_;
  const std::vector<SigmaPoint>& points_;
  SolveSettings settings_;
  std::vector<Footpoint> footpoints_;
  std::vector<char> refused_;
  std::vector<double> pieceChiSquare_;
};

double secant(const ChainKnot& a, const ChainKnot& b) {
  const double h = std::max(b.u() - a.u(), 1e-6);
  return (b.v() - a.v()) / h;
}

ChainKnot cornerOf(const KnotChain& chain, std::size_t k) {
  ChainKnot knot = chain[k];
  const double before = secant(chain[k - 1], chain[k]), after = secant(chain[k], chain[k + 1]);
  // A slope at its limit has no information; the secant is a neutral start.
  knot.at[2] = knot.slopeBefore() * before > 0 ? knot.slopeBefore() : before;
  knot.at[3] = chain[k].slopeAfter() * after > 0 ? chain[k].slopeAfter() : after;
  knot.joint = JointKind::corner;
  return knot;
}

ChainKnot smoothOf(const KnotChain& chain, std::size_t k) {
  ChainKnot knot = chain[k];
  const double before = secant(chain[k - 1], chain[k]), after = secant(chain[k], chain[k + 1]);
  const double slope =
      before * after <= 0 ? 0 : std::copysign(std::min(std::abs(before), std::abs(after)), before);
  knot.joint = before * after < 0 ? JointKind::flat : JointKind::smooth;
  knot.at[2] = knot.at[3] = slope;
  return knot;
}

/// Knots by increasing loss when removed; those above `limit` are left out.
std::vector<std::size_t> removable(const Workpiece& work, double limit) {
  std::vector<std::pair<double, std::size_t>> stakes;
  for (std::size_t k = 1; k + 1 < work.chain().size(); ++k) {
    if (work.isRefused(k)) continue;
    const double stake = work.chiSquareWithout(k) - work.chiSquareOfPiece(k - 1) - work.chiSquareOfPiece(k);
    if (stake < limit) stakes.emplace_back(stake, k);
  }
  std::sort(stakes.begin(), stakes.end());
  std::vector<std::size_t> knots;
  for (const auto& [stake, k] : stakes) knots.push_back(k);
  return knots;
}

/// Gives a flat joint that is no extremum any more its own slope.
void freeSlope(KnotChain& chain, std::size_t k) {
  if (k == 0 || k + 1 >= chain.size() || chain[k].joint != JointKind::flat || isExtremum(chain, k)) return;
  const double before = secant(chain[k - 1], chain[k]), after = secant(chain[k], chain[k + 1]);
  chain[k].joint = JointKind::smooth;
  chain[k].at[2] = chain[k].at[3] =
      std::copysign(std::min(std::abs(before), std::abs(after)), before + after);
}

/// The chain without `count` knots from index `knot` on.
Workpiece::Trial withoutKnots(const Workpiece& work, std::size_t knot, std::size_t count) {
  std::size_t at = 0;
  Workpiece::Trial trial = work.around(knot, at);
  const auto first = trial.knots.begin() + static_cast<Index>(at);
  trial.knots.erase(first, first + static_cast<Index>(count));
  freeSlope(trial.knots, at - 1);
  freeSlope(trial.knots, at);
  work.judge(trial);
  return trial;
}

Workpiece::Trial withoutKnot(const Workpiece& work, std::size_t knot) { return withoutKnots(work, knot, 1); }

Workpiece::Trial withJoint(const Workpiece& work, std::size_t knot, const ChainKnot& replacement) {
  std::size_t at = 0;
  Workpiece::Trial trial = work.around(knot, at);
  trial.knots[at] = replacement;
  work.judge(trial);
  return trial;
}

/// Adds a knot to a piece where the residuals, averaged over a few neighbours, are largest.
bool withNewKnot(const Workpiece& work, std::size_t piece, Workpiece::Trial& trial) {
  const std::vector<std::size_t> members = work.pointsOfPiece(piece);
  if (members.size() < 4) return false;
  const ChainPiece shape(work.chain()[piece], work.chain()[piece + 1]);
  std::vector<double> sums{0};
  for (std::size_t i : members)
    sums.push_back(sums.back() + signedResidual(shape, work.point(i), work.footpoint(i).t));
  std::size_t best = members.size() / 2;
  double largest = 0;
  for (std::size_t i = 1; i + 1 < members.size(); ++i) {
    const std::size_t from = i < 2 ? 0 : i - 2, to = std::min(members.size(), i + 3);
    const double mean = std::abs(sums[to] - sums[from]) / static_cast<double>(to - from);
    if (mean > largest) largest = mean, best = i;
  }
  const double t = work.footpoint(members[best]).t;
  if (t <= 0.02 || t >= 0.98) return false;
  std::size_t at = 0;
  trial = work.around(piece + 1, at);
  const double slope = shape.h > 0 ? shape.dv(t) / shape.h : 0;
  const SigmaPoint& p = work.point(members[best]);
  trial.knots.insert(trial.knots.begin() + static_cast<Index>(at),
                     ChainKnot{{shape.u(t), 0.5 * (shape.v(t) + p.v), slope, slope}, JointKind::smooth});
  if (at > 0 && isExtremum(trial.knots, at)) {
    trial.knots[at].joint = JointKind::flat;
    trial.knots[at].at[2] = trial.knots[at].at[3] = 0;
  }
  work.judge(trial);
  return true;
}

int parametersOfRange(const KnotChain& knots) {
  int count = 0;
  for (const ChainKnot& knot : knots) count += freedomOf(knot.joint);
  return count;
}

bool pays(const Workpiece& work, const Workpiece::Trial& trial, const KnotEvidence& evidence) {
  const KnotChain old(work.chain().begin() + static_cast<Index>(trial.from),
                      work.chain().begin() + static_cast<Index>(trial.to) + 1);
  const int added = parametersOfRange(trial.knots) - parametersOfRange(old);
  return trial.gain > evidence.pricePerParameter * evidence.correlationPoints * added;
}

/// Removes a small step back inside a rise (or the reverse). Its two extrema can only be removed together.
bool straightenZigzags(Workpiece& work, const KnotEvidence& evidence) {
  constexpr double small = 6;  // sigmas
  bool changed = false;
  for (std::size_t k = 1; k + 2 < work.chain().size(); ++k) {
    const KnotChain& chain = work.chain();
    if (!isExtremum(chain, k) || !isExtremum(chain, k + 1)) continue;
    if (std::abs(chain[k + 1].v() - chain[k].v()) > small) continue;
    const Workpiece::Trial trial = withoutKnots(work, k, 2);
    if (!pays(work, trial, evidence)) continue;
    work.accept(trial);
    changed = true;
    --k;
  }
  return changed;
}

/// Merges two close knots into one corner; removing either alone would lose a slope.
bool mergeCloseKnots(Workpiece& work, const KnotEvidence& evidence) {
  constexpr double close = 15;  // sigmas
  bool changed = false;
  for (std::size_t k = 1; k + 2 < work.chain().size(); ++k) {
    const ChainKnot &one = work.chain()[k], &other = work.chain()[k + 1];
    if (std::hypot(other.u() - one.u(), other.v() - one.v()) > close) continue;
    std::size_t at = 0;
    Workpiece::Trial trial = work.around(k, at);
    const double before = ChainPiece(work.chain()[k - 1], one).endSlope();
    const double after = ChainPiece(other, work.chain()[k + 2]).startSlope();
    trial.knots[at] = {{0.5 * (one.u() + other.u()), 0.5 * (one.v() + other.v()), before, after},
                       JointKind::corner};
    trial.knots.erase(trial.knots.begin() + static_cast<Index>(at) + 1);
    work.judge(trial);
    if (!pays(work, trial, evidence)) continue;
    work.accept(trial);
    changed = true;
    --k;
  }
  return changed;
}

bool simplify(Workpiece& work, const KnotEvidence& evidence) {
  bool changed = false;
  // The loss is an upper bound, because neighbours adapt and compensate most of it.
  const double limit = 12 * evidence.chiSquarePer(3);
  bool again = true;
  while (again) {
    again = false;
    for (std::size_t knot : removable(work, limit)) {
      const Workpiece::Trial trial = withoutKnot(work, knot);
      if (!pays(work, trial, evidence)) {
        work.refuse(knot);
        continue;
      }
      work.accept(trial);
      again = changed = true;
      break;
    }
  }
  changed = straightenZigzags(work, evidence) || changed;
  changed = mergeCloseKnots(work, evidence) || changed;
  for (std::size_t k = 1; k + 1 < work.chain().size(); ++k) {
    if (work.chain()[k].joint != JointKind::corner) continue;
    const Workpiece::Trial trial = withJoint(work, k, smoothOf(work.chain(), k));
    if (!pays(work, trial, evidence)) continue;
    work.accept(trial);
    changed = true;
  }
  return changed;
}

bool extend(Workpiece& work, const KnotEvidence& evidence, int maxPieces) {
  bool changed = false;
  for (std::size_t k = 1; k + 1 < work.chain().size(); ++k) {
    const JointKind joint = work.chain()[k].joint;
    const int added = freedomOf(JointKind::corner) - freedomOf(joint);
    if (added <= 0 || work.chiSquareOfPiece(k - 1) + work.chiSquareOfPiece(k) < evidence.chiSquarePer(added))
      continue;
    const Workpiece::Trial trial = withJoint(work, k, cornerOf(work.chain(), k));
    if (!pays(work, trial, evidence)) continue;
    work.accept(trial);
    changed = true;
  }
  for (std::size_t piece = 0; piece + 1 < work.chain().size(); ++piece) {
    if (static_cast<int>(work.chain().size()) > maxPieces) break;
    if (work.chiSquareOfPiece(piece) < evidence.chiSquarePer(2)) continue;
    Workpiece::Trial trial;
    if (!withNewKnot(work, piece, trial) || !pays(work, trial, evidence)) continue;
    work.accept(trial);
    changed = true;
  }
  return changed;
}

}  // namespace

KnotEvidence::KnotEvidence(double points, double correlation)
    : correlationPoints(std::max(1.0, correlation)),
      pricePerParameter(std::log(std::max(3.0, points / std::max(1.0, correlation)))) {}

int parametersOf(const KnotChain& chain) {
  // Each end has one coordinate and a slope.
  int count = 4;
  for (std::size_t k = 1; k + 1 < chain.size(); ++k) count += freedomOf(chain[k].joint);
  return count;
}

std::vector<double> residualsOf(const KnotChain& chain, const std::vector<SigmaPoint>& points) {
  const std::vector<ChainPiece> pieces = piecesOf(chain);
  const std::vector<Footpoint> footpoints = footpointsOn(chain, points);
  std::vector<double> residuals;
  residuals.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    residuals.push_back(signedResidual(pieces[footpoints[i].piece], points[i], footpoints[i].t));
  return residuals;
}

bool chooseKnots(KnotChain& chain, const std::vector<SigmaPoint>& points, const KnotEvidence& evidence,
                 const ChoiceSettings& settings) {
  settleJoints(chain);
  // The first segmentation may be far off in places; a robust loss would treat the points there as outliers.
  SolveSettings first = settings.solve;
  first.robustScale *= 10;
  bool converged = solveChain(chain, points, {0, chain.size()}, first);
  dropRedundantKnots(chain);
  SolveSettings local = settings.solve;
  local.associations = 1;
  local.maxIterations = 8;
  local.tolerance = std::max(1e-3, local.tolerance);
  for (int round = 0; round < settings.rounds; ++round) {
    Workpiece work(chain, points, local);
    bool changed = simplify(work, evidence);
    changed = extend(work, evidence, settings.maxPieces) || changed;
    if (!changed) break;
    settleJoints(chain);
    dropRedundantKnots(chain);
    converged = solveChain(chain, points, {0, chain.size()}, settings.solve);
    dropRedundantKnots(chain);
  }
  return converged;
}

bool reachPieces(KnotChain& chain, const std::vector<SigmaPoint>& points, int pieces,
                 const ChoiceSettings& settings) {
  SolveSettings local = settings.solve;
  local.associations = 1;
  const auto count = [&] { return static_cast<int>(chain.size()) - 1; };
  while (count() > std::max(1, pieces)) {
    Workpiece work(chain, points, local);
    const std::vector<std::size_t> knots = removable(work, std::numeric_limits<double>::infinity());
    Workpiece::Trial best;
    // Tries the knots with the smallest loss; the solve then shows which is really the cheapest.
    for (std::size_t i = 0; i < std::min<std::size_t>(knots.size(), 3); ++i) {
      Workpiece::Trial trial = withoutKnot(work, knots[i]);
      if (trial.gain > best.gain) best = std::move(trial);
    }
    work.accept(best);
    dropRedundantKnots(chain);
  }
  while (count() < pieces) {
    Workpiece work(chain, points, local);
    std::vector<std::size_t> order(chain.size() - 1);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return work.chiSquareOfPiece(a) > work.chiSquareOfPiece(b);
    });
    bool added = false;
    for (std::size_t piece : order) {
      Workpiece::Trial trial;
      if (!withNewKnot(work, piece, trial)) continue;
      work.accept(trial);
      added = true;
      break;
    }
    if (!added) break;
  }
  settleJoints(chain);
  const bool converged = solveChain(chain, points, {0, chain.size()}, settings.solve);
  dropRedundantKnots(chain);
  return converged;
}

namespace {

struct PlaceOnLine {
  double u = 0, v = 0, distance = std::numeric_limits<double>::infinity();
};

/// Returns the place nearest to a knot on the line through the points.
PlaceOnLine nearestOnLine(const ChainKnot& knot, const std::vector<SigmaPoint>& points) {
  PlaceOnLine best;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const SigmaPoint &a = points[i], &b = points[i + 1];
    const double du = b.u - a.u, dv = b.v - a.v, square = du * du + dv * dv;
    const double t =
        square > 0 ? std::clamp(((knot.u() - a.u) * du + (knot.v() - a.v) * dv) / square, 0.0, 1.0) : 0;
    const double distance = std::hypot(knot.u() - a.u - t * du, knot.v() - a.v - t * dv);
    if (distance < best.distance) best = {a.u + t * du, a.v + t * dv, distance};
  }
  return best;
}

}  // namespace

int returnStrayKnots(KnotChain& chain, const std::vector<SigmaPoint>& points, double reach) {
  int returned = 0;
  const auto put = [&returned](ChainKnot& knot, double u, double v) {
    knot.at[0] = u;
    knot.at[1] = v;
    ++returned;
  };
  for (std::size_t k = 0; k < chain.size(); ++k) {
    const PlaceOnLine near = nearestOnLine(chain[k], points);
    if (k > 0 && k + 1 < chain.size()) {
      if (near.distance > reach) put(chain[k], near.u, near.v);
      continue;
    }
    // An end mistaken for a bottom-out may slide along a flat stretch, and the curve would lose the part
    // before it.
    const SigmaPoint& end = k == 0 ? points.front() : points.back();
    if (near.distance > reach || std::abs(chain[k].u() - end.u) > reach) put(chain[k], end.u, end.v);
  }
  if (returned > 0) {
    // Knots beyond an end would move the end when they are sorted.
    const auto [low, high] = std::minmax({chain.front().u(), chain.back().u()});
    for (ChainKnot& knot : chain) knot.at[0] = std::clamp(knot.u(), low, high);
    levelDisplacements(chain);
    dropRedundantKnots(chain);
  }
  return returned;
}

}  // namespace detent::importer
