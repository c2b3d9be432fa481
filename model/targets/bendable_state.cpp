// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/targets/bendable_state.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

#include "model/edits.h"
#include "model/metrics.h"

namespace detent {
namespace {

constexpr std::size_t mostHandles = 40;  // most handles of a stroke
constexpr double bulgeStiffness = 0.25;  // cost of a bulge relative to a landmark that moves as far
constexpr double narrowest = 0.1;        // share of its width that a piece keeps
constexpr double lowest = 0.02;          // share of its height that a rise or fall keeps
constexpr double same = 1e-9;            // shares of travel and range within which ends coincide
// share of the travel within which both strokes have one bottom-out
constexpr double sameBottomOut = 0.03;
constexpr double contactRoom = 1e-6;  // share of the travel between contacts and ends
// factor by which the range may grow before a tactile point loses its prominence
constexpr double roomToProminence = 1.25;
// share of the largest drop by which it stays ahead of the next one
constexpr double leastDropAhead = 0.01;

bool isTwin(const std::vector<Knot>& knots, std::size_t i) {
  return i > 0 && knots[i].displacement_mm == knots[i - 1].displacement_mm;
}

// Adds a level knot exactly at an extremum, so that it stays the extremum under stretching.
StrokeCurve withTurnAt(const StrokeCurve& curve, CurvePoint turn) {
  const auto inserted = insertKnot(curve, turn.displacement_mm);
  if (!inserted) return curve;
  std::vector<Knot> knots = inserted->knots();
  for (Knot& knot : knots)
    if (knot.displacement_mm == turn.displacement_mm)
      knot.slopeBefore_N_per_mm = knot.slopeAfter_N_per_mm = 0;
  const auto level = StrokeCurve::fromKnots(std::move(knots));
  return level ? *level : *inserted;
}

StrokeCurve withKnotAt(const StrokeCurve& curve, double at_mm) {
  const auto inserted = insertKnot(curve, at_mm);
  return inserted ? *inserted : curve;
}

// Factor for the slopes of a stretched piece; nullopt if the piece has no direction.
std::optional<double> slopeScale(const Knot& a, const Knot& b, const Knot& newA, const Knot& newB) {
  const double width = b.displacement_mm - a.displacement_mm,
               newWidth = newB.displacement_mm - newA.displacement_mm;
  const double rise = b.force_N - a.force_N;
  const bool oneWay = a.slopeAfter_N_per_mm * rise >= 0 && b.slopeBefore_N_per_mm * rise >= 0;
  if (!(width > 0) || !(newWidth > 0) || rise == 0 || !oneWay) return {};
  return (newB.force_N - newA.force_N) / rise * (width / newWidth);
}

struct Slopes {
  double before, after;
};

// A smooth knot stays smooth, and no piece gets ends steeper than a monotone cubic allows.
Slopes joined(const Knot& old, Slopes scaled, double chordBefore, double chordAfter) {
  if (old.slopeBefore_N_per_mm != old.slopeAfter_N_per_mm || scaled.before == scaled.after) return scaled;
  const double most = 3 * std::min(std::abs(chordBefore), std::abs(chordAfter));
  if (std::max(std::abs(scaled.before), std::abs(scaled.after)) >
      3 * std::max(std::abs(chordBefore), std::abs(chordAfter)))
    return scaled;
  const double mean = std::clamp(0.5 * (scaled.before + scaled.after), -most, most);
  return {mean, mean};
}

void reslope(const std::vector<Knot>& old, std::vector<Knot>& knots) {
  const std::size_t count = old.size();
  std::vector<double> chords(count + 1, 0);
  for (std::size_t i = 0; i + 1 < count; ++i) {
    Knot &a = knots[i], &b = knots[i + 1];
    const double width = b.displacement_mm - a.displacement_mm;
    if (!(width > 0)) continue;
    chords[i + 1] = (b.force_N - a.force_N) / width;
    if (const auto scale = slopeScale(old[i], old[i + 1], a, b)) {
      a.slopeAfter_N_per_mm = old[i].slopeAfter_N_per_mm * *scale;
      b.slopeBefore_N_per_mm = old[i + 1].slopeBefore_N_per_mm * *scale;
      continue;
    }
    const double oldWidth = old[i + 1].displacement_mm - old[i].displacement_mm;
    const double added = oldWidth > 0 ? chords[i + 1] - (old[i + 1].force_N - old[i].force_N) / width : 0;
    const double narrower = oldWidth > 0 ? oldWidth / width : 1;
    a.slopeAfter_N_per_mm = old[i].slopeAfter_N_per_mm * narrower + added;
    b.slopeBefore_N_per_mm = old[i + 1].slopeBefore_N_per_mm * narrower + added;
  }
  for (std::size_t i = 1; i + 1 < count; ++i) {
    if (isTwin(old, i) || isTwin(old, i + 1)) continue;
    const Slopes joinedSlopes = joined(old[i], {knots[i].slopeBefore_N_per_mm, knots[i].slopeAfter_N_per_mm},
                                       chords[i], chords[i + 1]);
    knots[i].slopeBefore_N_per_mm = joinedSlopes.before;
    knots[i].slopeAfter_N_per_mm = joinedSlopes.after;
  }
}

// Landmarks of a stroke, in any order.
std::vector<double> landmarksOf(const StrokeCurve& curve, Stroke stroke, const SectionSettings& settings) {
  std::vector<double> positions{curve.start_mm(), curve.end_mm()};
  const StrokeMetrics metrics = metricsOf(curve, stroke, settings);
  for (const TactileEvent& event : metrics.tactile) {
    positions.push_back(event.point.displacement_mm);
    if (event.following) positions.push_back(event.following->displacement_mm);
  }
  if (metrics.bottomOut.isSteep) positions.push_back(metrics.bottomOut.displacement_mm);
  return positions;
}

// Position of each knot in a stretch, 0 at the first and 1 at the last, by its share of the force change.
std::vector<double> climbed(const std::vector<Knot>& knots, std::size_t first, std::size_t last) {
  std::vector<double> way{0};
  double whole = 0;
  for (std::size_t i = first; i < last; ++i) whole += std::abs(knots[i + 1].force_N - knots[i].force_N);
  const double width_mm = knots[last].displacement_mm - knots[first].displacement_mm;
  double height = 0;
  for (std::size_t i = first + 1; i <= last; ++i) {
    height += std::abs(knots[i].force_N - knots[i - 1].force_N);
    const double across =
        width_mm > 0 ? (knots[i].displacement_mm - knots[first].displacement_mm) / width_mm : 1;
    way.push_back(whole > 0 ? height / whole : across);
  }
  way.back() = 1;
  return way;
}

std::vector<double> crossed(const std::vector<Knot>& knots, std::size_t first, std::size_t last) {
  std::vector<double> way;
  const double width_mm = knots[last].displacement_mm - knots[first].displacement_mm;
  for (std::size_t i = first; i <= last; ++i)
    way.push_back(width_mm > 0 ? (knots[i].displacement_mm - knots[first].displacement_mm) / width_mm : 0);
  return way;
}

// Press less release: before a vertical piece, and after one at the common start.
double gapAt(const ForceGraph& graph, double x) {
  const StrokeCurve &press = graph.press(), &release = graph.curve(Stroke::release);
  const auto force_N = [x](const StrokeCurve& curve) {
    return x > curve.start_mm() ? curve.forceBefore_N(x) : curve.force_N(curve.start_mm());
  };
  return force_N(press) - force_N(release);
}

}  // namespace

// Costs while the unknowns are being collected.
struct BendableState::Unknowns {
  struct Entry {
    Eigen::Index a, b;
    double cost;
  };
  Eigen::Index count = 0;
  std::vector<Entry> entries;
  std::vector<Moved> moved;

  Eigen::Index one(Moved what) {
    entries.push_back({count, count, 1});
    return free(what);
  }
  Eigen::Index free(Moved what) {
    moved.push_back(what);
    return count++;
  }
  // Adds a spring between two bulges; -1: a landmark without one.
  void spring(Eigen::Index a, Eigen::Index b, double cost) {
    if (a >= 0) entries.push_back({a, a, cost});
    if (b >= 0) entries.push_back({b, b, cost});
    if (a < 0 || b < 0) return;
    entries.push_back({a, b, -cost});
    entries.push_back({b, a, -cost});
  }
};

BendableState::BendableState(const ButtonState& state, const SectionSettings& settings, Bulges bulges,
                             Contacts contacts)
    : state_(state), settings_(settings) {
  const StrokeCurve& press = state.graph.press();
  travel_mm_ = press.travel_mm();
  double low_N = press.knots().front().force_N, high_N = low_N;
  const double bottomOut_mm = bottomOutOf(press, settings).displacement_mm;
  for (int i = 0; i <= 200; ++i) {
    const double force_N =
        press.forceBefore_N(press.start_mm() + (bottomOut_mm - press.start_mm()) * i / 200);
    low_N = std::min(low_N, force_N);
    high_N = std::max(high_N, force_N);
  }
  range_N_ = std::max({high_N - low_N, 0.1 * std::abs(high_N), 1e-6});

  press_ = lineOf(press, Stroke::press, bulges);
  if (const auto& release = state.graph.release()) release_ = lineOf(*release, Stroke::release, bulges);
  Unknowns unknowns;
  addLine(press_, nullptr, unknowns);
  if (release_) addLine(*release_, &press_, unknowns);
  operating_ = contactMoves(press_, state.operatingPoint_mm, contacts, unknowns);
  reset_ = contactMoves(release_ ? *release_ : press_, state.resetPoint_mm, contacts, unknowns);
  unknowns_ = unknowns.count;
  moved_ = std::move(unknowns.moved);
  for (Line* line : {&press_, release_ ? &*release_ : nullptr}) {
    if (!line) continue;
    line->mm.conservativeResizeLike(Eigen::MatrixXd::Zero(line->mm.rows(), unknowns_));
    line->N.conservativeResizeLike(Eigen::MatrixXd::Zero(line->N.rows(), unknowns_));
  }
  for (Eigen::RowVectorXd* moves : {&operating_, &reset_})
    moves->conservativeResizeLike(Eigen::RowVectorXd::Zero(unknowns_));
  cost_ = Eigen::MatrixXd::Zero(unknowns_, unknowns_);
  for (const Unknowns::Entry& entry : unknowns.entries) cost_(entry.a, entry.b) += entry.cost;
  inverseCost_ = cost_.ldlt().solve(Eigen::MatrixXd::Identity(unknowns_, unknowns_));

  addRulesOf(press_);
  if (release_) addRulesOf(*release_);
  addRulesOfEvents(press_, press);
  addRulesOfContacts();
  findGaps();
}

void BendableState::keepOnly(const std::vector<Eigen::Index>& unknowns) {
  unknowns_ = static_cast<Eigen::Index>(unknowns.size());
  for (Line* line : {&press_, release_ ? &*release_ : nullptr}) {
    if (!line) continue;
    line->mm = line->mm(Eigen::all, unknowns).eval();
    line->N = line->N(Eigen::all, unknowns).eval();
  }
  for (Eigen::RowVectorXd* moves : {&operating_, &reset_}) *moves = (*moves)(unknowns).eval();
  std::vector<Moved> moved;
  for (const Eigen::Index i : unknowns) moved.push_back(moved_[static_cast<std::size_t>(i)]);
  moved_ = std::move(moved);
  cost_ = cost_(unknowns, unknowns).eval();
  inverseCost_ = cost_.ldlt().solve(Eigen::MatrixXd::Identity(unknowns_, unknowns_));
  for (Rule& rule : rules_) rule.linear.normal = rule.linear.normal(unknowns).eval();
  std::erase_if(rules_, [](const Rule& rule) { return rule.linear.normal.squaredNorm() == 0; });
}

BendableState::Line BendableState::lineOf(const StrokeCurve& curve, Stroke stroke, Bulges bulges) const {
  std::vector<double> landmarks = landmarksOf(curve, stroke, settings_);
  StrokeCurve prepared = curve;
  std::vector<CurvePoint> turns = curve.localMaxima();
  for (const CurvePoint& turn : curve.localMinima()) turns.push_back(turn);
  for (const CurvePoint& turn : turns)
    if (turns.size() <= mostHandles / 2 ||
        std::count(landmarks.begin(), landmarks.end(), turn.displacement_mm) > 0)
      prepared = withTurnAt(prepared, turn);
  for (const double place : landmarks) prepared = withKnotAt(prepared, place);
  if (bulges == Bulges::finer) {
    std::sort(landmarks.begin(), landmarks.end());
    for (std::size_t i = 0; i + 1 < landmarks.size(); ++i)
      for (const double share : {0.25, 0.5, 0.75})
        if (landmarks[i + 1] - landmarks[i] > 0.02 * travel_mm_)
          prepared = withKnotAt(prepared, landmarks[i] + share * (landmarks[i + 1] - landmarks[i]));
  }
  Line line{prepared.knots(), {}, {}, {}};
  const std::size_t step = (line.knots.size() + mostHandles - 1) / mostHandles;
  for (std::size_t i = 0; i < line.knots.size(); ++i) {
    const bool landmark = std::count(landmarks.begin(), landmarks.end(), line.knots[i].displacement_mm) > 0;
    const bool isVertical = isTwin(line.knots, i) || (i + 1 < line.knots.size() && isTwin(line.knots, i + 1));
    if (landmark || isVertical || i % step == 0) line.handles.push_back({i, landmark || isVertical});
  }
  return line;
}

// Rows of moves: a landmark moves by its unknown; knots between move in proportion and by their bulge.
void BendableState::spread(Line& line, const std::vector<Eigen::Index>& mm,
                           const std::vector<Eigen::Index>& N, Moved bulge, Unknowns& unknowns) {
  const std::size_t count = line.handles.size();
  std::vector<Eigen::Index> bulges_mm(count, -1), bulges_N(count, -1);
  for (std::size_t i = 0; i < count; ++i) {
    if (line.handles[i].landmark) continue;
    bulges_mm[i] = unknowns.free(bulge);
    bulges_N[i] = unknowns.free(bulge);
  }
  const auto rows = static_cast<Eigen::Index>(count);
  line.mm = line.N = Eigen::MatrixXd::Zero(rows, unknowns.count);
  std::size_t left = 0;
  for (std::size_t right = 1; right < count; ++right) {
    if (!line.handles[right].landmark) continue;
    const std::size_t first = line.handles[left].knot, last = line.handles[right].knot;
    const std::vector<double> up = climbed(line.knots, first, last), along = crossed(line.knots, first, last);
    for (std::size_t i = left; i <= right; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      const std::size_t at = line.handles[i].knot - first;
      const auto put = [&](Eigen::MatrixXd& moves, const std::vector<Eigen::Index>& of, double share,
                           Eigen::Index own) {
        moves.row(row).setZero();
        if (of[left] >= 0) moves(row, of[left]) += 1 - share;
        if (of[right] >= 0) moves(row, of[right]) += share;
        if (own >= 0) moves(row, own) += 1;
      };
      put(line.mm, mm, along[at], bulges_mm[i]);
      put(line.N, N, up[at], bulges_N[i]);
      if (i == left) continue;
      const std::size_t before = line.handles[i - 1].knot - first;
      // share of the stretch; closer knots get no stiffer spring than knots at this distance
      const double least = 0.02;
      unknowns.spring(bulges_mm[i - 1], bulges_mm[i],
                      bulgeStiffness / std::max(least, along[at] - along[before]));
      unknowns.spring(bulges_N[i - 1], bulges_N[i],
                      bulgeStiffness / std::max(least, along[at] - along[before]));
    }
    left = right;
  }
}

void BendableState::addLine(Line& line, const Line* met, Unknowns& unknowns) {
  std::vector<Eigen::Index> mm(line.handles.size(), -1), N(line.handles.size(), -1);
  const auto single = [](const Eigen::MatrixXd& moves, Eigen::Index row) {
    Eigen::Index column = -1;
    moves.row(row).cwiseAbs().maxCoeff(&column);
    return moves(row, column) == 1 ? column : Eigen::Index{-1};
  };
  const double bottomOut_mm = bottomOutOf(state_.graph.press(), settings_).displacement_mm,
               stop_mm = met ? bottomOutOf(*state_.graph.release(), settings_).displacement_mm : bottomOut_mm;
  for (std::size_t i = 0; i < line.handles.size(); ++i) {
    if (!line.handles[i].landmark) continue;
    const Knot& knot = line.knots[line.handles[i].knot];
    const bool start = knot.displacement_mm == line.knots.front().displacement_mm;
    const bool twin = isTwin(line.knots, line.handles[i].knot);
    for (std::size_t k = 0; met && k < met->handles.size(); ++k) {
      const Knot& other = met->knots[met->handles[k].knot];
      const double apart = std::abs(other.displacement_mm - knot.displacement_mm) / travel_mm_;
      const bool ends = (i == 0 && k == 0) || (i + 1 == line.handles.size() && k + 1 == met->handles.size());
      const bool atBottomOut = i > 0 && other.displacement_mm == bottomOut_mm && met->handles[k].landmark &&
                               apart < sameBottomOut && i + 1 < line.handles.size() &&
                               stop_mm == knot.displacement_mm;
      if ((ends && apart < same) || atBottomOut) {
        if (!start) mm[i] = single(met->mm, static_cast<Eigen::Index>(k));
        if (ends && std::abs(other.force_N - knot.force_N) < same * range_N_)
          N[i] = single(met->N, static_cast<Eigen::Index>(k));
      }
    }
    if (twin && i > 0) mm[i] = mm[i - 1];
    const bool stop = i > 0 && knot.displacement_mm >= stop_mm;
    const Moved before = met ? Moved::release : Moved::landmark;
    if (!start && mm[i] < 0) mm[i] = unknowns.one(stop ? Moved::stopTravel : before);
    if (N[i] < 0) N[i] = unknowns.one(stop ? Moved::stopForce : before);
  }
  spread(line, mm, N, met ? Moved::releaseBulge : Moved::bulge, unknowns);
}

// Rows for the contacts. At a corner a contact that moves by itself has a different slope on each side, and
// no solve can leave it.
Eigen::RowVectorXd BendableState::contactMoves(const Line& line, std::optional<double> at_mm,
                                               Contacts contacts, Unknowns& unknowns) const {
  if (!at_mm) return {};
  const auto handle_mm = [&](std::size_t i) { return line.knots[line.handles[i].knot].displacement_mm; };
  for (std::size_t i = 1; contacts == Contacts::riding && i < line.handles.size(); ++i) {
    const double wide_mm = handle_mm(i) - handle_mm(i - 1);
    if (!(wide_mm > 0) || *at_mm > handle_mm(i)) continue;
    const double share = (*at_mm - handle_mm(i - 1)) / wide_mm;
    const auto row = static_cast<Eigen::Index>(i);
    return (1 - share) * line.mm.row(row - 1) + share * line.mm.row(row);
  }
  const Eigen::Index own = unknowns.one(Moved::contact);
  Eigen::RowVectorXd moves = Eigen::RowVectorXd::Zero(unknowns.count);
  moves[own] = 1;
  return moves;
}

void BendableState::addRule(ShapeRule kind, const Eigen::RowVectorXd& row, double bound) {
  if (row.squaredNorm() > 0) rules_.push_back({{row.transpose(), bound, false}, kind});
}

void BendableState::addRulesOf(const Line& line) {
  bool positive = true;
  for (const Knot& knot : line.knots) positive = positive && knot.force_N >= 0;
  for (std::size_t i = 0; i < line.handles.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const Knot& at = line.knots[line.handles[i].knot];
    if (positive) addRule(ShapeRule::noPull, line.N.row(row), -at.force_N / range_N_);
    if (i == 0) continue;
    const Knot& before = line.knots[line.handles[i - 1].knot];
    const double widthShare = (at.displacement_mm - before.displacement_mm) / travel_mm_;
    if (widthShare > 0)
      addRule(ShapeRule::width, line.mm.row(row) - line.mm.row(row - 1), (narrowest - 1) * widthShare);
    const double rise = (at.force_N - before.force_N) / range_N_;
    if (std::abs(rise) < same) continue;
    const double sign = rise > 0 ? 1 : -1;
    addRule(ShapeRule::direction, sign * (line.N.row(row) - line.N.row(row - 1)),
            (lowest - 1) * std::abs(rise));
  }
}

std::size_t BendableState::handleAt(const Line& line, CurvePoint place) const {
  std::size_t best = line.handles.size();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < line.handles.size(); ++i) {
    const Knot& knot = line.knots[line.handles[i].knot];
    if (knot.displacement_mm != place.displacement_mm) continue;
    if (const double apart = std::abs(knot.force_N - place.force_N); apart < least) {
      least = apart;
      best = i;
    }
  }
  return best;
}

void BendableState::addRulesOfEvents(const Line& line, const StrokeCurve& press) {
  struct Event {
    Eigen::RowVectorXd peak, drop;
    double peak_N, drop_N;
  };
  std::vector<Event> events;
  for (const TactileEvent& event : metricsOf(press, Stroke::press, settings_).tactile) {
    if (!event.following) continue;
    const CurvePoint peak{event.point.displacement_mm, event.point.force_N};
    const std::size_t top = handleAt(line, peak), valley = handleAt(line, *event.following);
    if (top == line.handles.size() || valley == line.handles.size()) continue;
    const Eigen::RowVectorXd up = line.N.row(static_cast<Eigen::Index>(top));
    events.push_back({up, up - line.N.row(static_cast<Eigen::Index>(valley)), peak.force_N / range_N_,
                      (peak.force_N - event.following->force_N) / range_N_});
  }
  for (const Event& event : events)
    addRule(ShapeRule::tactile, event.drop,
            std::min(event.drop_N, roomToProminence * settings_.minProminenceOfSpan) - event.drop_N);
  for (std::size_t i = 0; i + 1 < events.size(); ++i) {
    const double higher = events[i + 1].peak_N - events[i].peak_N;
    if (higher > 0) addRule(ShapeRule::mainEvent, events[i + 1].peak - events[i].peak, (lowest - 1) * higher);
  }
  const auto main = std::max_element(events.begin(), events.end(),
                                     [](const Event& a, const Event& b) { return a.drop_N < b.drop_N; });
  for (auto event = events.begin(); event != events.end(); ++event) {
    if (event == main) continue;
    const double ahead = main->drop_N - event->drop_N;
    addRule(ShapeRule::mainEvent, main->drop - event->drop,
            std::min(leastDropAhead * main->drop_N, ahead) - ahead);
  }
}

void BendableState::addRulesOfContacts() {
  const auto within = [&](const Eigen::RowVectorXd& moves, double at_mm, const Line& line) {
    const double fromStart = (at_mm - line.knots.front().displacement_mm) / travel_mm_;
    const double toEnd = (line.knots.back().displacement_mm - at_mm) / travel_mm_;
    addRule(ShapeRule::onStroke, moves, std::min(contactRoom, fromStart) - fromStart);
    addRule(ShapeRule::onStroke, line.mm.row(line.mm.rows() - 1) - moves,
            std::min(contactRoom, toEnd) - toEnd);
  };
  if (state_.operatingPoint_mm) within(operating_, *state_.operatingPoint_mm, press_);
  if (state_.resetPoint_mm) within(reset_, *state_.resetPoint_mm, release_ ? *release_ : press_);
  if (!state_.operatingPoint_mm || !state_.resetPoint_mm) return;
  const double differential = (*state_.operatingPoint_mm - *state_.resetPoint_mm) / travel_mm_;
  if (differential >= 0) addRule(ShapeRule::inOrder, operating_ - reset_, -differential);
}

void BendableState::findGaps() {
  if (!release_) return;
  const StrokeCurve &press = state_.graph.press(), &release = *state_.graph.release();
  // displacement from which a tiny movement changes the force by any amount
  double vertical_mm = std::numeric_limits<double>::infinity();
  for (const StrokeCurve* curve : {&press, &release})
    if (const BottomOut bottomOut = bottomOutOf(*curve, settings_); bottomOut.isSteep)
      vertical_mm = std::min(vertical_mm, bottomOut.displacement_mm);
  const double from_mm = std::max(press.start_mm(), release.start_mm());
  const double to_mm = std::min({press.end_mm(), release.end_mm(), vertical_mm});
  const auto below = [&](const Line& line, std::vector<std::size_t>& found) {
    for (std::size_t i = 0; i < line.handles.size(); ++i) {
      const double x = line.knots[line.handles[i].knot].displacement_mm;
      if (isTwin(line.knots, line.handles[i].knot) || x < from_mm || x > to_mm) continue;
      if (gapAt(state_.graph, x) >= -same * range_N_) found.push_back(i);
    }
  };
  below(press_, pressGaps_);
  below(*release_, releaseGaps_);
}

Eigen::VectorXd BendableState::gaps(const Eigen::VectorXd& z, const ButtonState& bent) const {
  Eigen::VectorXd gaps(static_cast<Eigen::Index>(pressGaps_.size() + releaseGaps_.size()));
  Eigen::Index next = 0;
  const auto measure = [&](const Line& line, const std::vector<std::size_t>& handles) {
    for (const std::size_t i : handles) {
      const double x = line.knots[line.handles[i].knot].displacement_mm +
                       travel_mm_ * line.mm.row(static_cast<Eigen::Index>(i)).dot(z);
      gaps[next++] = gapAt(bent.graph, x);
    }
  };
  measure(press_, pressGaps_);
  if (release_) measure(*release_, releaseGaps_);
  return gaps;
}

std::optional<StrokeCurve> BendableState::bent(const Line& line, const Eigen::VectorXd& z) const {
  const Eigen::VectorXd mm = travel_mm_ * (line.mm * z), N = range_N_ * (line.N * z);
  std::vector<Knot> knots = line.knots;
  for (std::size_t i = 0; i + 1 < line.handles.size(); ++i) {
    const std::size_t first = line.handles[i].knot, last = line.handles[i + 1].knot;
    const auto row = static_cast<Eigen::Index>(i);
    if (last == first + 1) {
      knots[first].displacement_mm += mm[row];
      knots[first].force_N += N[row];
      continue;
    }
    const std::vector<double> up = climbed(line.knots, first, last), along = crossed(line.knots, first, last);
    for (std::size_t k = first; k < last; ++k) {
      knots[k].displacement_mm += mm[row] + along[k - first] * (mm[row + 1] - mm[row]);
      knots[k].force_N += N[row] + up[k - first] * (N[row + 1] - N[row]);
    }
  }
  knots.back().displacement_mm += mm[mm.size() - 1];
  knots.back().force_N += N[N.size() - 1];
  for (std::size_t i = 1; i < knots.size(); ++i)
    if (isTwin(line.knots, i)) knots[i].displacement_mm = knots[i - 1].displacement_mm;
  reslope(line.knots, knots);
  const auto curve = StrokeCurve::fromKnots(std::move(knots));
  if (!curve) return {};
  return *curve;
}

std::optional<ButtonState> BendableState::at(const Eigen::VectorXd& z) const {
  const auto press = bent(press_, z);
  if (!press) return {};
  std::optional<StrokeCurve> release;
  if (release_) {
    release = bent(*release_, z);
    if (!release) return {};
  }
  auto graph = ForceGraph::fromCurves(*press, std::move(release));
  if (!graph) return {};
  ButtonState next{state_.name, *std::move(graph), state_.operatingPoint_mm, state_.resetPoint_mm,
                   state_.damping};
  // Damping keeps covering the travel, and its last point does not exceed it by rounding.
  const double start_mm = press->start_mm(), longer = press->travel_mm() / travel_mm_,
               before_mm = state_.graph.press().end_mm();
  for (DampingPoint& point : next.damping) {
    if (longer == 1) continue;
    const bool within = point.displacement_mm <= before_mm;
    point.displacement_mm = start_mm + (point.displacement_mm - start_mm) * longer;
    if (within) point.displacement_mm = std::min(point.displacement_mm, press->end_mm());
  }
  if (next.operatingPoint_mm) *next.operatingPoint_mm += travel_mm_ * operating_.dot(z);
  if (next.resetPoint_mm) *next.resetPoint_mm += travel_mm_ * reset_.dot(z);
  return next;
}

}  // namespace detent
