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
    {EvidenceCode::frameGiven, "frame-given", words("plot frame entered by hand")},
    {EvidenceCode::edgesDrawn, "edges-drawn",
     words("%1 of the 4 edges of the frame are drawn, with %2 vertical and %3 horizontal lines or ticks")},
    {EvidenceCode::labelsAroundBox, "labels-around-box",
     words("a rectangle of lines has %1 tick labels below it and %2 beside it")},
    {EvidenceCode::axisGiven, "axis-given", words("%1: entered by hand")},
    {EvidenceCode::axisGivenAmongLabels, "axis-given-among-labels",
     words("%1 axis: entered by hand; %2 of %3 printed numbers agree")},
    {EvidenceCode::labelsInProgression, "labels-in-progression",
     words("%1 axis: %2 of %3 printed numbers fit one scale, with %4 ticks")},
    {EvidenceCode::distinguishedByPath, "told-apart-by-course",
     words("both curves have one colour, and their course tells which is the press")},
    {EvidenceCode::distinguishedByHand, "told-apart-by-hand",
     words("the press or the release was given by hand")},
    {EvidenceCode::namedByLegend, "named-by-legend", words("the legend names press and release")},
    {EvidenceCode::pressAboveRelease, "press-above-release",
     words("the press lies above the release along %1 of the travel on which they differ")},
    {EvidenceCode::oneHigherForce, "one-higher-force", words("one of the curves reaches a higher force")},
    {EvidenceCode::endsApart, "ends-apart",
     words("the two curves end at different points, like curves of two switches")},
    {EvidenceCode::pressAlone, "press-alone", words("there is only one curve, which is the press")},
    {EvidenceCode::pressAloneThoughNamedRelease, "press-alone-though-named-release",
     words("the only curve was taken as the press, although the legend calls it release")},
    {EvidenceCode::releaseNamedNotSeen, "release-named-not-seen",
     words("the only curve was taken as the press, although the legend also names a release (\"%1\")")},
    {EvidenceCode::exchangedByHand, "exchanged-by-hand", words("press and release were swapped by hand")},
    {EvidenceCode::numbersAlone, "numbers-alone",
     words("there are %1 numbers in a row and %2 in a column, but no rectangle of lines")},
    {EvidenceCode::widenedToNumbers, "widened-to-numbers",
     words("the frame was widened to its outermost tick labels")},
    {EvidenceCode::nameNearly, "name-nearly",
     words("no curve is named \"%1\"; the most similar name that was read is \"%2\"")},
    {EvidenceCode::startUnderAnother, "foot-under-another",
     words("the start of a stroke is hidden under another curve and was taken from that curve")},
    {EvidenceCode::unitsOfHeading, "units-of-heading",
     words("the units are named only in the heading: \"%1\"")}};

constexpr Wording<DoubtCode> doubtWords[] = {
    {DoubtCode::axesUncertain, "axes-uncertain", words("the axes are not certain (%1)")},
    {DoubtCode::curvesUncertain, "curves-uncertain", words("the curves are not certain (%1)")},
    {DoubtCode::pointsMakeNoCurve, "points-make-no-curve",
     words("the traced points do not form a curve (the fit deviates from them by %1 px)")},
    {DoubtCode::valueContradicts, "value-contradicts", words("%1")},
    {DoubtCode::rangeUnreadable, "range-unreadable",
     words("the %1 numbers along this axis do not form an even scale")},
    {DoubtCode::ratherADrawing, "rather-a-drawing",
     words("this is more likely a drawing than a force graph (%1)")},
    {DoubtCode::resemblesNoLoop, "does-not-look-like-one",
     words("the lines that were traced do not look like a force curve (confidence %1)")},
    {DoubtCode::tooManyCurves, "too-many-curves",
     words("there are %1 curves, and it is not clear which two belong together: %2")},
    {DoubtCode::severalSwitches, "several-switches", words("the plot shows %1 switches: %2")},
    {DoubtCode::strokesAlike, "strokes-alike",
     words("press and release cannot be told apart: neither legend nor hysteresis says which is which (%1, "
           "%2)")},
    {DoubtCode::releaseAbovePress, "release-above-press",
     words("the curve that would be the release lies above the press over %1 of their travel")},
    {DoubtCode::unitMissing, "unit-missing",
     words("no unit for %3 was found at the %1 axis; %2 would be a guess")},
    {DoubtCode::otherQuantity, "other-quantity", words("the %1 axis cannot be used: %2")},
    {DoubtCode::axesExchanged, "axes-exchanged",
     words("the axes are exchanged: force runs to the right and travel upwards")},
    {DoubtCode::implausibleTravel, "implausible-travel",
     words("a travel of %1 is not plausible for a button")},
    {DoubtCode::implausibleForce, "implausible-force", words("a force of %1 is not plausible for a button")},
    {DoubtCode::negativeTravel, "negative-travel", words("the press starts at %1, left of zero")},
    {DoubtCode::negativeForce, "negative-force", words("the press goes down to %1, below zero")},
    {DoubtCode::strokesCoincide, "strokes-coincide",
     words("the curves that would be press and release run along each other, or one jumps to the other and "
           "back")},
    {DoubtCode::alongAnAxis, "along-an-axis",
     words("more than half of a curve is parallel to an axis, as gridlines are")},
    {DoubtCode::manyTactilePoints, "many-tactile-points",
     words("a stroke with %1 tactile points is not plausible for a button")},
    {DoubtCode::endsInAFall, "ends-in-a-fall",
     words("the press force falls at its start or end; perhaps an edge of the frame was traced, or a magnet "
           "pulls")},
    {DoubtCode::cutAtPictureEdge, "cut-at-picture-edge",
     words("a curve is cut off at the edge of the picture")},
    {DoubtCode::leavesThePlot, "leaves-the-plot", words("a curve goes on beyond the plot frame at %1")},
    {DoubtCode::belowTheAxis, "below-the-axis",
     words("the force axis begins at %1, but a curve goes below this value")},
    {DoubtCode::otherScale, "other-scale", words("there is a second scale on the right, and %1")},
    {DoubtCode::curveLeftOver, "ink-left-over",
     words("a line that looks like a curve was not traced; it lies around %1, %2")},
    {DoubtCode::curveOverPaper, "curve-without-ink",
     words("the traced curve runs over blank paper around %1, %2")},
    {DoubtCode::readingsDiffer, "readings-differ",
     words("two readings of the page differ: the first found %1; the second, with the page drawn at another "
           "size, found %2")},
    {DoubtCode::thousandsUnclear, "thousands-unclear",
     words("the numbers of the %1 axis may be thousands, or may have three decimals")},
    {DoubtCode::strokeInPart, "stroke-in-part", words("press and release share only %1 of their travel")},
    {DoubtCode::releaseStartsShort, "release-starts-short",
     words("the release was traced from %1 only, but the press goes on to %2; its beginning may be missing")},
    {DoubtCode::namesNoStroke, "names-no-stroke",
     words("the legend calls one of two curves \"%1\", which means neither press nor release; the name of "
           "the other curve could not be read")},
    {DoubtCode::otherSwitchNamed, "other-switch-named",
     words("the legend also names curves of \"%1\", which were not traced")},
    {DoubtCode::pageIsScan, "page-is-scan",
     words("the page looks scanned, and scans are read wrong more often than drawings")},
    {DoubtCode::pageIsPhoto, "page-is-photo",
     words("the page looks photographed, and photographs are read wrong more often than other pages")},
    {DoubtCode::givenAgainstLegend, "given-against-legend",
     words("you gave the colour %1 here, but the legend calls the curve of that colour \"%2\"")},
    {DoubtCode::givenAgainstLabels, "given-against-labels",
     words("the values entered for the %1 axis contradict the numbers printed there (%2)")},
    {DoubtCode::factorUnread, "factor-unread",
     words("the title of the %1 axis prints a factor that cannot be read")},
    {DoubtCode::factorPrinted, "factor-printed", words("the title of the %1 axis prints the factor %2; %3")},
    {DoubtCode::releaseNotGiven, "release-not-given",
     words("imported without a release: none was given by hand beside the press")},
    {DoubtCode::rangeFalls, "range-falls",
     words("the %1 numbers along this axis decrease, and the plot could not be mirrored")},
    {DoubtCode::assumed, "assumed", words("%1")}};

constexpr Wording<RemarkCode> remarkWords[] = {
    {RemarkCode::imagesUndecoded, "images-undecoded",
     words("page %1: images that could not be decoded: %2; the rest of the page was read")},
    {RemarkCode::pageUnreadable, "page-unreadable", words("page %1: %2")},
    {RemarkCode::lengthUnitAssumed, "length-unit-assumed",
     words("no unit for lengths was found at the %1 axis, so %2 was assumed")},
    {RemarkCode::smallForcesTakenAsNewton, "small-forces-taken-as-newton",
     words(
         "no unit for forces was found at the %1 axis; N was assumed, because the axis ends at 5 or below")},
    {RemarkCode::largeForcesTakenAsGram, "large-forces-taken-as-gram",
     words("no unit for forces was found at the %1 axis; gf was assumed, because the axis ends above 5")},
    {RemarkCode::labelContradicts, "label-contradicts",
     words(
         "the tick label \"%1\" on the %2 axis was ignored, because by the other labels its place means %3")},
    {RemarkCode::axisWithoutTicks, "axis-without-ticks",
     words("the %1 axis has no ticks: its scale was taken from the positions of its numbers")},
    {RemarkCode::signsLeftOut, "signs-left-out",
     words("the numbers of the %1 axis are negative; they were read without their minus signs")},
    {RemarkCode::displacementUnitAssumed, "displacement-unit-assumed",
     words("the file names no unit of displacement, so %1 was assumed")},
    {RemarkCode::forceUnitAssumed, "force-unit-assumed",
     words("the file names no unit of force; %1 was assumed from the size of the numbers")},
    {RemarkCode::forcesTurned, "forces-turned",
     words("this file gives compression as negative forces; they were made positive")},
    {RemarkCode::displacementTurned, "displacement-turned",
     words("in this file, the displacement falls while the force rises; the direction of the displacement "
           "was reversed")},
    {RemarkCode::severalPresses, "several-presses",
     words("the log holds %1 presses; the first complete cycle was used")},
    {RemarkCode::displacementShifted, "displacement-shifted",
     words("the displacement started at %1; it was shifted so that the press starts at zero")},
    {RemarkCode::preloadTakenOff, "preload-taken-off",
     words("a force of %1 before contact was subtracted as offset of the force meter")},
    {RemarkCode::rowsAveraged, "rows-averaged",
     words("the log is long, so every %1 rows were averaged into one")},
    {RemarkCode::rowsLeftOut, "rows-left-out",
     words("%1 of %2 rows do not hold two usable numbers and were left out, the first in line %3 (\"%4\")")},
    {RemarkCode::noRelease, "no-release", words("the log holds no release stroke")},
    {RemarkCode::forceScaleDoubtful, "force-scale-doubtful",
     words("forces from testers that write this format can differ by up to 30 gf from those of other "
           "laboratories")},
    {RemarkCode::sameGraphSeveralTimes, "same-graph-several-times",
     words("the same graph is drawn %1 times (%2); the one on page %3 was used, as it is the most certain")},
    {RemarkCode::severalGraphs, "several-graphs",
     words("%1 graphs were found; this is the most certain one (page %2, graph %3)")},
    {RemarkCode::doubted, "doubted", words("not certain: %1")},
    {RemarkCode::printedValueDiffers, "printed-value-differs", words("%1")},
    {RemarkCode::secondReadingTaken, "second-reading-taken",
     words("the first reading of the page was not certain (%1); two readings at other sizes agree and were "
           "used")},
    {RemarkCode::endedByTimeLimit, "ended-by-time-limit",
     words("the time limit of %1 s was reached; the best reading so far was used")},
    {RemarkCode::operatingPointNotPlaced, "operating-point-not-placed",
     words("the page states an operating point, but it could not be placed on the curve")},
    {RemarkCode::resetPointNotPlaced, "reset-point-not-placed",
     words("the page states a reset point, but it could not be placed on the curve")},
    {RemarkCode::errorBarsLeftOut, "error-bars-left-out",
     words("upright marks on the curves, such as error bars, were left out: %1")}};

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
