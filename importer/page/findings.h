// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Findings of an import's steps: evidence, doubts and remarks, each a code with values. Programs word them;
// findings.cpp has the English patterns.

#include <string>
#include <string_view>
#include <vector>

#include "model/message.h"
#include "model/remedy.h"
#include "model/result.h"

namespace detent::importer {

/// The steps of an import that take time or give a finding, in flow order.
enum class ImportStep { read, locate, view, axes, texts, copies, trace, strokes, refine, fit, callouts };

/// Name for scripts: "locate".
std::string_view nameOf(ImportStep step);

/// Facts that support a conclusion.
enum class EvidenceCode {
  frameGiven,
  edgesDrawn,            ///< edges drawn (of 4), vertical and horizontal lines or ticks
  labelsAroundBox,       ///< labels below, labels beside a rectangle of lines
  axisGiven,             ///< axis
  axisGivenAmongLabels,  ///< axis, labels that agree with the given ends, numbers read
  labelsInProgression,   ///< axis, labels in it, numbers read, ticks
  distinguishedByPath,   ///< both strokes are drawn in one colour
  distinguishedByHand,   ///< colours or lines given by hand
  namedByLegend,
  pressAboveRelease,  ///< share of the travel where the two curves differ
  oneHigherForce,
  endsApart,  ///< neither curve ends on the other
  pressAlone,
  pressAloneThoughNamedRelease,
  releaseNamedNotSeen,
  exchangedByHand,
  numbersAlone,       ///< numbers in a row, numbers in a column; no rectangle of lines
  widenedToNumbers,   ///< the labels count on beyond the rectangle of lines
  nameNearly,         ///< requested name, name read
  startUnderAnother,  ///< a stroke's start is hidden by another curve and is assumed to fall with it
  unitsOfHeading      ///< the words above the plot that name a unit which an axis lacks
};

struct EvidenceItem {
  EvidenceCode code;
  std::vector<MessageValue> values = {};
};

/// "labels-in-progression".
std::string_view nameOf(EvidenceCode code);
Message messageOf(const EvidenceItem& evidence);
std::vector<Message> messagesOf(const std::vector<EvidenceItem>& evidence);

/// A reason why the result may be wrong.
enum class DoubtCode {
  axesUncertain,      ///< messages of the axes' evidence
  curvesUncertain,    ///< messages of the curves' evidence
  pointsMakeNoCurve,  ///< distance of the fit from the points, px
  valueContradicts,   ///< message of the printed value
  rangeUnreadable,    ///< numbers along the axis that make no even progression
  ratherADrawing,     ///< messages of the axes' evidence
  resemblesNoLoop,    ///< confidence of the curves, 0..1
  tooManyCurves,      ///< number of curves, their colours and names
  severalSwitches,    ///< number of switches, their numbers, names and colours
  strokesAlike,       ///< colours of the two
  releaseAbovePress,  ///< share of their travel
  // found by no single step, docs/develop/decisions/0805-doubts.md
  unitMissing,    ///< axis, unit that would be taken, lengths or forces
  otherQuantity,  ///< axis, its quantity as printed
  axesExchanged,
  implausibleTravel,  ///< mm
  implausibleForce,   ///< N
  negativeTravel,     ///< mm at the press's start
  negativeForce,      ///< lowest force, N
  strokesCoincide,
  alongAnAxis,
  manyTactilePoints,  ///< how many
  endsInAFall,
  cutAtPictureEdge,
  leavesThePlot,  ///< force at the plot's edge beyond which the curve continues, N
  belowTheAxis,   ///< force at which the axis begins, N
  otherScale,
  curveLeftOver,       ///< travel and force at its middle, mm and N
  curveOverPaper,      ///< travel and force at its middle, mm and N
  readingsDiffer,      ///< messages: the button of the first reading, and of the second
  thousandsUnclear,    ///< axis
  strokeInPart,        ///< share of the travel that both strokes cover
  releaseStartsShort,  ///< displacement at which the release starts, and the press' largest one
  namesNoStroke,       ///< name of the only named curve, which is no stroke's name
  otherSwitchNamed,    ///< name of a switch in the legend of which no stroke was traced
  pageIsScan,
  pageIsPhoto,
  givenAgainstLegend,  ///< given colour of a stroke, and the legend's text for the curve of that colour
  givenAgainstLabels,  ///< axis, the labels that contradict the ends given for it
  factorUnread,        ///< axis
  factorPrinted,       ///< axis, factor in its title, message: numbers multiplied, or given ends not
  releaseNotGiven,     ///< the press was given by hand, and nothing says that there is no release
  rangeFalls,          ///< numbers that fall along the axis, on a plot that cannot be mirrored
  assumed              ///< message of the evidence
};

struct Doubt {
  DoubtCode code;
  std::vector<MessageValue> values = {};
  Remedies remedies = {};
};

/// "axes-uncertain".
std::string_view nameOf(DoubtCode code);
Message messageOf(const Doubt& doubt);
/// Failure notCertain, with the doubt's code as its reason.
Failure failureOf(const Doubt& doubt, Subject subject = {}, Message place = {});

/// A fact about a successful import that the user should know.
enum class RemarkCode {
  imagesUndecoded,  ///< page, images of the document
  pageUnreadable,   ///< page, reason
  // axes
  lengthUnitAssumed,         ///< axis, unit taken
  smallForcesTakenAsNewton,  ///< axis
  largeForcesTakenAsGram,    ///< axis
  labelContradicts,          ///< text of the label, axis, value where it stands
  axisWithoutTicks,          ///< axis
  signsLeftOut,              ///< axis
  // force logs
  displacementUnitAssumed,  ///< unit taken
  forceUnitAssumed,         ///< unit taken
  forcesTurned,
  displacementTurned,
  severalPresses,       ///< how many
  displacementShifted,  ///< displacement at the start, mm
  preloadTakenOff,      ///< N
  rowsAveraged,         ///< rows in each
  rowsLeftOut,          ///< how many, of how many, line of the first, its text
  noRelease,
  forceScaleDoubtful,
  // graphs of a document
  sameGraphSeveralTimes,  ///< number of times, places (messages), page taken
  severalGraphs,          ///< number of graphs, page and graph taken
  doubted,                ///< message of a doubt that is too small to refuse
  printedValueDiffers,    ///< message of the comparison
  // levels that read twice, limits on time
  secondReadingTaken,  ///< message: result of the first reading, or why it failed
  endedByTimeLimit,    ///< seconds
  // printed on the page but not in the result
  operatingPointNotPlaced,  ///< the plot names one
  resetPointNotPlaced,      ///< the same
  errorBarsLeftOut          ///< number of bars
};

struct Remark {
  RemarkCode code;
  std::vector<MessageValue> values = {};
  Remedies remedies = {};
};

/// "several-graphs".
std::string_view nameOf(RemarkCode code);
Message messageOf(const Remark& remark);
/// The remark's message and remedy, in the words of detent-import.
std::string commandLineWords(const Remark& remark);

}  // namespace detent::importer
