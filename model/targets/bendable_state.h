// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A deformable button state: few unknowns move its landmarks and the curve between them.

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "model/button.h"
#include "model/sections.h"
#include "model/targets/quadratic_program.h"

namespace detent {

/// Properties that a deformed state keeps. Each can be the reason why a figure cannot change further.
enum class ShapeRule {
  onStroke,      ///< operating and reset point stay on their strokes
  inOrder,       ///< the contact opens no deeper than it closes
  releaseBelow,  ///< the release stays below the press where it was below
  noPull,        ///< forces stay above 0 where they were
  tactile,       ///< a tactile point keeps its prominence
  mainEvent,     ///< the tactile point with the largest drop stays the largest, later ones stay beyond it
  width,         ///< knots keep their order, and a stretch keeps some width
  direction,     ///< rising stays rising, falling stays falling
  bottomOut,     ///< a bottom-out at the end stays one, and nothing else becomes one
};

/// Part of the curve that an unknown moves.
enum class Moved {
  landmark,    ///< a landmark of the press, before the bottom-out
  stopTravel,  ///< the start of the bottom-out or the end of a stroke, in displacement
  stopForce,   ///< the same in force
  bulge,       ///< a bulge of the press
  release,     ///< a landmark of the release, before the bottom-out
  releaseBulge,
  contact
};

/// Landmarks are the ends of the strokes, every tactile point with the valley or hump after it, and the start
/// of the bottom-out. Moving one stretches the curve to its neighbours in proportion; the curve between them
/// can also bulge. Unknowns are shares of the travel and of the force range below the bottom-out, initially
/// 0. The start of the travel is fixed; ends and bottom-out starts at which the strokes meet move together,
/// as do the two knots of a vertical piece. Any thread.
class BendableState {
 public:
  /// Stretches at which a curve may bulge.
  enum class Bulges {
    atKnots,  ///< only at the curve's own knots
    finer     ///< also in the middle of a stretch without knots
  };
  /// Movement of the operating and the reset point.
  enum class Contacts {
    free,   ///< contacts move by themselves
    riding  ///< contacts keep their place on the curve
  };
  BendableState(const ButtonState& state, const SectionSettings& settings, Bulges bulges, Contacts contacts);

  Eigen::Index unknowns() const { return unknowns_; }
  /// One entry for each unknown.
  const std::vector<Moved>& moved() const { return moved_; }
  /// Removes all other unknowns; their parts of the curve stay.
  void keepOnly(const std::vector<Eigen::Index>& unknowns);
  /// Inverse of the cost matrix. Moving a landmark or contact by the whole travel or force range costs 1;
  /// bulges cost by their steepness.
  const Eigen::MatrixXd& inverseCost() const { return inverseCost_; }
  /// nullopt if it is no curve any more, or a contact would leave its stroke.
  std::optional<ButtonState> at(const Eigen::VectorXd& z) const;
  struct Rule {
    LinearRule linear;
    ShapeRule kind;
  };
  /// All linear rules, without releaseBelow (see gaps()) and the rule of the bottom-out.
  const std::vector<Rule>& rules() const { return rules_; }
  /// Distance of the release below the press, N, at the places where it was not above at first. The rule
  /// holds while none is negative.
  Eigen::VectorXd gaps(const Eigen::VectorXd& z, const ButtonState& bent) const;

  double travel_mm() const { return travel_mm_; }
  double range_N() const { return range_N_; }

 private:
  // A knot that is moved; knots between two handles follow in proportion.
  struct Handle {
    std::size_t knot;
    bool landmark;
  };
  struct Line {
    std::vector<Knot> knots;
    std::vector<Handle> handles;
    Eigen::MatrixXd mm, N;  // unknowns to moves of the handles, in shares
  };
  struct Unknowns;

  Line lineOf(const StrokeCurve& curve, Stroke stroke, Bulges bulges) const;
  void spread(Line& line, const std::vector<Eigen::Index>& mm, const std::vector<Eigen::Index>& N,
              Moved bulge, Unknowns& unknowns);
  void addLine(Line& line, const Line* met, Unknowns& unknowns);
  void addRulesOf(const Line& line);
  void addRulesOfEvents(const Line& line, const StrokeCurve& press);
  void addRulesOfContacts();
  void findGaps();
  void addRule(ShapeRule kind, const Eigen::RowVectorXd& row, double bound);
  Eigen::RowVectorXd contactMoves(const Line& line, std::optional<double> at_mm, Contacts contacts,
                                  Unknowns& unknowns) const;
  std::optional<StrokeCurve> bent(const Line& line, const Eigen::VectorXd& z) const;
  std::size_t handleAt(const Line& line, CurvePoint place) const;

  ButtonState state_;
  SectionSettings settings_;
  double travel_mm_ = 1, range_N_ = 1;
  Eigen::Index unknowns_ = 0;
  std::vector<Moved> moved_;
  Line press_;
  std::optional<Line> release_;
  Eigen::RowVectorXd operating_, reset_;  // unknowns to moves of the contacts, in shares
  Eigen::MatrixXd cost_, inverseCost_;
  std::vector<Rule> rules_;
  std::vector<std::size_t> pressGaps_, releaseGaps_;  // handles at which the release was not above the press
};

}  // namespace detent
