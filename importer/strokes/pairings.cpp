// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/strokes/pairings.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "importer/strokes/legend.h"
#include "importer/strokes/pair_shape.h"

namespace detent::importer {
namespace {

// Log-likelihood ratios of one switch against two, or of a press alone.
constexpr double kSettled = 22;  // a person, the tracer or the legend says so
constexpr double kLikely = 12;   // their colour or their paths say so
constexpr double kOfTwo = 9;     // most plots with two curves show one switch
constexpr double kNone = 8;      // too short, falling, or a release: no press; or a curve that is no mark
constexpr double kEnds = 6;      // both end in one point
constexpr double kNameless = 2;  // a curve without a name
constexpr double kCrossed = 64;  // both cross, times the share of the travel

struct Curve {
  const CurveTrace* trace;
  CurvePath path;
  std::string label;  ///< without names that a program gives
  bool falls;

  bool isNamed() const { return namesACurve(label); }
  std::optional<Stroke> stroke() const { return trace->stroke ? trace->stroke : strokeNamedBy(label); }
};

/// Returns true for what no strokes of one switch do.
bool isContradicted(const PairShape& shape, bool oneColour) {
  constexpr double early = 0.1;  // share of the travel: a release begins where the press ends
  // Two bottom-outs in colours of their own: shares of the box; 449 drawn pairs have a gap of 0.005 at most.
  constexpr double height = 0.12, beside = 0.01;
  // A scaled copy is another sample's press, because friction scales nothing: share of the difference that a
  // scale explains, 0.84 at most in pairs that stay open; share of the box, 0.007 at most in pairs of one shape
  constexpr double alike = 0.9, open = 0.015;
  // Friction delays a switch, so its release drops at less displacement: share of the travel; 192 pairs have
  // 0.035 at most, a named dome more.
  constexpr double late = 0.05;
  // The release of a key that locks covers part of the travel, down to the force at rest: share of the travel;
  // share of the box.
  constexpr double inPart = 0.6, atRest = 0.1;
  const double later = shape.above >= shape.below ? shape.dropsLater : -shape.dropsLater;
  return std::abs(shape.reachesApart) > early || later < -late ||
         (shape.startsApart > inPart && shape.startForces > atRest) ||
         (shape.gap > open && shape.oneShape > alike) ||
         (!oneColour && shape.gap > beside && std::abs(shape.topsApart) > height);
}

/// Evidence for each cover's parts, by the curves' places in the list.
class Competition {
 public:
  explicit Competition(const std::vector<CurveTrace>& traces) {
    for (std::size_t i = 0; i < traces.size(); ++i) {
      const CurveTrace& trace = traces[i];
      if (trace.points_px.size() < 2) continue;
      CurvePath path(trace);
      const bool falls = onlyFalls(path);
      curves_.push_back({&trace, std::move(path), trace.label, falls});
      places_.push_back(i);
      widest_px_ = std::max(widest_px_, curves_.back().path.room_px.width());
    }
    const auto byProgram = [](const Curve& c) { return isDefaultName(c.label) && !c.trace->stroke; };
    if (std::ranges::all_of(curves_, byProgram))
      for (Curve& curve : curves_) curve.label.clear();
    strokesNamed_ =
        std::ranges::any_of(curves_, [](const Curve& c) { return strokeNamedBy(c.label).has_value(); });
    named_ = std::ranges::count_if(curves_, [](const Curve& c) { return c.isNamed(); });
    rivals_ = std::ranges::count_if(curves_, [&](const Curve& c) { return !mayBeMark(c); });
  }

  std::size_t size() const { return curves_.size(); }
  std::size_t placeOf(std::size_t i) const { return places_[i]; }

  Evidence pair(std::size_t i, std::size_t j) const {
    const Curve &a = curves_[i], &b = curves_[j];
    Evidence sum;
    const auto add = [&](const char* name, double odds) {
      if (odds != 0) sum.addCounted(name, {}, odds);
    };
    add("two", rivals_ == 2 && !mayBeMark(a) && !mayBeMark(b) ? kOfTwo : 0);
    legend(a, b, add);
    const PairShape shape = shapeOf(a.path, b.path);
    // shares of the box; 95 of 100 drawn pairs have 0.005, 0.01 and 0.02 at most
    constexpr double gap = 0.02, reach = 0.05, tops = 0.06;
    constexpr double crossing = 0.08;  // share of the travel
    const double apart =
        std::max({shape.gap / gap, std::abs(shape.reachesApart) / reach, std::abs(shape.topsApart) / tops});
    const double crossed = std::min(shape.farAbove, shape.farBelow);
    const bool oneColour = a.trace->color == b.trace->color;
    const bool contradicted =
        isContradicted(shape, oneColour) || (!oneColour && apart > 1 && crossed > crossing);
    add("ends", contradicted ? -kLikely : kEnds * std::max(1 - apart, rivals_ == 2 ? 0 : -1.5));
    add("crossed", -kCrossed * crossed);
    return sum;
  }

  Evidence alone(std::size_t i) const {
    const Curve& curve = curves_[i];
    constexpr double leastWidth = 0.4;  // share of the widest curve: shorter ones are marks
    Evidence sum;
    if (size() == 1) return sum;
    if (strokeNamedBy(curve.label) == Stroke::release || isParted(curve))
      sum.addCounted("stroke", {}, -kNone);
    // Beside a stroke's name another name of two is a misread one.
    const bool misread = rivals_ == 2 && strokesNamed_ && !strokeNamedBy(curve.label);
    const bool named = curve.isNamed() && !misread;
    const bool narrow = curve.path.room_px.width() < leastWidth * widest_px_;
    if (named ? curve.falls && !strokesNamed_ : curve.falls || narrow) sum.addCounted("shape", {}, -kNone);
    const bool unread = !curve.trace->labelBox_px.empty() && !strokesNamed_;
    if (!named && !unread) sum.addCounted("nameless", {}, named_ > 0 ? -kNone : -kNameless);
    return sum;
  }

  Evidence mark(std::size_t i) const {
    Evidence sum;
    if (!mayBeMark(curves_[i])) sum.addCounted("mark", {}, -kNone);
    return sum;
  }

 private:
  template <class Add>
  void legend(const Curve& a, const Curve& b, const Add& add) const {
    const std::optional<Stroke> ofA = a.trace->stroke, ofB = b.trace->stroke;
    const bool oneColour = a.trace->color == b.trace->color;
    if (ofA && ofB && ofA != ofB && oneColour) return add("colour", rivals_ == 2 ? 0 : kLikely);
    if (isParted(a) || isParted(b)) return add("colour", -kSettled);
    if (ofA && ofB && ofA != ofB) return add("given", kSettled);
    if (namesOnePair(a.label, b.label)) return add("legend", kSettled);
    if (mayBeOnePair(a.label, b.label)) {
      const bool bothNamed = a.stroke() && b.stroke() && a.stroke() != b.stroke();
      return add("legend", !bothNamed ? 0 : rivals_ == 2 ? kSettled : kSettled / 2);
    }
    const bool readAlike = a.label == b.label && strokeNamedBy(a.label) && switchNamedBy(a.label).empty();
    const bool unlisted = mayNameAStroke(a.label) && mayNameAStroke(b.label) && !oneColour;
    add("legend", readAlike || (unlisted && size() == 2) ? -kLikely : -kSettled);
  }

  /// Returns true for a line that only falls, or one without a name beside the two that the legend names.
  bool mayBeMark(const Curve& curve) const {
    const bool byLegend = strokesNamed_ && (curve.falls || named_ == 2) && !curve.isNamed();
    return size() > 2 && !curve.trace->stroke && (byLegend || (curve.falls && !strokesNamed_));
  }

  /// Returns true if the tracer found both strokes of this curve's colour.
  bool isParted(const Curve& curve) const {
    return curve.trace->stroke && std::ranges::count_if(curves_, [&](const Curve& other) {
                                    return other.trace->color == curve.trace->color && other.trace->stroke;
                                  }) > 1;
  }

  std::vector<Curve> curves_;
  std::vector<std::size_t> places_;
  double widest_px_ = 0;
  bool strokesNamed_ = false;
  std::ptrdiff_t named_ = 0, rivals_ = 0;  ///< curves with names; curves that are no marks
};

/// One part of a cover: a pair, a press alone, or a mark.
struct Part {
  std::size_t first, second;  ///< equal for one curve
  bool mark = false;
  Evidence evidence = {};
  bool isWithout(unsigned taken) const { return !(taken & (1U << first)) && !(taken & (1U << second)); }
};

/// The best cover of the curves that are not taken yet.
struct Cover {
  double total = 0;
  std::vector<const Part*> parts = {};
};

Cover bestCover(const std::vector<Part>& parts, std::size_t curves, const Part* without) {
  std::map<unsigned, Cover> known;
  const std::function<Cover(unsigned)> rest = [&](unsigned taken) {
    std::size_t first = 0;
    while (first < curves && (taken & (1U << first))) ++first;
    if (first == curves) return Cover{};
    if (const auto kept = known.find(taken); kept != known.end()) return kept->second;
    Cover best{-std::numeric_limits<double>::infinity()};
    for (const Part& part : parts) {
      if (part.first != first || &part == without || !part.isWithout(taken)) continue;
      Cover cover = rest(taken | 1U << part.first | 1U << part.second);
      cover.total += part.evidence.total();
      cover.parts.push_back(&part);
      if (cover.total > best.total) best = std::move(cover);
    }
    return known[taken] = best;
  };
  return rest(0);
}

}  // namespace

double confidenceOf(const Pairing& pairing) {
  const bool isSwitch = pairing.evidence.total() > (pairing.other ? 0 : -kNone);
  return isSwitch ? std::tanh(std::max(0.0, pairing.margin) / 2) : 0;
}

std::vector<Pairing> bestPairings(const std::vector<CurveTrace>& traces) {
  constexpr std::size_t most = 12;  // curves; charts with more are no datasheet's
  const Competition competition(traces);
  const std::size_t n = competition.size();
  if (n == 0 || n > most) return {};
  std::vector<Part> parts;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) parts.push_back({i, j, false, competition.pair(i, j)});
    parts.push_back({i, i, false, competition.alone(i)});
    if (n > 2) parts.push_back({i, i, true, competition.mark(i)});
  }
  const Cover best = bestCover(parts, n, nullptr);
  std::vector<Pairing> switches;
  for (const Part* part : best.parts) {
    if (part->mark && part->evidence.total() < 0) return {};  // a curve that is nothing known
    if (part->mark) continue;
    Pairing each{competition.placeOf(part->first), {}, part->evidence};
    if (part->first != part->second) each.other = competition.placeOf(part->second);
    each.margin = best.total - bestCover(parts, n, part).total;
    switches.push_back(std::move(each));
  }
  return switches;
}

}  // namespace detent::importer
