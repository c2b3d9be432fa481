// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Step 3: from ticks and their labels to millimetres and newtons.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "importer/frame/plot_frame.h"
#include "importer/page/findings.h"
#include "importer/page/progress.h"
#include "model/message.h"
#include "model/units.h"

namespace detent::importer {

/// A tick with the number read at it.
struct TickLabel {
  double position_px = 0;  ///< position of the tick or gridline along the axis
  double value = 0;        ///< in the axis' printed unit
  std::string text;        ///< as read
  Box box;                 ///< view pixels
  bool used = true;        ///< false: disagreed with the progression and was left out
  bool agrees = true;      ///< with the ends if any was given, else with the progression
};

/// Contents of `otherQuantity` for axes that are not divided evenly.
inline constexpr char logarithmicScale[] = "values on a logarithmic scale";
inline constexpr char categoriesScale[] = "categories, not to scale";
inline constexpr char brokenScale[] = "values on a scale with a break";

/// One axis as printed.
struct AxisReading {
  double min = 0, max = 0;  ///< value at the frame's left/bottom and right/top edge, printed unit
  double residual_px = 0;   ///< rms of used ticks
  std::string unit;         ///< symbol as we print it: "mm", "cN", "gf"; never empty
  DecidedBy unitBy = DecidedBy::found;
  /// false: nothing on the page names the unit, so a default was taken; an import must not rest on it
  bool unitFound = false;
  /// the quantity in its title if that is neither displacement nor force: "kPa", "Time"; empty otherwise
  std::string otherQuantity;
  /// every label has the form "1,000": read as decimals, but they may be thousands
  bool thousandsUnclear = false;
  std::vector<TickLabel> ticks;
  std::string title;          ///< as read
  double factor = 1;          ///< printed in the title; 1: none, or given ends have it in them
  bool factorUnread = false;  ///< the title prints one that cannot be read, and no given ends have it in them
  bool multiplied = false;    ///< by `factor`; given ends only if they are the numbers printed along the axis
  bool repeated = false;      ///< the given ends are those that the printed numbers have at the frame's edges
  /// labels that agree with one another and contradict the ends that were given, as text
  std::vector<std::string> contradicting;
  /// confidence in the scale of the labels, if `contradicting` is not empty, 0..1
  double contradictedBy = 0;
  double sure = 0;  ///< confidence in the range of this axis alone, 0..1
};

/// Distortion of a sheet besides perspective: paper that sags or bulges, and a lens that bends straight
/// lines. Both move a point along the line from one centre of the picture (the camera's axis, the lens'
/// middle) by an amount of second degree in the point. Points are counted from `middle_px` in units of
/// `half_px`.
struct SheetBend {
  Point middle_px;
  double half_px = 1;             ///< half of the picture's size, > 0
  std::array<double, 3> depth{};  ///< coefficients of xx, xy, yy; all 0: no bend
  Point from;                     ///< the negated position of the centre that points move away from
  Point straightened(Point view_px) const;
  /// The inverse map, from straightened to bent pixels. Accurate for bends far smaller than the sheet.
  Point bent(Point straight_px) const;
};

/// Invertible map between view pixels and (mm, N). Projective, so that photographs fit; affine for everything
/// else. Bent only where importer/refine has measured it.
struct AxisCalibration {
  AxisReading x, y;
  Homography viewToUnits;         ///< straightened view px -> (mm, N)
  std::optional<SheetBend> bend;  ///< empty: view px are straight

  Point toUnits(Point view_px) const;  ///< (mm, N)
  Point toView(Point mm_N) const;
  /// Millimetres and newtons per view pixel at the frame's centre; noise scales of the fit.
  double mmPerPx() const;
  double newtonPerPx() const;
};

/// A travel or force for a sentence: in the unit of its axis, with three significant digits.
MessageValue shownTravel(const AxisReading& x, double travel_mm);
MessageValue shownForce(const AxisReading& y, double force_N);

struct AxisHints {
  std::optional<double> xMin, xMax, yMin, yMax;  ///< values at the frame's edges, in xUnit/yUnit
  std::optional<LengthUnit> xUnit;
  std::optional<ForceUnit> yUnit;

  bool operator==(const AxisHints&) const = default;
};

/// A word or number seen on the page: from its own text where it has text, else OCR.
struct SeenText {
  std::string utf8;
  Box box;                ///< view pixels
  double confidence = 0;  ///< 0..1; 1 for the document's own text
  double angle_deg = 0;
};

/// Meaning of the numbers at the right edge of the plot frame. `none` also if they only repeat the left scale
/// in another unit of force.
enum class RightScale {
  none,
  other,       ///< a scale of something other than force, or one without a title
  otherForces  ///< a second scale of force: a curve may belong to either
};

struct AxesFound {
  Found<AxisCalibration> calibration;
  /// Tick labels, titles and the document's own texts; legend and callouts come with readGraphTexts.
  std::vector<SeenText> texts;
  /// Further lines of writing beside those texts. Short names ("TS-10", "1.6 N") have their text; lines that
  /// could not be read have none.
  std::vector<SeenText> otherLines;
  std::vector<Remark> remarks;
  RightScale rightScale = RightScale::none;
};

/// Marks the labels of an axis as unused if its range was given: the labels only locate the frame, and the
/// given range alone defines the values at the frame's edges.
void useNoTicksOfGivenRanges(AxisCalibration& calibration, const AxisHints& hints);

/// Failure noForceGraph: no numbers; notCertain: numbers that make no progression (remedy: --x-axis /
/// --y-axis).
Result<AxesFound> readAxes(const PageView& view, const PlotFrame& frame, const AxisHints& hints = {},
                           const Progress& progress = {});

/// Searches the titles for units that were not found, in a view that shows more of the page around the same
/// frame: titles stand farther out than labels, so the first view may cut them off. `frame` is in the wider
/// view's pixels; `toWide` maps the pixels in which `axes` were read to that view. A unit that is found
/// replaces the assumed one, and the scale is converted with it.
void readMissingUnits(AxesFound& axes, const PageView& widerView, const PlotFrame& frame,
                      const Homography& toWide, const AxisHints& hints = {});

/// Adds the other writing in and beside the frame to `axes.texts`: callouts, legend, titles over the plot.
/// Only lines of at least three letters that were read with some certainty are added, because their boxes are
/// masked when curves are traced; the rest goes to `axes.otherLines`. Separate from readAxes because listing
/// graphs does not need it (5 to 10 ms per line).
void readGraphTexts(const PageView& view, const PlotFrame& frame, AxesFound& axes,
                    const Progress& progress = {});

/// Returns true if the titles say that force runs to the right and travel upwards.
bool areExchanged(const AxisCalibration& axes);
/// The doubt about one axis that measures `quantity`, or is divided unevenly. `unit`: the remedy that asks
/// for the axis' unit; an unevenly divided axis does not get it.
Doubt otherQuantityOn(const char* axis, const std::string& quantity, RemedyKind unit);
/// The doubts about axes that do not measure what they must: of x, then of y, or that both are exchanged.
std::vector<Doubt> otherQuantitiesOf(const AxisCalibration& axes);

}  // namespace detent::importer
