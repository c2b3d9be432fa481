// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/findings.h"

namespace detent::importer {
namespace {

/// How a finding is called by scripts, and the pattern of its words.
struct Wording {
  std::string_view name;
  const char* words;
};

/// A pattern that is translated in the editor: the build target detent-edit-texts looks for this name.
constexpr const char* words(const char* pattern) { return pattern; }

Wording wordingOf(EvidenceCode code) {
  switch (code) {
    case EvidenceCode::frameGiven:
      return {"frame-given", words("plot frame given by hand")};
    case EvidenceCode::edgesDrawn:
      return {"edges-drawn", words("%1 of 4 edges drawn, %2 vertical and %3 horizontal lines or ticks")};
    case EvidenceCode::labelsAroundBox:
      return {"labels-around-box", words("%1 labels below and %2 beside a rectangle of lines")};
    case EvidenceCode::axisGiven:
      return {"axis-given", words("%1: given")};
    case EvidenceCode::labelsInProgression:
      return {"labels-in-progression", words("%1: %2 of %3 labels on an even progression over %4 ticks")};
    case EvidenceCode::toldApartByCourse:
      return {"told-apart-by-course", words("drawn as one loop and told apart by its course")};
    case EvidenceCode::namedByLegend:
      return {"named-by-legend", words("named by the legend")};
    case EvidenceCode::pressAboveRelease:
      return {"press-above-release", words("press lies above release on %1 of where they differ")};
    case EvidenceCode::oneHigherForce:
      return {"one-higher-force", words("one reaches a higher force")};
    case EvidenceCode::endsApart:
      return {"ends-apart", words("the two end apart, as the curves of two samples do")};
    case EvidenceCode::pressAlone:
      return {"press-alone", words("one curve: press only")};
    case EvidenceCode::pressAloneThoughNamedRelease:
      return {"press-alone-though-named-release",
              words("one curve, taken as press although the legend calls it release")};
    case EvidenceCode::releaseNamedNotSeen:
      return {"release-named-not-seen",
              words("one curve: press only, although the legend names a release too (\"%1\")")};
    case EvidenceCode::exchangedByHand:
      return {"exchanged-by-hand", words("exchanged by hand")};
    case EvidenceCode::numbersAlone:
      return {"numbers-alone", words("%1 numbers in a row and %2 in a column, without a rectangle of lines")};
    case EvidenceCode::widenedToNumbers:
      return {"widened-to-numbers", words("widened to where its numbers end")};
    case EvidenceCode::nameNearly:
      return {"name-nearly", words("no name is \"%1\", one that was read as \"%2\" is near to it")};
    case EvidenceCode::footUnderAnother:
      return {"foot-under-another", words("a stroke's foot lies under another curve and is taken from that")};
    case EvidenceCode::unitsOfHeading:
      return {"units-of-heading", words("only the heading names the units: \"%1\"")};
  }
  return {"", ""};
}

Wording wordingOf(DoubtCode code) {
  switch (code) {
    case DoubtCode::axesUncertain:
      return {"axes-uncertain", words("the axes are not certain (%1)")};
    case DoubtCode::curvesUncertain:
      return {"curves-uncertain", words("the curves are not certain (%1)")};
    case DoubtCode::pointsMakeNoCurve:
      return {"points-make-no-curve", words("the traced points make no curve (the fit is %1 px off them)")};
    case DoubtCode::valueContradicts:
      return {"value-contradicts", words("the graph %1")};
    case DoubtCode::rangeUnreadable:
      return {"range-unreadable", words("the %1 numbers along it make no even progression")};
    case DoubtCode::rangeFalls:
      return {"range-falls", words("the %1 numbers along it fall, and the plot could not be turned round")};
    case DoubtCode::ratherADrawing:
      return {"rather-a-drawing", words("this is more likely a drawing than a force graph (%1)")};
    case DoubtCode::doesNotLookLikeOne:
      return {"does-not-look-like-one",
              words("what can be followed in this ink does not look like a force curve (confidence %1)")};
    case DoubtCode::tooManyCurves:
      return {"too-many-curves", words("%1 curves, and which two belong together is not clear: %2")};
    case DoubtCode::severalSwitches:
      return {"several-switches", words("%1 switches are drawn in it: %2")};
    case DoubtCode::strokesAlike:
      return {"strokes-alike", words("press and release cannot be told apart: neither legend nor hysteresis "
                                     "says which is which (%1, %2)")};
    case DoubtCode::releaseAbovePress:
      return {"release-above-press", words("the release lies above the press over %1 of their travel")};
    case DoubtCode::unitMissing:
      return {"unit-missing", words("the %1 axis names no unit; %2 would be a guess")};
    case DoubtCode::otherQuantity:
      return {"other-quantity", words("the %1 axis measures \"%2\"")};
    case DoubtCode::implausibleTravel:
      return {"implausible-travel", words("a travel of %1 is not a button's")};
    case DoubtCode::implausibleForce:
      return {"implausible-force", words("a force of %1 is not a button's")};
    case DoubtCode::negativeTravel:
      return {"negative-travel", words("the press starts at %1, left of zero")};
    case DoubtCode::negativeForce:
      return {"negative-force", words("the press goes down to %1, below zero")};
    case DoubtCode::strokesCoincide:
      return {"strokes-coincide", words("press and release are the same line over most of their length")};
    case DoubtCode::alongAnAxis:
      return {"along-an-axis", words("more than half of a curve is parallel to an axis, as gridlines are")};
    case DoubtCode::manyTactilePoints:
      return {"many-tactile-points", words("a stroke with %1 tactile points is not a button's")};
    case DoubtCode::endsInAFall:
      return {"ends-in-a-fall", words("the press falls from its start or to its end, as an edge of the frame "
                                      "or a magnet's pull does")};
    case DoubtCode::cutAtPictureEdge:
      return {"cut-at-picture-edge", words("a curve ends where the picture does")};
    case DoubtCode::leavesThePlot:
      return {"leaves-the-plot", words("a curve goes on beyond the plot frame at %1")};
    case DoubtCode::belowTheAxis:
      return {"below-the-axis", words("the force axis begins at %1 and a curve goes below it")};
    case DoubtCode::otherScale:
      return {"other-scale", words("a second scale on the right measures something else")};
    case DoubtCode::inkLeftOver:
      return {"ink-left-over", words("ink like a curve's is left over around %1, %2")};
    case DoubtCode::curveWithoutInk:
      return {"curve-without-ink", words("a curve runs over bare paper around %1, %2")};
    case DoubtCode::readingsDiffer:
      return {"readings-differ", words("two readings of the page differ: a travel of %1, and a travel of %2 "
                                       "where it is looked at in another size")};
    case DoubtCode::thousandsUnclear:
      return {"thousands-unclear",
              words("the numbers of the %1 axis may be thousands or have three decimals")};
    case DoubtCode::strokeInPart:
      return {"stroke-in-part", words("press and release share only %1 of their travel")};
    case DoubtCode::givenAgainstLegend:
      return {"given-against-legend",
              words("the colour given, %1, is that of a curve which the legend calls \"%2\"")};
    case DoubtCode::namesNoStroke:
      return {
          "names-no-stroke",
          words("one of two curves is called \"%1\", which is no stroke, and the other's name is not read")};
    case DoubtCode::otherSwitchNamed:
      return {"other-switch-named",
              words("the legend names strokes of \"%1\" as well, which are not traced")};
    case DoubtCode::assumed:
      return {"assumed", words("%1")};
    case DoubtCode::pageIsScan:
      return {"page-is-scan",
              words("the page looks scanned, and scans are read wrong more often than drawings")};
    case DoubtCode::pageIsPhoto:
      return {
          "page-is-photo",
          words("the page looks photographed, and photographs are read wrong more often than other pages")};
  }
  return {"", ""};
}

Wording wordingOf(RemarkCode code) {
  switch (code) {
    case RemarkCode::imagesUndecoded:
      return {"images-undecoded",
              words("page %1: images of the document that cannot be decoded: %2; the rest was read")};
    case RemarkCode::pageUnreadable:
      return {"page-unreadable", words("page %1: %2")};
    case RemarkCode::lengthUnitAssumed:
      return {"length-unit-assumed", words("no unit found on the %1 axis: taken as %2")};
    case RemarkCode::smallForcesTakenAsNewton:
      return {"small-forces-taken-as-newton",
              words("no unit found on the %1 axis: taken as N because it ends at 5 or below")};
    case RemarkCode::largeForcesTakenAsGram:
      return {"large-forces-taken-as-gram",
              words("no unit found on the %1 axis: taken as gf because it ends above 5")};
    case RemarkCode::labelContradicts:
      return {
          "label-contradicts",
          words("the label \"%1\" on the %2 axis stands at %3 of the scale that the others make: left out")};
    case RemarkCode::axisWithoutTicks:
      return {"axis-without-ticks",
              words("the %1 axis has no ticks: its scale comes from where its numbers stand")};
    case RemarkCode::displacementUnitAssumed:
      return {"displacement-unit-assumed", words("no unit of displacement found: taken as %1")};
    case RemarkCode::forceUnitAssumed:
      return {"force-unit-assumed",
              words("no unit of force found: taken as %1 from the size of the numbers")};
    case RemarkCode::forcesTurned:
      return {"forces-turned", words("compression is negative in this file: forces were made positive")};
    case RemarkCode::displacementTurned:
      return {"displacement-turned",
              words("displacement falls while force rises in this file: its direction was reversed")};
    case RemarkCode::severalPresses:
      return {"several-presses", words("the log holds %1 presses: the first complete cycle was taken")};
    case RemarkCode::displacementShifted:
      return {"displacement-shifted",
              words("displacement starts at %1: shifted so that the press starts at zero")};
    case RemarkCode::preloadTakenOff:
      return {"preload-taken-off", words("a force of %1 before contact was taken off as the meter's offset")};
    case RemarkCode::rowsAveraged:
      return {"rows-averaged", words("the log is long: each %1 rows were averaged into one")};
    case RemarkCode::rowsLeftOut:
      return {
          "rows-left-out",
          words("%1 of %2 rows hold no two finite numbers and were left out, the first in line %3 (\"%4\")")};
    case RemarkCode::noRelease:
      return {"no-release", words("the log holds no release stroke")};
    case RemarkCode::forceScaleDoubtful:
      return {
          "force-scale-doubtful",
          words("testers that write this format read forces off by up to 30 gf against other laboratories")};
    case RemarkCode::sameGraphSeveralTimes:
      return {"same-graph-several-times",
              words("the same graph is drawn %1 times (%2); the one on page %3 is taken, which reads best")};
    case RemarkCode::severalGraphs:
      return {"several-graphs", words("%1 graphs found; this is the most certain one (page %2, graph %3)")};
    case RemarkCode::doubted:
      return {"doubted", words("not beyond doubt: %1")};
    case RemarkCode::printedValueDiffers:
      return {"printed-value-differs", words("%1")};
    case RemarkCode::operatingPointNotPlaced:
      return {"operating-point-not-placed", words("an operating point is printed, but was not placed")};
    case RemarkCode::resetPointNotPlaced:
      return {"reset-point-not-placed", words("a reset point is printed, but was not placed")};
    case RemarkCode::releaseNotDrawn:
      return {"release-not-drawn", words("only the press was drawn by hand: the button has no release")};
    case RemarkCode::secondReadingTaken:
      return {"second-reading-taken", words("as it stands the page is not read for certain (%1): taken as "
                                            "two looks in other sizes read it")};
    case RemarkCode::endedByTimeLimit:
      return {"ended-by-time-limit",
              words("the limit of %1 s was reached: the best that was read until then is taken")};
  }
  return {"", ""};
}

}  // namespace

std::string_view nameOf(ImportStep step) {
  switch (step) {
    case ImportStep::read:
      return "read";
    case ImportStep::locate:
      return "locate";
    case ImportStep::view:
      return "view";
    case ImportStep::axes:
      return "axes";
    case ImportStep::texts:
      return "texts";
    case ImportStep::copies:
      return "copies";
    case ImportStep::trace:
      return "trace";
    case ImportStep::strokes:
      return "strokes";
    case ImportStep::refine:
      return "refine";
    case ImportStep::fit:
      return "fit";
    case ImportStep::callouts:
      return "callouts";
  }
  return "";
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
