// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button state that can be bent: few numbers that move its landmarks and what lies between them.

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "model/button.h"
#include "model/sections.h"
#include "model/targets/quadratic_program.h"

namespace detent {

/// What a bent state has to keep. Each is a reason why a figure can go no further.
enum class ShapeRule {
  onStroke,      ///< operating and reset point stay on their strokes
  inOrder,       ///< the contact opens no deeper than where it closes
  releaseBelow,  ///< the release stays below the press where it was
  noPull,        ///< forces stay above 0 where they were
  tactile,       ///< a tactile point stays prominent enough to be one
  mainEvent,     ///< the tactile point with the largest drop stays that, later ones stay beyond it
  width,         ///< knots keep their order, and a stretch some of its width
  direction,     ///< rising stays rising, falling stays falling
  wall,          ///< a wall at the end stays one, and what is none stays none
};

/// Landmarks are the ends of the strokes, every tactile point with the valley or hump after it, and the foot of the
/// wall. Moving one stretches the curve between it and the next, in proportion; what lies between can also bulge away
/// from that. Unknowns are shares of the travel and of the force range below the bottom-out, all 0 at first. The start of
/// the travel stays; ends and feet at which the two strokes meet move as one; so do the two knots of a wall. Any thread.
class BendableState {
 public:
  /// How freely a curve may bulge.
  enum class Bulges {
    atKnots,  ///< where its own knots are
    finer     ///< also in the middle of what has no knot between two landmarks
  };
  /// How operating and reset point move.
  enum class Contacts {
    free,   ///< by themselves
    riding  ///< with the place of the curve on which they stand
  };
  BendableState(const ButtonState& state, const SectionSettings& settings, Bulges bulges, Contacts contacts);

  Eigen::Index unknowns() const { return unknowns_; }
  /// Inverse of the cost's matrix. One whole travel, or one whole force range, of a landmark, the operating or the reset
  /// point costs 1; bulges cost by their steepness.
  const Eigen::MatrixXd& inverseCost() const { return inverseCost_; }
  /// Empty where it is no curve any more, or a contact would leave the stroke.
  std::optional<ButtonState> at(const Eigen::VectorXd& z) const;
  struct Rule {
    LinearRule linear;
    ShapeRule kind;
  };
  /// All but releaseBelow, which is no line (gaps()), and wall.
  const std::vector<Rule>& rules() const { return rules_; }
  /// Where release did not lie above press at first: how far it lies below it now, in N; 0 or more is well.
  Eigen::VectorXd gaps(const Eigen::VectorXd& z, const ButtonState& bent) const;

  double travel_mm() const { return travel_mm_; }
  double range_N() const { return range_N_; }

 private:
  // A knot that is moved; those between two handles follow in proportion.
  struct Handle {
    std::size_t knot;
    bool landmark;
  };
  struct Line {
    std::vector<Knot> knots;
    std::vector<Handle> handles;
    Eigen::MatrixXd mm, N;  // unknowns to the moves of the handles, in shares
  };
  struct Unknowns;

  Line lineOf(const StrokeCurve& curve, Stroke stroke, Bulges bulges) const;
  void spread(Line& line, const std::vector<Eigen::Index>& mm, const std::vector<Eigen::Index>& N,
              Unknowns& unknowns);
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
  Line press_;
  std::optional<Line> release_;
  Eigen::RowVectorXd operating_, reset_;  // unknowns to their moves, in shares
  Eigen::MatrixXd inverseCost_;
  std::vector<Rule> rules_;
  std::vector<std::size_t> pressGaps_, releaseGaps_;  // handles at which release did not lie above press
};

}  // namespace detent
