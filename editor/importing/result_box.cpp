// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/result_box.h"

#include <QVBoxLayout>

#include "editor/importing/finding_words.h"
#include "editor/importing/origin_mark.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

constexpr int digits = 4;

QString timesOf(const std::map<importer::ImportStep, double>& secondsOfSteps) {
  QStringList times;
  double sum = 0;
  for (const auto& [step, seconds] : secondsOfSteps) {
    sum += seconds;
    if (seconds >= 0.0005)
      times << ResultBox::tr("%1 %2 ms").arg(nameOfWork(step)).arg(qRound(1000 * seconds));
  }
  return ResultBox::tr("Computed in %1 ms: %2").arg(qRound(1000 * sum)).arg(times.join(QStringLiteral(", ")));
}

}  // namespace

ResultBox::ResultBox(ViewSettings& settings, QWidget* parent)
    : QGroupBox(tr("Result"), parent),
      settings_(settings),
      result_(wrappedLabel()),
      checks_(wrappedLabel()),
      warnings_(wrappedLabel()),
      seconds_(wrappedLabel()) {
  auto* column = new QVBoxLayout(this);
  for (QLabel* each : {result_, checks_, warnings_, seconds_}) column->addWidget(each);
  result_->setObjectName(QStringLiteral("result"));
  checks_->setObjectName(QStringLiteral("specChecks"));
  warnings_->setObjectName(QStringLiteral("warnings"));
  seconds_->setObjectName(QStringLiteral("seconds"));
  seconds_->setForegroundRole(QPalette::PlaceholderText);
}

void ResultBox::follow(const importer::ImportReport* report, const std::vector<Failure>& refusedMarks) {
  setVisible(report != nullptr);
  if (!report) return;
  showChecks(*report, refusedMarks);
  result_->setText(textOf(*report));
  seconds_->setText(timesOf(report->seconds));
}

void ResultBox::showChecks(const importer::ImportReport& report, const std::vector<Failure>& refusedMarks) {
  QStringList checks, warnings;
  for (const auto& check : report.specChecks) {
    const QString mark = check.agrees ? QStringLiteral("✓ ") : QStringLiteral("✗ ");
    checks << mark + inWords(messageOf(check), settings_.units());
  }
  for (const auto& remark : report.remarks) {
    const bool amongChecks = remark.code == importer::RemarkCode::printedValueDiffers;
    if (!amongChecks) warnings << QStringLiteral("⚠ ") + inWords(remark, settings_.units());
  }
  for (const Failure& refused : refusedMarks)
    warnings << QStringLiteral("⚠ ") + tr("One of the points that you set was left out: %1")
                                           .arg(sentenceOf(refused, settings_.units()));
  checks_->setText(checks.isEmpty() ? QString() : tr("Printed on the page:\n%1").arg(checks.join('\n')));
  checks_->setVisible(!checks.isEmpty());
  warnings_->setText(warnings.join('\n'));
  warnings_->setVisible(!warnings.isEmpty());
}

QString ResultBox::strokeText(const QString& name, const importer::StrokeReport& stroke) const {
  const DisplayUnits& units = settings_.units();
  QString text = stroke.fit.pieces == 1 ? tr("%1: 1 piece").arg(name)
                                        : tr("%1: %2 pieces").arg(name).arg(stroke.fit.pieces);
  if (stroke.rms_px > 0) text += tr(", deviation %1 px").arg(numberText(stroke.rms_px, 2));
  for (const auto& fitted : stroke.fit.tactilePoints)
    text += tr("\n   tactile point %1, %2")
                .arg(quantityWithUnit(fitted.point.displacement_mm, Quantity::length, units, digits),
                     quantityWithUnit(fitted.point.force_N, Quantity::force, units, digits));
  return stroke.fit.tactilePoints.empty() ? text + tr(", no tactile point") : text;
}

QString ResultBox::textOf(const importer::ImportReport& report) const {
  const auto length = [&](double mm) {
    return quantityWithUnit(mm, Quantity::length, settings_.units(), digits);
  };
  QStringList lines{tr("Total travel %1").arg(length(report.button.states().front().graph.travel_mm()))};
  lines << strokeText(tr("Press"), report.press);
  lines << (report.release ? strokeText(tr("Release"), *report.release) : tr("No release curve"));
  for (const auto& callout : report.callouts) {
    const bool operating = callout.kind == importer::CalloutKind::operatingPoint;
    lines << tr("%1 %2").arg(operating ? tr("Operating point") : tr("Reset point"),
                             length(callout.at.displacement_mm));
  }
  const bool onPage = !report.strokes.press.points_px.empty();
  if (onPage)
    lines << tr("On the page you can drag or delete these points. Right-click the curve to add one.");
  return lines.join('\n');
}

}  // namespace detent::editor
