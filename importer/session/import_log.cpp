// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/session/import_log.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "importer/assemble_report.h"
#include "importer/doubts.h"
#include "importer/session/fit_strokes.h"
#include "importer/session/step_clock.h"
#include "importer/session/try_choices.h"

namespace detent::importer {
namespace {

/// The contact points recorded in a log, in the form of a page's callouts.
std::vector<Callout> contactPointsOf(const ForceLog& log) {
  std::vector<Callout> contacts;
  if (log.operatingPoint_mm)
    contacts.push_back({CalloutKind::operatingPoint, {*log.operatingPoint_mm, 0}, {}, 1, {}});
  if (log.resetPoint_mm) contacts.push_back({CalloutKind::resetPoint, {*log.resetPoint_mm, 0}, {}, 1, {}});
  return contacts;
}

LogHints logHintsOf(const ImportHints& hints) {
  return {hints.axes.xUnit,    hints.axes.yUnit, hints.strokes.swap,
          hints.strokes.curve, hints.columns,    hints.releasePath};
}

/// Mean distance of a stroke's samples from its fit, in force, as a share of its force span.
double misfitOf(const StrokePoints& stroke, const StrokeCurve& fitted) {
  if (stroke.points.size() < 2) return 0;
  const auto [lowest, highest] = std::ranges::minmax(stroke.points, {}, &CurvePoint::force_N);
  const double span_N = highest.force_N - lowest.force_N;
  if (!(span_N > 0)) return 0;
  const std::size_t every = std::max<std::size_t>(1, stroke.points.size() / 1000);
  double sum_N = 0, count = 0;
  for (std::size_t i = 0; i < stroke.points.size(); i += every) {
    const CurvePoint& p = stroke.points[i];
    if (p.displacement_mm < fitted.start_mm() || p.displacement_mm > fitted.end_mm()) continue;
    // At a jump the forces of both sides are right.
    sum_N += std::min(std::abs(fitted.force_N(p.displacement_mm) - p.force_N),
                      std::abs(fitted.forceBefore_N(p.displacement_mm) - p.force_N));
    count += 1;
  }
  return count > 0 ? sum_N / count / span_N : 1;
}

/// Misfit as a factor of the confidence: 1 up to a hundredth of the span, 0 from a twentieth on.
double fitConfidence(const StrokePair& strokes, const FittedStrokes& fitted) {
  constexpr double right = 0.01, wrong = 0.05;  // share of the force span
  double misfit = misfitOf(strokes.press, fitted.press.curve);
  if (strokes.release && fitted.release)
    misfit = std::max(misfit, misfitOf(*strokes.release, fitted.release->curve));
  return std::clamp((wrong - misfit) / (wrong - right), 0.0, 1.0);
}

/// `seconds`: of the steps before; the fit adds its own.
Result<ImportReport> reportOfLog(Result<ForceLog> log, const std::optional<Question>& question,
                                 const std::string& fileName, const ImportRequest& request,
                                 StepSeconds seconds) {
  if (!log) return log.failure();
  const QualitySettings settings = settingsFor(request.quality);
  const FitOptions options = fitOptionsFor(settings.fit, {log->noise_mm, log->noise_N});
  auto fitted = [&] {
    StepClock time(seconds, ImportStep::fit);
    return fitBoth(log->strokes, options, options);
  }();
  if (!fitted) {
    Failure f = fitted.failure();
    f.subject = fileName;
    return f;
  }
  Provenance provenance;
  provenance.sourceFile = fileName;
  provenance.quality = nameOf(request.quality);
  provenance.confidence = log->confidence * fitConfidence(log->strokes, *fitted);
  provenance.given = givenByHand(request.hints);
  const bool isAmbiguous = question && log->confidence < request.sure;
  const bool isNoLog = log->confidence < request.sure, isBadFit = provenance.confidence < request.sure;
  std::optional<Doubt> gravest;
  for (const WeighedDoubt& each : doubtsOfLog(log->strokes, *fitted, request.hints)) {
    if (each.confidence < request.sure && (!gravest || each.confidence < provenance.confidence))
      gravest = each.doubt;
    if (each.confidence >= request.sure)
      log->remarks.push_back({RemarkCode::doubted, {messageOf(each.doubt)}, each.doubt.remedies});
    provenance.confidence = std::min(provenance.confidence, each.confidence);
  }
  // Impossible values are a better reason for a refusal than an unlikely log. Ambiguity comes first, because
  // the user can resolve it.
  if (isAmbiguous)
    gravest = Doubt{DoubtCode::assumed,
                    {Message("the table can be read in several ways: %1", question->what)},
                    Message("Choose one of these")};
  else if (!gravest && (isNoLog || isBadFit))
    gravest = Doubt{DoubtCode::assumed,
                    {isNoLog ? Message("the table does not look like a measurement of a button")
                             : Message("the fitted curve deviates from the measured values")},
                    Message("Check the values, or accept a lower confidence")};
  if (gravest && !request.acceptDoubt) {
    return failureOf(*gravest, fileName);
  }
  provenance.warnings = recorded(log->remarks, gravest ? std::vector{*gravest} : std::vector<Doubt>());
  auto button =
      buttonFrom(std::filesystem::path(fileName).stem().string(), *fitted, contactPointsOf(*log), provenance);
  if (!button) return button.failure();
  ImportReport report(std::move(button).value());
  report.strokes = std::move(log->strokes);
  report.press = {fitted->press.summary, 0};
  if (fitted->release) report.release = StrokeReport{fitted->release->summary, 0};
  report.confidence = report.button.provenance()->confidence;
  report.doubt = std::move(gravest);
  report.quality = request.quality;
  report.remarks = std::move(log->remarks);
  report.pressSpeed = log->pressSpeed, report.releaseSpeed = log->releaseSpeed;
  report.seconds = std::move(seconds);
  return report;
}

}  // namespace

ImportAttempt importLog(const std::string& path, const ImportRequest& request, const Progress& progress) {
  const std::string fileName = std::filesystem::path(path).filename().string();
  StepSeconds seconds;
  LogReading reading = [&] {
    StepClock time(seconds, ImportStep::read);
    return readLog(path, logHintsOf(request.hints), progress);
  }();
  ImportAttempt attempt{reportOfLog(std::move(reading.log), reading.question, fileName, request, seconds),
                        {},
                        {},
                        std::move(reading.best)};
  const bool unsettled = attempt.report ? attempt.report->doubt.has_value()
                                        : attempt.report.failure().code == FailureCode::notCertain;
  if (!unsettled || !reading.question || progress.isCancelled()) return attempt;
  // Choices are tried as drafts, because the level changes how a log is fitted, not how it is read.
  const auto isAccepted = [&](ImportRequest answered) {
    answered.quality = Quality::draft;
    LogReading tried = readLog(path, logHintsOf(answered.hints), progress);
    return reportOfLog(std::move(tried.log), tried.question, fileName, answered, {}).ok();
  };
  attempt.question = withAcceptedChoices(*reading.question, request, progress, isAccepted);
  return attempt;
}

Result<std::vector<ListedRecord>> recordsOfLog(const std::string& path, const ImportHints& hints,
                                               const Progress& progress) {
  LogReading reading = readLog(path, logHintsOf(hints), progress);
  if (reading.records.empty() && !reading.log) return reading.log.failure();
  return std::move(reading.records);
}

}  // namespace detent::importer
