// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Parts for the forms of the setup.

#include <initializer_list>
#include <QComboBox>
#include <QStringList>

class QFormLayout;
class QLabel;

namespace detent::editor {

/// The layout of a form on `page`: fields as wide as there is room, long rows wrapped.
QFormLayout* setupForm(QWidget* page);
/// Combo box for texts of Detent: as wide as the longest.
QComboBox* comboBox(const QString& name, const QString& tip);
/// Combo box for names of devices and ports, which may be of any length.
QComboBox* comboBoxOfNames(const QString& name, const QString& tip);
/// A small grey line below a field.
QLabel* noteLabel(const QString& name);
/// Widgets in a row; the first one takes the available width.
QWidget* rowOf(std::initializer_list<QWidget*> widgets);

template <class Value>
void addChoice(QComboBox* box, const QString& text, Value value, const QString& tip = {}) {
  box->addItem(text, QVariant::fromValue(value));
  if (!tip.isEmpty()) box->setItemData(box->count() - 1, tip, Qt::ToolTipRole);
}
/// Selects the entry with that value; does nothing if there is none.
void select(QComboBox* box, const QVariant& value);

/// Serial ports that a sensor or a force device can be behind.
QStringList serialPorts();

}  // namespace detent::editor
