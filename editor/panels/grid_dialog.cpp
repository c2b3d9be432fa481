// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/grid_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>

namespace detent::editor {
namespace {

constexpr QuantityRange lengthSteps_mm{1e-4, 10}, forceSteps_N{1e-4, 100};

}  // namespace

GridDialog::GridDialog(ViewSettings& settings, QWidget* parent) : QDialog(parent), settings_(settings) {
  setObjectName(QStringLiteral("gridDialog"));
  setWindowTitle(tr("Steps of the snap grid"));
  auto* form = new QFormLayout(this);
  form->addRow(tr("&Displacement:"), field("gridLength", Quantity::length, &SnapSettings::gridLength_mm));
  form->addRow(tr("&Force:"), field("gridForce", Quantity::force, &SnapSettings::gridForce_N));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  form->addRow(buttons);
}

QuantityField* GridDialog::field(const char* name, Quantity quantity, double SnapSettings::*step) {
  auto* made = new QuantityField(quantity, settings_.units());
  made->setObjectName(QString::fromLatin1(name));
  made->setRange(quantity == Quantity::length ? lengthSteps_mm : forceSteps_N);
  made->setValue(settings_.snap().*step);
  const QString what = quantity == Quantity::length ? tr("Step of the grid along the displacement")
                                                    : tr("Step of the grid along the force");
  made->setToolTip(what);
  made->setAccessibleName(what);
  connect(made, &QuantityField::valueChanged, this, [this, step](double value) {
    SnapSettings snap = settings_.snap();
    snap.*step = value;
    settings_.setSnap(snap);
  });
  connect(&settings_, &ViewSettings::changed, made, [this, made] { made->setUnits(settings_.units()); });
  return made;
}

}  // namespace detent::editor
