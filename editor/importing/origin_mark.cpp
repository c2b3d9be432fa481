// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/origin_mark.h"

#include <QHBoxLayout>

namespace detent::editor {
namespace {

/// A label with one line if there is space, and several in a narrow panel.
class GivingWay : public QLabel {
 public:
  GivingWay() {
    setWordWrap(true);
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  }
  QSize sizeHint() const override {
    return {fontMetrics().horizontalAdvance(text()) + 2 * margin() + 2, QLabel::sizeHint().height()};
  }
};

}  // namespace

OriginMark::OriginMark(ImportState& state, const QString& name, const QString& label,
                       std::function<void(Corrections&)> reset, QWidget* parent)
    : QWidget(parent), words_(new GivingWay), reset_(new QToolButton) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(words_);
  row->addWidget(reset_);
  words_->setForegroundRole(QPalette::PlaceholderText);
  reset_->setText(tr("Reset"));
  reset_->setObjectName(name);
  reset_->setAutoRaise(true);
  reset_->setToolTip(tr("Restore the value that Detent found"));
  reset_->setAccessibleName(label);
  reset_->setVisible(false);
  connect(reset_, &QToolButton::clicked, &state,
          [&state, label, reset = std::move(reset)] { state.correct(label, reset); });
}

void OriginMark::setOrigin(bool given, std::optional<double> confidence) {
  reset_->setVisible(given);
  QFont font = words_->font();
  font.setBold(given);
  words_->setFont(font);
  words_->setText(given        ? tr("set by hand")
                  : confidence ? tr("found, %1 % sure").arg(qRound(100 * *confidence))
                               : QString());
}

const importer::StepFinding* stepOf(const std::shared_ptr<const importer::GraphEvidence>& evidence,
                                    importer::ImportStep step) {
  if (!evidence) return nullptr;
  for (const auto& each : evidence->steps) {
    if (each.step == step) return &each;
  }
  return nullptr;
}

std::optional<double> confidenceOf(const std::shared_ptr<const importer::GraphEvidence>& evidence,
                                   importer::ImportStep step) {
  const auto* found = stepOf(evidence, step);
  if (!found) return {};
  return found->confidence;
}

QLabel* wrappedLabel() {
  auto* label = new QLabel;
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  return label;
}

void reserveLines(QLabel& label, int lines) {
  label.setMinimumHeight(lines * label.fontMetrics().lineSpacing());
  label.setAlignment(Qt::AlignLeft | Qt::AlignTop);
}

}  // namespace detent::editor
