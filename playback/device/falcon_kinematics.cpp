// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/falcon_kinematics.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace detent::playback {

namespace {

using Vector = std::array<double, 3>;
constexpr double pi = std::numbers::pi;

// Dimensions of one leg in its own plane: u away from the middle of the base, v along the base, w to the
// person.
constexpr double baseU_mm = 40, baseV_mm = -23.09;  // position of the thigh's axis
constexpr double thigh_mm = 60, shin_mm = 102.5;
constexpr double joints_mm = 11.25 + 11.25;  // between shin and thigh, and shin and handle
// offset from the end of the shin to the middle of the handle
constexpr double handleU_mm = 14.43, handleV_mm = -25;
constexpr double tilt_rad = pi / 12;  // tilt of the legs relative to the table top
constexpr Vector legs_rad{pi / 2 + tilt_rad, -pi / 6 + tilt_rad, -5 * pi / 6 + tilt_rad};

constexpr double countsPerTurn = 320 * 4, capstan_mm = 14.25, sector_mm = 110;
constexpr double zero_rad = 35 * pi / 180;  // angle of the thigh at count 0

constexpr int mostSteps = 40;
constexpr double closeEnough_mm = 1e-11, farthest_mm = 1000, stretched = 1e-6;

/// Geometry of one leg at a position of the handle.
struct Leg {
  double h_mm = 0, w_mm = 0;    ///< distances from the thigh's axis to the shin's end, before the joints
  double reach_mm = 0;          ///< length of shin and joints as projected to the leg's plane
  double lean = 0;              ///< lean of the shin out of that plane: -d reach / d v
  double cosine = 0, sine = 0;  ///< cosine and sine of the leg's direction
};

std::optional<Leg> legAt(std::size_t i, const Vector& p) {
  Leg leg;
  leg.cosine = std::cos(legs_rad[i]);
  leg.sine = std::sin(legs_rad[i]);
  const double v_mm = -leg.sine * p[0] + leg.cosine * p[1] - baseV_mm + handleV_mm;
  const double across = v_mm / shin_mm;
  if (!(std::abs(across) < 1 - stretched)) return {};
  const double along = std::sqrt(1 - across * across);
  leg.h_mm = leg.cosine * p[0] + leg.sine * p[1] - baseU_mm + handleU_mm;
  leg.w_mm = p[2];
  leg.reach_mm = joints_mm + shin_mm * along;
  leg.lean = across / along;
  return leg;
}

/// The leg closes where (h - a cos t)^2 + (w - a sin t)^2 - reach^2 is 0; this, and how it changes with the
/// place and the thigh.
struct Closure {
  double gap_mm2 = 0, byThigh_mm2 = 0;
  Vector byPlace_mm{};
};

Closure closureOf(const Leg& leg, double thigh_rad) {
  const double du = leg.h_mm - thigh_mm * std::cos(thigh_rad), dw = leg.w_mm - thigh_mm * std::sin(thigh_rad);
  const double dv = leg.reach_mm * leg.lean;
  return {du * du + dw * dw - leg.reach_mm * leg.reach_mm,
          2 * thigh_mm * (du * std::sin(thigh_rad) - dw * std::cos(thigh_rad)),
          {2 * (leg.cosine * du - leg.sine * dv), 2 * (leg.sine * du + leg.cosine * dv), 2 * dw}};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Solves x a + y b + z c = d by Cramer's rule. None if a, b, c lie in one plane.
std::optional<Vector> combination(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
  const double volume = dot(a, cross(b, c));
  if (!(std::abs(volume) > stretched * std::sqrt(dot(a, a) * dot(b, b) * dot(c, c)))) return {};
  return Vector{dot(d, cross(b, c)) / volume, dot(a, cross(d, c)) / volume, dot(a, cross(b, d)) / volume};
}

}  // namespace

double falconAngle_rad(int counts) {
  return zero_rad + counts * (2 * pi / countsPerTurn) * (capstan_mm / sector_mm);
}

std::optional<FalconAngles_rad> falconAngles_rad(const FalconPlace_mm& place_mm) {
  FalconAngles_rad angles{};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const std::optional<Leg> leg = legAt(i, place_mm);
    if (!leg) return {};
    const double distance_mm = std::hypot(leg->h_mm, leg->w_mm);
    // Law of cosines; of the two solutions, that with the knee outwards.
    const double cosine = (distance_mm * distance_mm + thigh_mm * thigh_mm - leg->reach_mm * leg->reach_mm) /
                          (2 * thigh_mm * distance_mm);
    if (!(std::abs(cosine) <= 1)) return {};
    angles[i] = std::atan2(leg->w_mm, leg->h_mm) - std::acos(cosine);
  }
  return angles;
}

std::optional<FalconPlace_mm> falconPlace_mm(const FalconAngles_rad& angles_rad,
                                             const FalconPlace_mm& near_mm) {
  FalconPlace_mm place = near_mm;
  for (int step = 0; step < mostSteps; ++step) {
    std::array<Closure, 3> legs;
    for (std::size_t i = 0; i < legs.size(); ++i) {
      const std::optional<Leg> leg = legAt(i, place);
      if (!leg) return {};
      legs[i] = closureOf(*leg, angles_rad[i]);
    }
    const auto column = [&](std::size_t k) {
      return Vector{legs[0].byPlace_mm[k], legs[1].byPlace_mm[k], legs[2].byPlace_mm[k]};
    };
    const std::optional<Vector> move =
        combination(column(0), column(1), column(2), {-legs[0].gap_mm2, -legs[1].gap_mm2, -legs[2].gap_mm2});
    if (!move) return {};
    for (std::size_t k = 0; k < place.size(); ++k) place[k] += (*move)[k];
    const double moved_mm = std::sqrt(dot(*move, *move));
    if (!(moved_mm < farthest_mm)) return {};
    if (moved_mm < closeEnough_mm) return place;
  }
  return {};
}

// A small turn dt of the thighs moves the handle by dp with N dp = -D dt. Because F dp = t dt, the torques
// are t = -D y with y N = F.
std::optional<std::array<double, 3>> falconTorques_Nm(const FalconPlace_mm& place_mm,
                                                      const std::array<double, 3>& force_N) {
  const std::optional<FalconAngles_rad> angles = falconAngles_rad(place_mm);
  if (!angles) return {};
  std::array<Closure, 3> legs;
  for (std::size_t i = 0; i < legs.size(); ++i) legs[i] = closureOf(*legAt(i, place_mm), (*angles)[i]);
  const std::optional<Vector> shares =
      combination(legs[0].byPlace_mm, legs[1].byPlace_mm, legs[2].byPlace_mm, force_N);
  if (!shares) return {};
  constexpr double mPerMm = 1e-3;
  std::array<double, 3> torques_Nm{};
  for (std::size_t i = 0; i < legs.size(); ++i) torques_Nm[i] = -mPerMm * legs[i].byThigh_mm2 * (*shares)[i];
  return torques_Nm;
}

}  // namespace detent::playback
