// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One formula for one press and for two at once. Each of two is computed with the same operations as one
// alone, so the result is equal to the last bit and takes little more time than one
// (docs/develop/decisions/1210-two-presses-at-once.md).

#include <cmath>
#include <cstddef>

namespace detent::playback {

/// Two numbers side by side, of two presses.
using Two = double __attribute__((vector_size(16)));
/// Result of a comparison: all bits are set where it is true.
using TwoTrue = decltype(Two{} < Two{});

inline double select(bool which, double yes, double no) { return which ? yes : no; }
inline Two select(TwoTrue which, Two yes, Two no) { return which ? yes : no; }
inline bool allOf(bool a, bool b) { return a && b; }
inline TwoTrue allOf(TwoTrue a, TwoTrue b) { return a & b; }
inline bool either(bool a, bool b) { return a || b; }
inline TwoTrue either(TwoTrue a, TwoTrue b) { return a | b; }
inline bool all(bool which) { return which; }
inline bool all(TwoTrue which) { return (which[0] & which[1]) != 0; }
inline bool any(bool which) { return which; }
inline bool any(TwoTrue which) { return (which[0] | which[1]) != 0; }

template <class Real>
Real size(const Real& x) {
  return select(x < 0, -x, x);
}
template <class Real>
Real clamped(const Real& x, double low, double high) {
  return select(x < low, Real{} + low, select(x > high, Real{} + high, x));
}

/// Reads a table for each lane.
template <class Real>
struct LanesOf;
template <>
struct LanesOf<double> {
  using Index = std::size_t;
  /// x >= 0, truncated to a whole number, at most `most`.
  static Index index(double x, int most) {
    const int cut = static_cast<int>(x);
    return static_cast<Index>(cut < most ? cut : most);
  }
  static double real(Index i) { return static_cast<double>(static_cast<int>(i)); }
  template <class Read>
  static double gathered(Index i, const Read& read) {
    return read(i);
  }
};
template <>
struct LanesOf<Two> {
  struct Index {
    std::size_t first = 0, second = 0;
  };
  static Index index(Two x, int most) {
    return {LanesOf<double>::index(x[0], most), LanesOf<double>::index(x[1], most)};
  }
  static Two real(Index i) { return Two{LanesOf<double>::real(i.first), LanesOf<double>::real(i.second)}; }
  template <class Read>
  static Two gathered(Index i, const Read& read) {
    return Two{read(i.first), read(i.second)};
  }
};

}  // namespace detent::playback
