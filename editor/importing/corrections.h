// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The user's corrections of one graph of the import dialogue, as they appear on the page: ticks with values,
// corners, units, colours, masks. The importer takes the same as ImportHints.

#include <array>
#include <optional>
#include <QString>
#include <string>
#include <vector>

#include "importer/importer.h"

namespace detent::editor {

/// Corners of a plot frame in page units: top left, top right, bottom right, bottom left of the upright
/// graph.
using FrameCorners = std::array<importer::Point, 4>;

enum class GraphAxis { x, y };

/// A place on an axis and its value.
struct AxisTick {
  importer::Point at;  ///< page units, on or beside the axis' edge of the frame
  double value = 0;    ///< in the axis' unit
  friend bool operator==(const AxisTick&, const AxisTick&) = default;
};

/// Scale of one axis by hand: by the values at its two ends, or by ticks. Empty: as found.
struct AxisCorrection {
  std::optional<double> min, max;  ///< at the frame's left/bottom and right/top edge
  /// if there are ticks, min and max are empty, because the ticks define the scale
  std::vector<AxisTick> ticks;
  bool empty() const { return !min && !max && ticks.empty(); }
  friend bool operator==(const AxisCorrection&, const AxisCorrection&) = default;
};

/// The user's correction of a named point: moved, added (`from` empty) or removed (`to` empty). There is at
/// most one operating point and one reset point; for those only `to` counts.
struct MarkCorrection {
  enum class Kind { tactile, operating, reset } kind = Kind::tactile;
  Stroke stroke = Stroke::press;            ///< stroke of a tactile point
  std::optional<importer::Point> from, to;  ///< page units
  friend bool operator==(const MarkCorrection&, const MarkCorrection&) = default;
};

/// The given values of one graph; a value that is not given is found. Plain value.
struct Corrections {
  std::optional<FrameCorners> frame;
  AxisCorrection x, y;
  std::optional<LengthUnit> xUnit;
  std::optional<ForceUnit> yUnit;
  std::optional<importer::Rgb> pressColor, releaseColor;
  importer::DrawnStrokes drawn;      ///< page units
  std::vector<importer::Box> masks;  ///< page units
  std::vector<MarkCorrection>
      marks;  ///< in the order given; they are no hints, but applied to the result (mark_corrections.h)
  bool swapStrokes = false;
  bool noRelease = false;                   ///< the page shows no release of this button
  bool xIsOther = false, yIsOther = false;  ///< the axis measures another quantity: nothing can be imported
  std::string
      /// the switch to be taken if the plot shows several, as StrokeHints::curve; empty: the only one
      curve;
  std::optional<double> dpi;  ///< (0, 1200]
  friend bool operator==(const Corrections&, const Corrections&) = default;

  const AxisCorrection& axis(GraphAxis which) const { return which == GraphAxis::x ? x : y; }
  AxisCorrection& axis(GraphAxis which) { return which == GraphAxis::x ? x : y; }
};

/// Values at the two ends of an axis.
struct AxisEnds {
  double min = 0, max = 0;
};

/// Position of a point along an axis: 0 at the left/bottom edge, 1 at the right/top one, in the frame's
/// perspective. Any finite point; corners must enclose an area (else empty).
std::optional<double> shareAlong(GraphAxis axis, const FrameCorners& corners, importer::Point at);
/// The place with this share on the axis' edge of the frame.
importer::Point placeAlong(GraphAxis axis, const FrameCorners& corners, double share);

/// Converts given ends to ticks at the ends of the axis, so that other ticks can be added. Without corners
/// the ends are lost.
void endsToTicks(AxisCorrection& axis, GraphAxis which, const std::optional<FrameCorners>& corners);

/// Gives an axis the values at one or both of its ends, in the axis' unit. Ticks that are given already stay;
/// an end is then one more tick, and replaces one at its place. Without corners the ticks are dropped.
void giveEnds(AxisCorrection& axis, GraphAxis which, std::optional<double> min, std::optional<double> max,
              const std::optional<FrameCorners>& corners);

/// The ends that given ticks define. If all given ticks agree with the scale that was found, it is kept:
/// `foundEnds` are two ticks at the ends of that scale, or none. Otherwise the line through the given ticks,
/// by least squares; a single given tick is joined with the farthest found one. Nothing if that leaves fewer
/// than two places or two equal ones.
std::optional<AxisEnds> endsFromTicks(GraphAxis axis, const FrameCorners& corners,
                                      const std::vector<AxisTick>& given, const std::vector<AxisTick>& found,
                                      const std::vector<AxisTick>& foundEnds = {});

/// Axes that the importer found, for turning corrections into hints.
struct FoundAxes {
  FrameCorners corners;
  std::vector<AxisTick> xTicks, yTicks;          ///< those that agreed with the progression
  std::vector<AxisTick> xEnds = {}, yEnds = {};  ///< at the ends of the axis; empty if none was found
};

/// Hints for the importer. Given ticks become the values at the frame's edges: of the given frame, else of
/// the found one. Without a frame they have no effect yet.
importer::ImportHints hintsFrom(const Corrections& corrections, const std::optional<FoundAxes>& found);

/// Undo by value for one graph: every state the corrections have been in, with the label of the step that led
/// there. Steps that change nothing are dropped; steps with the same non-empty key directly after each other
/// become one.
class CorrectionHistory {
 public:
  const Corrections& now() const { return steps_[at_].value; }
  /// False if nothing changed.
  bool apply(const Corrections& next, const QString& label, const QString& mergeKey = {});
  bool canUndo() const { return at_ > 0; }
  bool canRedo() const { return at_ + 1 < steps_.size(); }
  void undo();
  void redo();
  QString undoLabel() const { return canUndo() ? steps_[at_].label : QString(); }
  QString redoLabel() const { return canRedo() ? steps_[at_ + 1].label : QString(); }

 private:
  struct Step {
    Corrections value;
    QString label, mergeKey;
  };
  std::vector<Step> steps_{Step{}};
  std::size_t at_ = 0;
};

}  // namespace detent::editor
