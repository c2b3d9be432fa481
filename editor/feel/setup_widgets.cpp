// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/setup_widgets.h"

#include <QDir>
#include <QFormLayout>
#include <QLabel>

#include "editor/document/described.h"

namespace detent::editor {

QFormLayout* setupForm(QWidget* page) {
  auto* form = new QFormLayout(page);
  form->setContentsMargins(0, 4, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->setVerticalSpacing(5);
  return form;
}

void select(QComboBox* box, const QVariant& value) {
  const int at = box->findData(value);
  if (at >= 0) box->setCurrentIndex(at);
}

QLabel* noteLabel(const QString& name) {
  auto* label = described(new QLabel, name);
  label->setWordWrap(true);
  QFont font = label->font();
  font.setPointSizeF(0.88 * font.pointSizeF());
  label->setFont(font);
  label->setForegroundRole(QPalette::PlaceholderText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QWidget* rowOf(std::initializer_list<QWidget*> widgets) {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  bool first = true;
  for (QWidget* widget : widgets) {
    layout->addWidget(widget, first ? 1 : 0);
    first = false;
  }
  return row;
}

QStringList serialPorts() {
  QStringList ports;
  const QDir devices(QStringLiteral("/dev"));
  for (const QString& name :
       devices.entryList({"ttyACM*", "ttyUSB*", "ttyAMA*", "cu.usb*"}, QDir::System, QDir::Name))
    ports << devices.filePath(name);
  return ports;
}

QComboBox* comboBox(const QString& name, const QString& tip) { return described(new QComboBox, name, tip); }

QComboBox* comboBoxOfNames(const QString& name, const QString& tip) {
  constexpr int leastCharacters = 12;
  QComboBox* box = comboBox(name, tip);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(leastCharacters);
  return box;
}

}  // namespace detent::editor
