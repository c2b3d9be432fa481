// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/history_panel.h"

#include <QUndoView>
#include <QVBoxLayout>

namespace detent::editor {

HistoryPanel::HistoryPanel(ButtonDocument& document, QWidget* parent)
    : QWidget(parent), view_(new QUndoView(&document.history().stack())) {
  setObjectName(QStringLiteral("historyPanel"));
  view_->setObjectName(QStringLiteral("historyView"));
  view_->setAccessibleName(tr("Editing steps of this button"));
  view_->setToolTip(tr("Every editing step since the button was opened. Click one to return to it."));
  view_->setEmptyLabel(!document.path().isEmpty()       ? tr("Opened")
                       : document.button().provenance() ? tr("Imported")
                                                        : tr("New"));
  view_->setAlternatingRowColors(true);
  view_->setUniformItemSizes(true);
  view_->setTabKeyNavigation(false);  // Tab leaves the list, arrows move in it
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(view_);
  setFocusProxy(view_);
}

}  // namespace detent::editor
