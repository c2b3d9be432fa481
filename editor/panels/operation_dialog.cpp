// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/operation_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include "editor/document/graph_colors.h"
#include "editor/document/message_words.h"

namespace detent::editor {
namespace {

constexpr int slowPause_ms = 180;

int digitsOf(FieldKind kind) {
  switch (kind) {
    case FieldKind::length:
      return 3;
    case FieldKind::force:
      return 2;
    case FieldKind::damping:
      return 4;
    case FieldKind::count:
      return 0;
    default:
      return 3;
  }
}

}  // namespace

OperationDialog::OperationDialog(ButtonDocument& document, ViewSettings& settings, Operation operation,
                                 QWidget* parent)
    : QDialog(parent),
      document_(document),
      settings_(settings),
      operation_(std::move(operation)),
      refusal_(new QLabel),
      pause_(new QTimer(this)) {
  setObjectName(QStringLiteral("operationDialog"));
  setWindowTitle(operation_.title);
  setWindowModality(Qt::WindowModal);
  setAttribute(Qt::WA_DeleteOnClose);
  auto* layout = new QVBoxLayout(this);
  auto* explanation = new QLabel(operation_.explanation);
  explanation->setWordWrap(true);
  explanation->setMinimumWidth(340);
  layout->addWidget(explanation);
  auto* form = new QFormLayout;
  for (std::size_t i = 0; i < operation_.fields.size(); ++i)
    form->addRow(operation_.fields[i].name, makeField(i));
  layout->addLayout(form);
  refusal_->setObjectName(QStringLiteral("refusal"));
  refusal_->setWordWrap(true);
  QPalette colors = refusal_->palette();
  colors.setColor(QPalette::WindowText, graphColors(isDark(palette())).refused);
  refusal_->setPalette(colors);
  refusal_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  layout->addWidget(refusal_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  accept_ = buttons->button(QDialogButtonBox::Ok);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout->addWidget(buttons);
  pause_->setSingleShot(true);
  pause_->setInterval(slowPause_ms);
  connect(pause_, &QTimer::timeout, this, &OperationDialog::preview);
  document_.history().beginDrag(operation_.title);
  dragging_ = true;
  preview();
}

OperationDialog::~OperationDialog() {
  if (dragging_) document_.history().cancelDrag();
}

double OperationDialog::unitOf(FieldKind kind) const {
  const DisplayUnits& units = settings_.units();
  if (kind == FieldKind::length) return units.toMm(1);
  if (kind == FieldKind::force) return units.toN(1);
  return 1;
}

QWidget* OperationDialog::makeField(std::size_t index) {
  const OperationField& field = operation_.fields[index];
  if (field.kind == FieldKind::choice) {
    auto* choice = new QComboBox;
    choice->addItems(field.choices);
    choice->setCurrentIndex(static_cast<int>(field.value));
    choice->setToolTip(field.tip);
    choice->setAccessibleName(field.name);
    connect(choice, &QComboBox::currentIndexChanged, this, &OperationDialog::fieldChanged);
    editors_.push_back(choice);
    return choice;
  }
  auto* number = new QDoubleSpinBox;
  const double unit = unitOf(field.kind);
  number->setDecimals(digitsOf(field.kind));
  number->setRange(field.minimum / unit, field.maximum / unit);
  number->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  number->setValue(field.value / unit);
  number->setToolTip(field.tip);
  number->setAccessibleName(field.name);
  number->setKeyboardTracking(true);
  if (field.kind == FieldKind::length) number->setSuffix(" " + settings_.units().lengthSymbol());
  if (field.kind == FieldKind::force) number->setSuffix(" " + settings_.units().forceSymbol());
  if (field.kind == FieldKind::damping) number->setSuffix(QStringLiteral(" N·s/mm"));
  connect(number, &QDoubleSpinBox::valueChanged, this, &OperationDialog::fieldChanged);
  editors_.push_back(number);
  return number;
}

std::vector<double> OperationDialog::values() const {
  std::vector<double> values;
  for (std::size_t i = 0; i < editors_.size(); ++i) {
    if (const auto* choice = qobject_cast<const QComboBox*>(editors_[i]))
      values.push_back(choice->currentIndex());
    else
      values.push_back(static_cast<const QDoubleSpinBox*>(editors_[i])->value() *
                       unitOf(operation_.fields[i].kind));
  }
  return values;
}

void OperationDialog::setValue(std::size_t field, double value) {
  if (auto* choice = qobject_cast<QComboBox*>(editors_[field]))
    choice->setCurrentIndex(static_cast<int>(value));
  else
    static_cast<QDoubleSpinBox*>(editors_[field])->setValue(value / unitOf(operation_.fields[field].kind));
}

void OperationDialog::fieldChanged() {
  if (operation_.slow)
    pause_->start();
  else
    preview();
}

void OperationDialog::preview() {
  const Result<Button> next = operation_.edit(document_.history().committed(), values());
  if (next) document_.history().preview(*next);
  refusal_->setText(next ? QString() : sentenceOf(next.failure()));
  accept_->setEnabled(next.ok());
}

void OperationDialog::done(int result) {
  if (pause_->isActive()) {
    pause_->stop();
    preview();
  }
  if (result == QDialog::Accepted && !accept_->isEnabled()) return;
  if (dragging_) {
    dragging_ = false;
    if (result == QDialog::Accepted)
      document_.history().finishDrag();
    else
      document_.history().cancelDrag();
  }
  QDialog::done(result);
}

}  // namespace detent::editor
