// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/second_opinion.h"

#include <algorithm>
#include <array>
#include <utility>

#include "importer/assemble_report.h"
#include "importer/doubts.h"
#include "importer/graph_copies.h"

namespace detent::importer {
namespace {

/// Confidence of a certain reading that another certain one contradicts: below any limit that a person would
/// choose, but above 0, because one of them is usually right.
constexpr double contradictedConfidence = 0.4;
/// Of two certain readings that differ, the one with a confidence higher by this much is kept. Among 107
/// charts of foreign software, every differing pair was of this kind, and the one with the higher confidence
/// was right.
constexpr double surerBy = 0.1;
/// Pictures with more pixels are not enlarged to four times as many, or not at all, because of the cost of a
/// second reading.
constexpr double enlarged_px = 1.2e6, large_px = 6e6;

/// Doubts about the content of the page, which do not depend on how it was read.
constexpr std::array standOnThePage{DoubtCode::severalSwitches,  DoubtCode::tooManyCurves,
                                    DoubtCode::otherQuantity,    DoubtCode::axesExchanged,
                                    DoubtCode::otherScale,       DoubtCode::thousandsUnclear,
                                    DoubtCode::valueContradicts, DoubtCode::givenAgainstLabels,
                                    DoubtCode::factorPrinted,    DoubtCode::factorUnread};
/// Largest confidence of a reading that replaces another: below 0.9, from which on the confidence of a single
/// reading is guaranteed.
constexpr double takenAtMost = 0.8;
/// Factor of the confidence on a photograph on which three readings agree. Measured:
/// docs/develop/decisions/0812.
constexpr double worthOnPhotosReadAlike = 0.85;

double highest_N(const ImportReport& report) {
  return std::ranges::max(report.strokes.press.points, {}, &CurvePoint::force_N).force_N;
}

double travel_mm(const ImportReport& report) { return report.button.states().front().graph.travel_mm(); }

/// Short description that distinguishes one reading from another.
Message inShort(const ImportReport& report) {
  const MessageValue travel = shownTravel(*report.x, travel_mm(report)),
                     force = shownForce(*report.y, highest_N(report));
  if (!report.release) return Message("a travel of %1, forces up to %2 and no release", travel, force);
  return Message("a travel of %1 and forces up to %2", travel, force);
}

Doubt readingsDiffer(const ImportReport& first, const ImportReport& second) {
  return {DoubtCode::readingsDiffer,
          {inShort(first), inShort(second)},
          {{RemedyKind::giveXAxis, {}}, {RemedyKind::giveYAxis, {}}, {RemedyKind::pickPress, {}}}};
}

bool isPhotograph(const ImportReport& report) {
  return report.doubt && report.doubt->code == DoubtCode::pageIsPhoto;
}

bool isCertain(const ImportAttempt& attempt) { return attempt.report && !attempt.report->doubt; }

ReadingSummary summaryOf(const PageReading& reading) {
  ReadingSummary summary;
  summary.magnification = reading.magnification;
  const auto& report = reading.attempt.report;
  if (!report) {
    summary.problem = report.failure().problem;
    return summary;
  }
  summary.confidence = report->confidence;
  summary.travel_mm = travel_mm(*report), summary.highest_N = highest_N(*report);
  summary.release = report->release.has_value();
  if (report->doubt) summary.problem = messageOf(*report->doubt);
  return summary;
}

/// The report with its provenance adapted to the changed confidence and warnings.
ImportReport withProvenance(ImportReport report) {
  Provenance provenance = report.button.provenance().value_or(Provenance{});
  provenance.confidence = report.confidence;
  std::vector<RecordedWarning> warnings =
      recorded(report.remarks, report.doubt ? std::vector{*report.doubt} : std::vector<Doubt>());
  for (RecordedWarning& before : provenance.warnings) {  // also the other doubts of the reading
    const auto says = [&](const RecordedWarning& now) { return now.text.starts_with(before.text); };
    if (std::ranges::none_of(warnings, says)) warnings.push_back(std::move(before));
  }
  provenance.warnings = std::move(warnings);
  auto button = Button::fromStates(report.button.name(), report.button.states(), std::move(provenance));
  if (button) report.button = std::move(button).value();
  return report;
}

/// The report of a reading that another certain one contradicts.
ImportReport reportContradicted(ImportReport report, const ImportReport& other, double sure) {
  Doubt doubt = readingsDiffer(report, other);
  const bool surer = report.confidence >= other.confidence + surerBy;
  if (!surer) report.confidence = std::min(report.confidence, contradictedConfidence);
  if (report.confidence < sure)
    report.doubt = std::move(doubt);
  else
    report.remarks.push_back({RemarkCode::doubted, {messageOf(doubt)}, doubt.remedies});
  return withProvenance(std::move(report));
}

/// Returns true if another reading of a doubted photograph agrees and doubts nothing else.
bool agreesOnPhoto(const Result<ImportReport>& report, const ImportAttempt& other) {
  return report && isPhotograph(*report) && other.report &&
         (!other.report->doubt || isPhotograph(*other.report)) && sameButton(*report, *other.report);
}

/// Raises the confidence of a photograph on which several readings agree.
ImportReport readAlike(ImportReport report, double sure) {
  report.confidence *= worthOnPhotosReadAlike / worthOf(PageClass::photo);
  if (report.confidence < sure) return withProvenance(std::move(report));
  report.remarks.push_back({RemarkCode::doubted, {messageOf(*report.doubt)}, report.doubt->remedies});
  report.doubt.reset();
  return withProvenance(std::move(report));
}

ImportAttempt taken(PageReading chosen, std::vector<ReadingSummary> summaries) {
  if (!chosen.attempt.report) return std::move(chosen.attempt);
  for (ReadingSummary& summary : summaries) summary.taken = summary.magnification == chosen.magnification;
  chosen.attempt.report->readings = std::move(summaries);
  return std::move(chosen.attempt);
}

}  // namespace

OtherSizes otherSizesOf(const Page& page) {
  if (page.unit != PageUnit::pixel) return {1.5, 0.5};
  const double pixels = double(page.overview.width_px) * page.overview.height_px;
  if (pixels > large_px) return {0.5, 0.7};
  if (pixels > enlarged_px) return {0.7, 1.4};
  return {};
}

ImportReport withRemark(ImportReport report, Remark remark) {
  report.remarks.push_back(std::move(remark));
  return withProvenance(std::move(report));
}

bool sameButton(const ImportReport& a, const ImportReport& b) {
  if (a.x && b.x && (a.x->unit != b.x->unit || a.y->unit != b.y->unit)) return false;
  const auto apart = distanceBetween(a.strokes, b.strokes);
  return apart && *apart <= copiesWithin;
}

bool anotherMaySettle(const ImportAttempt& attempt) {
  const auto stands = [](std::string_view name) {
    return std::ranges::any_of(standOnThePage, [&](DoubtCode code) { return nameOf(code) == name; });
  };
  if (attempt.report) return !attempt.report->doubt || !stands(nameOf(attempt.report->doubt->code));
  const Failure& failure = attempt.report.failure();
  if (attempt.evidence && attempt.evidence->switches.size() > 1) return false;
  return failure.code == FailureCode::notCertain && !stands(failure.reason);
}

ImportAttempt settled(PageReading first, PageReading second, const std::function<PageReading()>& third,
                      double sure) {
  std::vector<ReadingSummary> summaries{summaryOf(first), summaryOf(second)};
  const auto& report = first.attempt.report;
  const auto& other = second.attempt.report;
  if (isCertain(first.attempt)) {
    if (isCertain(second.attempt) && !sameButton(*report, *other))
      first.attempt.report = reportContradicted(std::move(*first.attempt.report), *other, sure);
    return taken(std::move(first), std::move(summaries));
  }
  const bool alike = agreesOnPhoto(report, second.attempt);
  if (!anotherMaySettle(first.attempt) || (!alike && !isCertain(second.attempt)))
    return taken(std::move(first), std::move(summaries));
  const Message firstSaid = report ? inShort(*report) : first.attempt.report.failure().problem;
  const PageReading witness = third();
  summaries.push_back(summaryOf(witness));
  if (alike && agreesOnPhoto(report, witness.attempt)) {
    first.attempt.report = readAlike(std::move(*first.attempt.report), sure);
  } else if (sure <= takenAtMost && isCertain(second.attempt) && isCertain(witness.attempt) &&
             sameButton(*other, *witness.attempt.report)) {
    ImportReport& agreed = *second.attempt.report;
    agreed.confidence = std::min({agreed.confidence, witness.attempt.report->confidence, takenAtMost});
    agreed = withRemark(std::move(agreed), {RemarkCode::secondReadingTaken, {firstSaid}});
    return taken(std::move(second), std::move(summaries));
  }
  return taken(std::move(first), std::move(summaries));
}

}  // namespace detent::importer
