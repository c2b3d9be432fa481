// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button state as the simulated finger meets it: forces in evenly spaced tables, in metres, newtons and
// joules.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "model/button.h"
#include "playback/performance/lanes.h"

namespace detent::playback {

/// Displacements at which the contact closes and opens.
struct ContactPoints {
  double close_m = 0;  ///< going down
  double open_m = 0;   ///< going up, < close_m
};

/// Force of the button between its strokes: their mean, which has a potential, plus play (decision 1100),
/// which can only take energy. Immutable; any thread. Functions that a step of the plant calls are defined
/// here, so that they are inlined (docs/develop/decisions/1210-two-presses-at-once.md).
class KeyTables {
 public:
  /// A depth, with its position in the tables. `Real`: double, or several presses' (lanes.h).
  template <class Real>
  struct Place {
    Real depth_m{}, cell{}, share{};
    typename LanesOf<Real>::Index at{};  ///< cell, as the index into a table
  };

  static constexpr double stop_N_per_m = 20000;  // 20 N/mm, the end stop of docs/reference/press-forecast.md

  explicit KeyTables(const ButtonState& state);

  template <class Real>
  Place<Real> placeOf(const Real& depth_m) const {
    const Real place = clamped(depth_m / cell_m_, 0, cells);
    const auto at = LanesOf<Real>::index(place, cells - 1);
    const Real cell = LanesOf<Real>::real(at);
    return {depth_m, cell, place - cell, at};
  }

  /// Mean of press and release, N. Below 0 and beyond the end the force of the stops is included.
  template <class Real>
  Real mean_N(const Place<Real>& at) const {
    const Real inside_N = between(at, &Cell::mean_N);
    const Real outside_m = select(at.depth_m < 0, at.depth_m, at.depth_m - end_m_);
    return select(either(at.depth_m<0, at.depth_m> end_m_), inside_N + stop_N_per_m * outside_m, inside_N);
  }
  double mean_N(double depth_m) const { return mean_N(placeOf(depth_m)); }
  /// Energy stored since depth 0, J; the exact integral of mean_N.
  template <class Real>
  Real stored_J(const Place<Real>& at) const {
    const Real beyond_m = at.depth_m - end_m_;
    const Real outside_m = select(at.depth_m < 0, at.depth_m, select(beyond_m > 0, beyond_m, Real{}));
    const Real along_m = at.share * cell_m_;
    const auto [first_N, next_N] = ends(at, &Cell::mean_N);
    const Real inside_J =
        first(at, &Cell::stored_J) + along_m * (first_N + 0.5 * at.share * (next_N - first_N));
    const Real edge_N = select(at.depth_m < 0, Real{} + cells_.front().mean_N, Real{} + cells_.back().mean_N);
    return inside_J + outside_m * (edge_N + 0.5 * stop_N_per_m * outside_m);
  }
  double stored_J(double depth_m) const { return stored_J(placeOf(depth_m)); }
  /// A depth with the values that several ends of one step are compared with.
  template <class Real>
  struct Start {
    Place<Real> place;
    Real piece{}, mean_N{}, stored_J{};
  };
  template <class Real>
  Start<Real> startAt(const Real& depth_m) const {
    const Place<Real> place = placeOf(depth_m);
    return {place, pieceOf(place), mean_N(place), stored_J(place)};
  }
  /// The constant force that does the same work as mean_N between two depths.
  template <class Real>
  Real meanBetween_N(const Start<Real>& from, const Place<Real>& to) const {
    constexpr double tooClose_m = 1e-12;  // below this the difference of two energies is mostly rounding
    const Real way_m = to.depth_m - from.place.depth_m;
    const auto close = either(from.piece == pieceOf(to), size(way_m) < tooClose_m);
    const Real even_N = 0.5 * (from.mean_N + mean_N(to));
    if (all(close)) return even_N;
    return select(close, even_N, (stored_J(to) - from.stored_J) / select(close, Real{} + 1, way_m));
  }
  /// Half the distance of press and release, N, >= 0.
  template <class Real>
  Real halfWidth_N(const Place<Real>& at) const {
    return between(at, &Cell::halfWidth_N);
  }
  double halfWidth_N(double depth_m) const { return halfWidth_N(placeOf(depth_m)); }
  /// The damping of the cap itself plus the button's b(x), N·s/m.
  template <class Real>
  Real damping_Ns_per_m(const Place<Real>& at) const {
    return evenDamping_ ? Real{} + cells_.front().damping_Ns_per_m : between(at, &Cell::damping_Ns_per_m);
  }

 private:
  static constexpr int cells = 1024;
  struct Cell {
    double mean_N = 0, halfWidth_N = 0, damping_Ns_per_m = 0, stored_J = 0;
  };

  template <class Real>
  Real first(const Place<Real>& at, double Cell::*value) const {
    return LanesOf<Real>::gathered(at.at, [&](std::size_t cell) { return cells_[cell].*value; });
  }
  template <class Real>
  std::pair<Real, Real> ends(const Place<Real>& at, double Cell::*value) const {
    return {first(at, value),
            LanesOf<Real>::gathered(at.at, [&](std::size_t cell) { return cells_[cell + 1].*value; })};
  }
  /// Linear between the beginnings of two cells.
  template <class Real>
  Real between(const Place<Real>& at, double Cell::*value) const {
    const auto [begin, end] = ends(at, value);
    return begin + at.share * (end - begin);
  }
  template <class Real>
  Real pieceOf(const Place<Real>& at) const {
    return select(at.depth_m < 0, Real{} - 1, select(at.depth_m > end_m_, Real{} + cells, at.cell));
  }

  double end_m_ = 0, cell_m_ = 0;
  bool evenDamping_ = true;  ///< the same everywhere
  std::vector<Cell> cells_;  ///< values at the beginnings of the cells, and at the end of the last one
};

}  // namespace detent::playback
