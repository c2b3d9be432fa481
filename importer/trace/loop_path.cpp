// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/loop_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace detent::importer::trace {

namespace {

constexpr int kDirections = LiftedSearch::kDirections;
constexpr int kDown = 0, kUp = kDirections - 1;
constexpr float kUnreached = -1e30F;         // gain
constexpr float kNever = 0.5F * kUnreached;  ///< at or below: no path leads here

enum From : std::uint8_t { kStart, kMove, kTurnFromLower, kTurnFromHigher, kAsArrived, kRun };

struct GridStep {
  int dx, dy;  ///< dy in raster coordinates, down is positive
};

/// Ordered by angle from straight down to straight up.
constexpr std::array<GridStep, kDirections> kSteps{
    {{0, 1},  {1, 5},  {1, 3},  {1, 2},  {2, 3},  {1, 1},  {3, 2},  {2, 1},  {3, 1},  {5, 1}, {1, 0},
     {5, -1}, {3, -1}, {2, -1}, {3, -2}, {1, -1}, {2, -3}, {1, -2}, {1, -3}, {1, -5}, {0, -1}}};

/// Subtracted per pixel on a steep way down, so that going up and down the same steep line does not earn
/// twice. A true steep drop is still cheaper than any detour.
constexpr float kSteepFall = 1.3F;

struct Moves {
  std::array<std::array<GridStep, 5>, kDirections>
      pixels{};  ///< passed pixels as offsets back from the step's end, end first
  std::array<int, kDirections> count{};
  std::array<float, kDirections> weight{};  ///< path length per pixel passed
  std::array<float, kDirections> fall{};    ///< price per pixel of a steep fall
  std::array<float, kDirections> turn{};    ///< angle to the next higher direction, radian

  Moves() {
    for (std::size_t d = 0; d < kDirections; ++d) {
      const GridStep s = kSteps[d];
      const int n = std::max(s.dx, std::abs(s.dy));
      count[d] = n;
      weight[d] = static_cast<float>(std::hypot(s.dx, s.dy) / n);
      fall[d] = s.dy >= 3 * s.dx ? (s.dy >= 5 * s.dx ? kSteepFall : kSteepFall / 2) : 0.0F;
      for (int i = 0; i < n; ++i) {
        pixels[d][static_cast<std::size_t>(i)] = {static_cast<int>(std::lround(double(s.dx) * i / n)),
                                                  static_cast<int>(std::lround(double(s.dy) * i / n))};
      }
      if (d + 1 < kDirections) {
        const GridStep next = kSteps[d + 1];
        turn[d] = static_cast<float>(std::atan2(-next.dy, next.dx) - std::atan2(-s.dy, s.dx));
      }
    }
  }
};

const Moves& moves() {
  static const Moves table;
  return table;
}

/// Distributes gains over the directions of one node at the price of the turns.
void turn(float* score, std::uint8_t* from, float price) {
  const Moves& m = moves();
  for (std::size_t d = 1; d < kDirections; ++d) {
    const float turned = score[d - 1] - price * m.turn[d - 1];
    if (turned > score[d]) {
      score[d] = turned;
      from[d] = kTurnFromLower;
    }
  }
  for (std::size_t d = kDirections - 1; d-- > 0;) {
    const float turned = score[d + 1] - price * m.turn[d];
    if (turned > score[d]) {
      score[d] = turned;
      from[d] = kTurnFromHigher;
    }
  }
}

}  // namespace

LiftedSearch::LiftedSearch(const Plane& open, const PathOptions& options)
    : width_(open.width), height_(open.height), options_(options) {
  index_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), -1);
  columnStart_.reserve(static_cast<std::size_t>(width_) + 1);
  for (int x = 0; x < width_; ++x) {
    columnStart_.push_back(static_cast<int>(nodes_.size()));
    for (int y = 0; y < height_; ++y) {
      if (open.at(x, y) <= 0) continue;
      index_[static_cast<std::size_t>(x) * static_cast<std::size_t>(height_) + static_cast<std::size_t>(y)] =
          static_cast<int>(nodes_.size());
      nodes_.push_back({x, y});
    }
  }
  columnStart_.push_back(static_cast<int>(nodes_.size()));
  score_.resize(nodes_.size() * kDirections);
  arrived_.resize(nodes_.size() * kDirections);
  left_.resize(nodes_.size() * kDirections);
  runStart_.resize(nodes_.size() * 2);
  arrivalScore_.resize(static_cast<std::size_t>(height_) * 2);
  layOutSteps();
}

/// Pixels of each step in a raster of this width, as offsets back from the step's end.
void LiftedSearch::layOutSteps() {
  const Moves& m = moves();
  for (std::size_t d = 0; d < kDirections; ++d) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(m.count[d]); ++i) {
      stepPixels_[d][i] = m.pixels[d][i].dy * width_ + m.pixels[d][i].dx;
    }
  }
}

void LiftedSearch::arrive(const Plane& reward, const PathLimits& limits, int node) {
  const Moves& m = moves();
  const Node p = nodes_[static_cast<std::size_t>(node)];
  const float* here = &reward.values[static_cast<std::size_t>(p.y) * static_cast<std::size_t>(width_) +
                                     static_cast<std::size_t>(p.x)];
  const bool mayStart = p.x >= limits.startFrom && p.x <= limits.startTo;
  float* score = &score_[static_cast<std::size_t>(node) * kDirections];
  std::uint8_t* from = &arrived_[static_cast<std::size_t>(node) * kDirections];
  for (std::size_t d = 0; d < kDirections; ++d) {
    score[d] = mayStart ? 0.0F : kUnreached;
    from[d] = kStart;
    const GridStep s = kSteps[d];
    if (s.dx == 0) continue;
    const int before = indexAt(p.x - s.dx, p.y - s.dy);
    if (before < 0) continue;
    const float reached = score_[static_cast<std::size_t>(before) * kDirections + d];
    if (reached <= kNever) continue;
    float sum = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(m.count[d]); ++i) sum += here[-stepPixels_[d][i]];
    const float gain = reached + sum * m.weight[d] - m.fall[d] * static_cast<float>(m.count[d]);
    if (gain > score[d]) {
      score[d] = gain;
      from[d] = kMove;
    }
  }
  turn(score, from, static_cast<float>(options_.turnCost_px));
  std::fill_n(&left_[static_cast<std::size_t>(node) * kDirections], kDirections, kAsArrived);
}

/// Straight up or down within a column; nodes `from`..`to-1` lie in it, top to bottom. A run starts from an
/// arrival, never from another run, so that a path cannot go up and down the same steep line for gain.
void LiftedSearch::runAlongColumn(const Plane& reward, int from, int to, int direction) {
  const bool up = direction == kUp;
  const auto d = static_cast<std::size_t>(direction);
  const std::size_t side = up ? 1 : 0;
  float carried = kUnreached;
  int start = -1, before = -1;
  for (int k = 0; k < to - from; ++k) {
    const int node = up ? to - 1 - k : from + k;
    const Node p = nodes_[static_cast<std::size_t>(node)];
    const bool adjacent = before >= 0 && std::abs(p.y - nodes_[static_cast<std::size_t>(before)].y) == 1;
    carried = adjacent && carried > kNever ? carried + reward.at(p.x, p.y) - moves().fall[d] : kUnreached;
    before = node;
    const float arrived = arrivalScore_[static_cast<std::size_t>(node - from) * 2 + side];
    if (carried <= arrived) {
      carried = arrived;
      start = node;
      continue;
    }
    float* score = &score_[static_cast<std::size_t>(node) * kDirections];
    std::uint8_t* left = &left_[static_cast<std::size_t>(node) * kDirections];
    runStart_[static_cast<std::size_t>(node) * 2 + side] = start;
    if (carried <= score[d]) continue;
    score[d] = carried;
    left[d] = kRun;
    turn(score, left, static_cast<float>(options_.turnCost_px));
  }
}

LiftedPath LiftedSearch::pathBackwards(int node, int direction) const {
  LiftedPath path;
  auto d = static_cast<std::size_t>(direction);
  bool arrived = false;
  const auto add = [&](int n) {
    const Node p = nodes_[static_cast<std::size_t>(n)];
    path.points.push_back({double(p.x), double(p.y)});
  };
  add(node);
  for (;;) {
    const std::vector<std::uint8_t>& codes = arrived ? arrived_ : left_;
    const std::uint8_t code = codes[static_cast<std::size_t>(node) * kDirections + d];
    if (code == kStart) break;
    if (code == kAsArrived) {
      arrived = true;
    } else if (code == kTurnFromLower) {
      --d;
    } else if (code == kTurnFromHigher) {
      ++d;
    } else if (code == kRun) {
      node = runStart_[static_cast<std::size_t>(node) * 2 + (d == kUp ? 1 : 0)];
      add(node);
      arrived = true;
    } else {
      const Node p = nodes_[static_cast<std::size_t>(node)];
      node = indexAt(p.x - kSteps[d].dx, p.y - kSteps[d].dy);
      add(node);
      arrived = false;
    }
  }
  std::reverse(path.points.begin(), path.points.end());
  return path;
}

LiftedPath LiftedSearch::best(const Plane& reward, const PathLimits& limits) {
  float best = kUnreached;
  int bestNode = -1;
  std::size_t bestDirection = 0;
  for (int x = 0; x < width_; ++x) {
    const int from = columnStart_[static_cast<std::size_t>(x)],
              to = columnStart_[static_cast<std::size_t>(x) + 1];
    for (int n = from; n < to; ++n) arrive(reward, limits, n);
    for (int n = from; n < to; ++n) {
      const float* score = &score_[static_cast<std::size_t>(n) * kDirections];
      arrivalScore_[static_cast<std::size_t>(n - from) * 2] = score[kDown];
      arrivalScore_[static_cast<std::size_t>(n - from) * 2 + 1] = score[kUp];
    }
    runAlongColumn(reward, from, to, kUp);
    runAlongColumn(reward, from, to, kDown);
    if (x < limits.endFrom || x > limits.endTo) continue;
    for (int n = from; n < to; ++n) {
      for (std::size_t d = 0; d < kDirections; ++d) {
        const float s = score_[static_cast<std::size_t>(n) * kDirections + d];
        if (s > best) {
          best = s;
          bestNode = n;
          bestDirection = d;
        }
      }
    }
  }
  if (bestNode < 0 || best <= kNever) return {};
  LiftedPath path = pathBackwards(bestNode, static_cast<int>(bestDirection));
  path.gain = best;
  return path;
}

}  // namespace detent::importer::trace
