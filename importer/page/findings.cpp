// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/findings.h"

namespace detent::importer {
namespace {

/// The name of a finding for scripts, and the pattern of its message. The tables have the order of the codes.
template <class Code>
struct Wording {
  Code code;
  std::string_view name;
  const char* words;
};

template <class Code, std::size_t count>
constexpr bool isInOrder(const Wording<Code> (&table)[count]) {
  for (std::size_t i = 0; i < count; ++i)
    if (static_cast<std::size_t>(table[i].code) != i) return false;
  return true;
}

/// A pattern that is translated in the editor: the build target detent-edit-texts searches for this name.
constexpr const char* words(const char* pattern) { return pattern; }

constexpr Wording<EvidenceCode> evidenceWords[] = {
    {EvidenceCode::frameGiven, "frame-given", words("plot frame given by hand")},
    {EvidenceCode::edgesDrawn, "edges-drawn",
     words("%1 of 4 edges drawn, %2 vertical and %3 horizontal lines or ticks")},
    {EvidenceCode::labelsAroundBox, "labels-around-box",
     words("%1 labels below and %2 beside a rectangle of lines")},
    {EvidenceCode::axisGiven, "axis-given", words("%1: given")},
    {EvidenceCode::axisGivenAmongLabels, "axis-given-among-labels",
     words("%1 axis: given, %2 of %3 printed numbers agree")},
    {EvidenceCode::labelsInProgression, "labels-in-progression",
     words("%1 axis: %2 of %3 printed numbers fit one scale, with %4 ticks")},
    {EvidenceCode::distinguishedByPath, "told-apart-by-course",
     words("drawn as one loop and told apart by its course")},
    {EvidenceCode::namedByLegend, "named-by-legend", words("named by the legend")},
    {EvidenceCode::pressAboveRelease, "press-above-release",
     words("press lies above release on %1 of where they differ")},
    {EvidenceCode::oneHigherForce, "one-higher-force", words("one reaches a higher force")},
    {EvidenceCode::endsApart, "ends-apart", words("the two end apart, as the curves of two samples do")},
    {EvidenceCode::pressAlone, "press-alone", words("one curve: press only")},
    {EvidenceCode::pressAloneThoughNamedRelease, "press-alone-though-named-release",
     words("one curve, taken as press although the legend calls it release")},
    {EvidenceCode::releaseNamedNotSeen, "release-named-not-seen",
     words("one curve: press only, although the legend names a release too (\"%1\")")},
    {EvidenceCode::exchangedByHand, "exchanged-by-hand", words("exchanged by hand")},
    {EvidenceCode::numbersAlone, "numbers-alone",
     words("%1 numbers in a row and %2 in a column, without a rectangle of lines")},
    {EvidenceCode::widenedToNumbers, "widened-to-numbers", words("widened to where its numbers end")},
    {EvidenceCode::nameNearly, "name-nearly",
     words("no name is \"%1\", one that was read as \"%2\" is near to it")},
    {EvidenceCode::startUnderAnother, "foot-under-another",
     words("a stroke's foot lies under another curve and is taken from that")},
    {EvidenceCode::unitsOfHeading, "units-of-heading", words("only the heading names the units: \"%1\"")}};

constexpr Wording<DoubtCode> doubtWords[] = {
    {DoubtCode::axesUncertain, "axes-uncertain", words("the axes are not certain (%1)")},
    {DoubtCode::curvesUncertain, "curves-uncertain", words("the curves are not certain (%1)")},
    {DoubtCode::pointsMakeNoCurve, "points-make-no-curve",
     words("the traced points make no curve (the fit is %1 px off them)")},
    {DoubtCode::valueContradicts, "value-contradicts", words("the graph %1")},
    {DoubtCode::rangeUnreadable, "range-unreadable",
     words("the %1 numbers along it make no even progression")},
    {DoubtCode::ratherADrawing, "rather-a-drawing",
     words("this is more likely a drawing than a force graph (%1)")},
    {DoubtCode::resemblesNoLoop, "does-not-look-like-one",
     words("what can be followed in this ink does not look like a force curve (confidence %1)")},
    {DoubtCode::tooManyCurves, "too-many-curves",
     words("%1 curves, and which two belong together is not clear: %2")},
    {DoubtCode::severalSwitches, "several-switches", words("%1 switches are drawn in it: %2")},
    {DoubtCode::strokesAlike, "strokes-alike",
     words("press and release cannot be told apart: neither legend nor hysteresis says which is which (%1, "
           "%2)")},
    {DoubtCode::releaseAbovePress, "release-above-press",
     words("the release lies above the press over %1 of their travel")},
    {DoubtCode::unitMissing, "unit-missing", words("the %1 axis names no unit; %2 would be a guess")},
    {DoubtCode::otherQuantity, "other-quantity", words("the %1 axis %2")},
    {DoubtCode::axesExchanged, "axes-exchanged",
     words("the axes are exchanged: force runs to the right and travel upwards")},
    {DoubtCode::implausibleTravel, "implausible-travel", words("a travel of %1 is not a button's")},
    {DoubtCode::implausibleForce, "implausible-force", words("a force of %1 is not a button's")},
    {DoubtCode::negativeTravel, "negative-travel", words("the press starts at %1, left of zero")},
    {DoubtCode::negativeForce, "negative-force", words("the press goes down to %1, below zero")},
    {DoubtCode::strokesCoincide, "strokes-coincide",
     words("press and release are the same line over most of their length, or one jumps to the other and "
           "back")},
    {DoubtCode::alongAnAxis, "along-an-axis",
     words("more than half of a curve is parallel to an axis, as gridlines are")},
    {DoubtCode::manyTactilePoints, "many-tactile-points",
     words("a stroke with %1 tactile points is not a button's")},
    {DoubtCode::endsInAFall, "ends-in-a-fall",
     words("the press falls from its start or to its end, as an edge of the frame or a magnet's pull does")},
    {DoubtCode::cutAtPictureEdge, "cut-at-picture-edge", words("a curve ends where the picture does")},
    {DoubtCode::leavesThePlot, "leaves-the-plot", words("a curve goes on beyond the plot frame at %1")},
    {DoubtCode::belowTheAxis, "below-the-axis",
     words("the force axis begins at %1 and a curve goes below it")},
    {DoubtCode::otherScale, "other-scale", words("a second scale on the right %1")},
    {DoubtCode::curveLeftOver, "ink-left-over", words("ink like a curve's is left over around %1, %2")},
    {DoubtCode::curveOverPaper, "curve-without-ink", words("a curve runs over bare paper around %1, %2")},
    {DoubtCode::readingsDiffer, "readings-differ",
     words("two readings of the page differ: a travel of %1, and a travel of %2 where it is looked at in "
           "another size")},
    {DoubtCode::thousandsUnclear, "thousands-unclear",
     words("the numbers of the %1 axis may be thousands or have three decimals")},
    {DoubtCode::strokeInPart, "stroke-in-part", words("press and release share only %1 of their travel")},
    {DoubtCode::namesNoStroke, "names-no-stroke",
     words("one of two curves is called \"%1\", which is no stroke, and the other's name is not read")},
    {DoubtCode::otherSwitchNamed, "other-switch-named",
     words("the legend names strokes of \"%1\" as well, which are not traced")},
    {DoubtCode::pageIsScan, "page-is-scan",
     words("the page looks scanned, and scans are read wrong more often than drawings")},
    {DoubtCode::pageIsPhoto, "page-is-photo",
     words("the page looks photographed, and photographs are read wrong more often than other pages")},
    {DoubtCode::givenAgainstLegend, "given-against-legend",
     words("the colour given, %1, is that of a curve which the legend calls \"%2\"")},
    {DoubtCode::givenAgainstLabels, "given-against-labels",
     words("the values given for the %1 axis contradict the numbers printed there (%2)")},
    {DoubtCode::rangeFalls, "range-falls",
     words("the %1 numbers along it fall, and the plot could not be turned round")},
    {DoubtCode::assumed, "assumed", words("%1")}};

constexpr Wording<RemarkCode> remarkWords[] = {
    {RemarkCode::imagesUndecoded, "images-undecoded",
     words("page %1: images of the document that cannot be decoded: %2; the rest was read")},
    {RemarkCode::pageUnreadable, "page-unreadable", words("page %1: %2")},
    {RemarkCode::lengthUnitAssumed, "length-unit-assumed",
     words("no unit found on the %1 axis: taken as %2")},
    {RemarkCode::smallForcesTakenAsNewton, "small-forces-taken-as-newton",
     words("no unit found on the %1 axis: taken as N because it ends at 5 or below")},
    {RemarkCode::largeForcesTakenAsGram, "large-forces-taken-as-gram",
     words("no unit found on the %1 axis: taken as gf because it ends above 5")},
    {RemarkCode::labelContradicts, "label-contradicts",
     words("the label \"%1\" on the %2 axis stands at %3 of the scale that the others make: left out")},
    {RemarkCode::axisWithoutTicks, "axis-without-ticks",
     words("the %1 axis has no ticks: its scale comes from where its numbers stand")},
    {RemarkCode::displacementUnitAssumed, "displacement-unit-assumed",
     words("no unit of displacement found: taken as %1")},
    {RemarkCode::forceUnitAssumed, "force-unit-assumed",
     words("no unit of force found: taken as %1 from the size of the numbers")},
    {RemarkCode::forcesTurned, "forces-turned",
     words("compression is negative in this file: forces were made positive")},
    {RemarkCode::displacementTurned, "displacement-turned",
     words("displacement falls while force rises in this file: its direction was reversed")},
    {RemarkCode::severalPresses, "several-presses",
     words("the log holds %1 presses: the first complete cycle was taken")},
    {RemarkCode::displacementShifted, "displacement-shifted",
     words("displacement starts at %1: shifted so that the press starts at zero")},
    {RemarkCode::preloadTakenOff, "preload-taken-off",
     words("a force of %1 before contact was taken off as the meter's offset")},
    {RemarkCode::rowsAveraged, "rows-averaged",
     words("the log is long: each %1 rows were averaged into one")},
    {RemarkCode::rowsLeftOut, "rows-left-out",
     words("%1 of %2 rows hold no two finite numbers and were left out, the first in line %3 (\"%4\")")},
    {RemarkCode::noRelease, "no-release", words("the log holds no release stroke")},
    {RemarkCode::forceScaleDoubtful, "force-scale-doubtful",
     words("testers that write this format read forces off by up to 30 gf against other laboratories")},
    {RemarkCode::sameGraphSeveralTimes, "same-graph-several-times",
     words("the same graph is drawn %1 times (%2); the one on page %3 is taken, which reads best")},
    {RemarkCode::severalGraphs, "several-graphs",
     words("%1 graphs found; this is the most certain one (page %2, graph %3)")},
    {RemarkCode::doubted, "doubted", words("not beyond doubt: %1")},
    {RemarkCode::printedValueDiffers, "printed-value-differs", words("%1")},
    {RemarkCode::secondReadingTaken, "second-reading-taken",
     words("as it stands the page is not read for certain (%1): taken as two looks in other sizes read it")},
    {RemarkCode::endedByTimeLimit, "ended-by-time-limit",
     words("the limit of %1 s was reached: the best that was read until then is taken")},
    {RemarkCode::operatingPointNotPlaced, "operating-point-not-placed",
     words("an operating point is printed, but was not placed")},
    {RemarkCode::resetPointNotPlaced, "reset-point-not-placed",
     words("a reset point is printed, but was not placed")},
    {RemarkCode::errorBarsLeftOut, "error-bars-left-out", words("%1 error bars on the curves are left out")},
    {RemarkCode::releaseNotDrawn, "release-not-drawn",
     words("only the press was drawn by hand: the button has no release")}};

static_assert(isInOrder(evidenceWords) && isInOrder(doubtWords) && isInOrder(remarkWords));

const auto& wordingOf(EvidenceCode code) { return evidenceWords[static_cast<std::size_t>(code)]; }
const auto& wordingOf(DoubtCode code) { return doubtWords[static_cast<std::size_t>(code)]; }
const auto& wordingOf(RemarkCode code) { return remarkWords[static_cast<std::size_t>(code)]; }

}  // namespace

std::string_view nameOf(ImportStep step) {
  constexpr std::string_view names[] = {"read",  "locate",  "view",   "axes", "texts",   "copies",
                                        "trace", "strokes", "refine", "fit",  "callouts"};
  return names[static_cast<std::size_t>(step)];
}

std::string_view nameOf(EvidenceCode code) { return wordingOf(code).name; }
std::string_view nameOf(DoubtCode code) { return wordingOf(code).name; }
std::string_view nameOf(RemarkCode code) { return wordingOf(code).name; }

Message messageOf(const EvidenceItem& e) { return Message::of(wordingOf(e.code).words, e.values); }
Message messageOf(const Doubt& d) { return Message::of(wordingOf(d.code).words, d.values); }
Message messageOf(const Remark& r) { return Message::of(wordingOf(r.code).words, r.values); }

std::vector<Message> messagesOf(const std::vector<EvidenceItem>& evidence) {
  std::vector<Message> messages;
  for (const EvidenceItem& each : evidence) messages.push_back(messageOf(each));
  return messages;
}

Failure failureOf(const Doubt& doubt, Subject subject, Message place) {
  return {FailureCode::notCertain, std::move(subject), std::move(place),
          messageOf(doubt),        doubt.remedies,     nameOf(doubt.code)};
}

std::string commandLineWords(const Remark& remark) {
  const std::string remedies = detent::commandLineWords(remark.remedies);
  return english(messageOf(remark)) + (remedies.empty() ? "" : ". " + remedies);
}

}  // namespace detent::importer
