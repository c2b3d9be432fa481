// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/session/import_plot.h"

#include <utility>

#include "importer/graph_question.h"
#include "importer/second_opinion.h"
#include "importer/session/try_choices.h"

namespace detent::importer {
namespace {

Failure tookTooLong(const KeptPages& pages, const TimeLimit& limit) {
  return pages.failure(
      FailureCode::unreadableInput, {},
      Message("nothing was read within the limit of %1 s", MessageValue(limit.seconds)),
      {{RemedyKind::advice, Message("Choose a lower quality")}, {RemedyKind::raiseLimit, {}}});
}

/// Judges a reading that was made with doubts accepted, for a caller who does not accept them.
ImportAttempt withDoubtsJudged(ImportAttempt attempt, const ImportRequest& request, const KeptPages& pages) {
  if (!attempt.report || !attempt.report->doubt || request.acceptDoubt) return attempt;
  Failure why = failureOf(*attempt.report->doubt, pages.fileName());
  why.place = pages.placeOfGraph(attempt.report->page, attempt.report->graph);
  attempt.report = std::move(why);
  return attempt;
}

/// Reads the page as it is and at other sizes, and combines the readings.
ImportAttempt readAgain(GraphReader& reader, const ImportRequest& request, const Progress& progress) {
  KeptPages& pages = reader.pages();
  ImportRequest openly = request;
  openly.acceptDoubt = true;
  double from = 0;
  Progress half = progress;
  if (progress.report)
    half.report = [&](double share, ImportStep step) { progress.report(from + 0.5 * share, step); };
  PlacedAttempt asItIs = reader.read(openly, 1, {}, half);
  PageReading first{1, std::move(asItIs.attempt)};
  const std::optional<GraphPlace> place = std::move(asItIs.place);
  if (progress.isCancelled()) return {pages.cancelled(), {}};
  if (!anotherMaySettle(first.attempt)) return withDoubtsJudged(std::move(first.attempt), request, pages);
  auto page = pages.page(place ? place->page : request.page.value_or(1), progress);
  // If a reading did not find the graph's page of a document, another size does not find it either.
  const bool anywhere = !place && !request.page && pages.count() > 1;
  if (anywhere || !page) return withDoubtsJudged(std::move(first.attempt), request, pages);
  const auto readAt = [&](double magnification) {
    return PageReading{magnification, reader.read(openly, magnification, place, half).attempt};
  };
  const OtherSizes sizes = otherSizesOf(**page);
  from = 0.5;
  PageReading second = readAt(sizes.second);
  const auto third = [&] { return readAt(sizes.third); };
  ImportAttempt best = settled(std::move(first), std::move(second), third, request.sure);
  if (progress.isCancelled()) return {pages.cancelled(), {}};
  if (best.report) best.report->seconds = reader.seconds();
  return withDoubtsJudged(std::move(best), request, pages);
}

}  // namespace

ImportAttempt importPlot(GraphReader& reader, const ImportRequest& request, const Progress& progress) {
  reader.startTiming();
  ImportAttempt attempt = settingsFor(request.quality).secondOpinion
                              ? readAgain(reader, request, progress)
                              : reader.read(request, 1, {}, progress).attempt;
  const bool late = request.timeLimit && request.timeLimit->passed() && !progress.isCancelled();
  if (!late) return attempt;
  if (attempt.report) {
    attempt.report->endedByTimeLimit = true;
    attempt.report = withRemark(std::move(*attempt.report),
                                {RemarkCode::endedByTimeLimit, {MessageValue(request.timeLimit->seconds)}});
  } else if (attempt.report.failure().code == FailureCode::cancelled) {
    attempt.report = tookTooLong(reader.pages(), *request.timeLimit);
  }
  return attempt;
}

std::optional<Question> openQuestion(GraphReader& reader, const ImportAttempt& attempt,
                                     const ImportRequest& request, const Progress& progress) {
  if (attempt.report) return {};
  const auto question = questionAbout(attempt.report.failure(), attempt.evidence.get(), request.hints);
  if (!question) return {};
  Progress silent;
  silent.cancelled = progress.cancelled;
  return withAcceptedChoices(*question, request, progress, [&](const ImportRequest& answered) {
    return importPlot(reader, answered, silent).report.ok();
  });
}

}  // namespace detent::importer
