// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/operation_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include "editor/document/graph_colors.h"
#include "editor/document/message_words.h"
#include "editor/quantity/quantity_field.h"

namespace detent::editor {
namespace {

constexpr int slowPause_ms = 180;

Quantity quantityOf(FieldKind kind) {
  switch (kind) {
    case FieldKind::length:
      return Quantity::length;
    case FieldKind::force:
      return Quantity::force;
    case FieldKind::damping:
      return Quantity::damping;
    case FieldKind::ratio:
      return Quantity::share;
    case FieldKind::count:
      return Quantity::count;
    default:
      return Quantity::number;
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
  auto* number = new QuantityField(quantityOf(field.kind), settings_.units());
  number->setRange({field.minimum, field.maximum});
  number->setValue(field.value);
  number->setToolTip(field.tip);
  number->setAccessibleName(field.name);
  connect(number, &QuantityField::valueChanged, this, &OperationDialog::fieldChanged);
  connect(number, &QuantityField::refusalChanged, this, &OperationDialog::fieldChanged);
  editors_.push_back(number);
  return number;
}

std::vector<double> OperationDialog::values() const {
  std::vector<double> values;
  for (const QWidget* editor : editors_) {
    if (const auto* choice = qobject_cast<const QComboBox*>(editor))
      values.push_back(choice->currentIndex());
    else
      values.push_back(static_cast<const QuantityField*>(editor)->value());
  }
  return values;
}

void OperationDialog::setValue(std::size_t field, double value) {
  if (auto* choice = qobject_cast<QComboBox*>(editors_[field])) {
    choice->setCurrentIndex(static_cast<int>(value));
    return;
  }
  static_cast<QuantityField*>(editors_[field])->setValue(value);
  fieldChanged();
}

// Refusal of the first field whose text cannot be read.
QString OperationDialog::fieldRefusal() const {
  for (std::size_t i = 0; i < editors_.size(); ++i) {
    const auto* field = qobject_cast<const QuantityField*>(editors_[i]);
    if (field && !field->acceptable()) return tr("%1: %2").arg(operation_.fields[i].name, field->refusal());
  }
  return {};
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
  const QString unread = fieldRefusal();
  refusal_->setText(!unread.isEmpty() ? unread
                    : next            ? QString()
                                      : sentenceOf(next.failure(), settings_.units()));
  accept_->setEnabled(unread.isEmpty() && next.ok());
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
