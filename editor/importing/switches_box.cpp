// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/switches_box.h"

#include <algorithm>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "editor/importing/origin_mark.h"
#include "editor/importing/swatch.h"

namespace detent::editor {
namespace {

constexpr int curveRole = Qt::UserRole;
constexpr int rowsInSight = 6;

std::string curveOf(const QListWidgetItem& item) { return item.data(curveRole).toString().toStdString(); }

QListWidgetItem* itemOf(const SwitchChoice& choice, int number, const QPalette& palette) {
  const importer::PlotSwitch& itself = *choice.itself;
  std::vector<QColor> colors{colorFrom(itself.pressColor)};
  if (itself.releaseColor) colors.push_back(colorFrom(*itself.releaseColor));
  const QString name =
      itself.name.empty() ? SwitchesBox::tr("Switch %1").arg(number) : QString::fromStdString(itself.name);
  auto* item = new QListWidgetItem(swatchOf(colors, palette), name);
  item->setData(curveRole, QString::fromStdString(choice.curve));
  item->setToolTip(itself.releaseColor ? SwitchesBox::tr("%1: press and release").arg(name)
                                       : SwitchesBox::tr("%1: press only").arg(name));
  return item;
}

}  // namespace

SwitchesBox::SwitchesBox(ImportState& state, QWidget* parent)
    : QGroupBox(tr("Switches in this plot"), parent), state_(state), list_(new QListWidget) {
  setObjectName(QStringLiteral("switchesBox"));
  list_->setObjectName(QStringLiteral("switches"));
  list_->setAccessibleName(tr("Switches in this plot"));
  list_->setTabKeyNavigation(false);
  QLabel* hint = wrappedLabel();
  hint->setText(
      tr("Choose the switch to read. Ticked switches are imported together, each as a button of its own."));
  hint->setForegroundRole(QPalette::PlaceholderText);
  auto* column = new QVBoxLayout(this);
  column->addWidget(list_);
  column->addWidget(hint);
  connect(list_, &QListWidget::currentItemChanged, &state_, [this](QListWidgetItem* item) {
    if (!item) return;
    state_.correct(tr("Choose switch"), [curve = curveOf(*item)](Corrections& c) { c.curve = curve; });
  });
  connect(list_, &QListWidget::itemChanged, &state_, [this](QListWidgetItem* item) {
    state_.setCurveTicked(curveOf(*item), item->checkState() == Qt::Checked);
  });
  hide();
}

void SwitchesBox::follow() {
  const ImportGraph* graph = state_.current();
  const auto choices = graph ? graph->switches() : std::vector<SwitchChoice>{};
  setVisible(!choices.empty());
  if (!choices.empty()) fill(*graph, choices);
}

void SwitchesBox::fill(const ImportGraph& graph, const std::vector<SwitchChoice>& choices) {
  const QSignalBlocker quiet(list_);
  list_->clear();
  for (const SwitchChoice& choice : choices) {
    QListWidgetItem* item = itemOf(choice, list_->count() + 1, palette());
    item->setCheckState(graph.tickedCurves.contains(choice.curve) ? Qt::Checked : Qt::Unchecked);
    list_->addItem(item);
    if (choice.curve == graph.history.now().curve) list_->setCurrentItem(item);
  }
  fitHeight();
}

void SwitchesBox::fitHeight() {
  const int rows = std::min(list_->count(), rowsInSight);
  list_->setFixedHeight(rows * list_->sizeHintForRow(0) + 2 * list_->frameWidth());
}

}  // namespace detent::editor
