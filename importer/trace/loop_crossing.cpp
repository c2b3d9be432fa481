// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/loop_crossing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "importer/page/polyline.h"
#include "importer/trace/scatter.h"

namespace detent::importer::trace {

namespace {

/// First and last point of a stretch where both lines touch.
struct CrossingContact {
  std::size_t upperFrom = 0, upperTo = 0, lowerFrom = 0, lowerTo = 0;
};

/// Index of the point of `line` nearest to `p` within a reach, searched from `from` on.
std::optional<std::size_t> nearestWithin(const std::vector<Point>& line, std::size_t from, Point p,
                                         double reach_px) {
  std::optional<std::size_t> nearest;
  double best = reach_px;
  for (std::size_t j = from; j < line.size() && line[j].x <= p.x + reach_px; ++j)
    if (const double d = distance(line[j], p); d < best) {
      best = d;
      nearest = j;
    }
  return nearest;
}

std::vector<CrossingContact> crossingContacts(const std::vector<Point>& upper,
                                              const std::vector<Point>& lower, double reach_px) {
  std::vector<CrossingContact> contacts;
  std::size_t lowest = 0;
  for (std::size_t i = 0; i < upper.size(); ++i) {
    while (lowest < lower.size() && lower[lowest].x < upper[i].x - reach_px) ++lowest;
    const auto j = nearestWithin(lower, lowest, upper[i], reach_px);
    if (!j) continue;
    const bool goesOn = !contacts.empty() && static_cast<double>(i - contacts.back().upperTo) <= reach_px;
    if (!goesOn) contacts.push_back({i, i, *j, *j});
    CrossingContact& last = contacts.back();
    last.upperTo = i;
    last.lowerFrom = std::min(last.lowerFrom, *j);
    last.lowerTo = std::max(last.lowerTo, *j);
  }
  return contacts;
}

/// A stretch of a line beside a contact: direction and middle by least squares, and both ends.
struct Arm {
  Point direction, middle, end, atContact;

  /// Distance of a point from the straight line of this arm.
  double beside_px(Point p) const { return std::abs(cross(direction, p - middle)); }
};

/// Arm of the points [from, to).
Arm armOf(const std::vector<Point>& line, std::size_t from, std::size_t to, bool towardsEnd) {
  const Scatter scatter(std::span<const Point>(line).subspan(from, to - from));
  Point along = scatter.along();
  if (dot(along, line[to - 1] - line[from]) < 0) along = -1.0 * along;
  return {along, scatter.middle(), towardsEnd ? line[to - 1] : line[from],
          towardsEnd ? line[from] : line[to - 1]};
}

constexpr std::size_t kFewestArmPoints = 4;  // points of an arm
constexpr double kStretched = 0.6;           // share of its length, between the ends of an arm

std::optional<Arm> armBefore(const std::vector<Point>& line, std::size_t at, double arm_px) {
  std::size_t from = at;
  for (double run = 0; from > 0 && run < arm_px; --from) run += distance(line[from], line[from - 1]);
  if (at - from < kFewestArmPoints || distance(line[from], line[at]) < kStretched * arm_px) return {};
  return armOf(line, from, at, false);
}

std::optional<Arm> armBehind(const std::vector<Point>& line, std::size_t at, double arm_px) {
  std::size_t to = at;
  for (double run = 0; to + 1 < line.size() && run < arm_px; ++to) run += distance(line[to], line[to + 1]);
  if (to - at < kFewestArmPoints || distance(line[to], line[at]) < kStretched * arm_px) return {};
  return armOf(line, at + 1, to + 1, true);
}

/// Angle between two directions, positive to the left on the page (y downwards).
double turn_deg(Point from, Point to) {
  return -std::atan2(cross(from, to), dot(from, to)) * 180 / std::numbers::pi;
}

/// A place where two lines come together and separate.
struct Meeting {
  double turn_deg = 0;     ///< angle by which each bends away from the other, the smaller one
  double through_deg = 0;  ///< angle by which a line that exchanges sides bends, the larger one
  double shift_px = 0;     ///< sideways offset of such a line behind the contact, the larger one
  double contact_px = 0;   ///< length over which the lines are one band
  double apart_px = 0;     ///< between the ends of the arms before and behind, the smaller one
};

/// Sideways offset of a line that exchanges sides, behind the contact; `arms`: before and behind.
double shiftOf(const Arm& before, const Arm& behind) {
  return std::min(before.beside_px(behind.atContact), behind.beside_px(before.atContact));
}

std::optional<Meeting> meetingAt(const CrossingContact& c, const std::vector<Point>& upper,
                                 const std::vector<Point>& lower, double arm_px) {
  const auto upperIn = armBefore(upper, c.upperFrom, arm_px), upperOut = armBehind(upper, c.upperTo, arm_px);
  const auto lowerIn = armBefore(lower, c.lowerFrom, arm_px), lowerOut = armBehind(lower, c.lowerTo, arm_px);
  if (!upperIn || !upperOut || !lowerIn || !lowerOut) return {};
  const auto apart_px = [&](const Arm& arm) { return distance(arm.end, nearestOn(lower, arm.end)); };
  Meeting m;
  m.turn_deg = std::min(turn_deg(upperIn->direction, upperOut->direction),
                        -turn_deg(lowerIn->direction, lowerOut->direction));
  m.through_deg = std::max(std::abs(turn_deg(upperIn->direction, lowerOut->direction)),
                           std::abs(turn_deg(lowerIn->direction, upperOut->direction)));
  m.shift_px = std::max(shiftOf(*upperIn, *lowerOut), shiftOf(*lowerIn, *upperOut));
  m.contact_px = distance(upper[c.upperFrom], upper[c.upperTo]);
  m.apart_px = std::min(apart_px(*upperIn), apart_px(*upperOut));
  return m;
}

/// Length of the arms at a meeting and the smallest bend: corners near by spoil long arms, noise short ones.
struct SearchPass {
  double arm;  // of the frame's diagonal
  double leastTurn_deg;
};
constexpr std::array<SearchPass, 2> kPasses{{{0.035, 8}, {0.02, 15}}};

}  // namespace

bool linesCross(const std::vector<Point>& upper, const std::vector<Point>& lower, double width_px,
                double size_px) {
  constexpr double straightThrough = 0.5;  // of the turn
  // Largest sideways shift of a crossing line, in px plus line widths; steep strokes side by side have more.
  constexpr double mostShift_px = 0.5, mostShift = 1;
  constexpr double leastContact = 1, leastApart = 2;     // in widths; touching tips have less
  constexpr double bandWidths = 1.3, bandBeyond_px = 1;  // closer lines are one band
  const std::vector<CrossingContact> contacts =
      crossingContacts(upper, lower, bandWidths * width_px + bandBeyond_px);
  return std::ranges::any_of(contacts, [&](const CrossingContact& contact) {
    return std::ranges::any_of(kPasses, [&](const SearchPass& pass) {
      const auto m = meetingAt(contact, upper, lower, pass.arm * size_px);
      return m && m->turn_deg >= pass.leastTurn_deg && m->through_deg <= straightThrough * m->turn_deg &&
             m->shift_px <= mostShift_px + mostShift * width_px && m->contact_px >= leastContact * width_px &&
             m->apart_px >= leastApart * width_px;
    });
  });
}

}  // namespace detent::importer::trace
