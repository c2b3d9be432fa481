// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/shortcut_list.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QScrollBar>
#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QTreeView>
#include <QVBoxLayout>

#include "editor/document/described.h"

namespace detent::editor {
namespace {

QStandardItemModel* modelOf(const std::vector<ShortcutRow>& rows, QObject* parent) {
  auto* model = new QStandardItemModel(parent);
  model->setHorizontalHeaderLabels(
      {ShortcutDialog::tr("Action"), ShortcutDialog::tr("Keys"), ShortcutDialog::tr("Where")});
  for (const ShortcutRow& row : rows)
    model->appendRow(
        {new QStandardItem(row.name), new QStandardItem(row.keys), new QStandardItem(row.group)});
  return model;
}

}  // namespace

std::vector<ShortcutRow> shortcutRows(const QString& group, const QList<QAction*>& actions) {
  std::vector<ShortcutRow> rows;
  for (const QAction* action : actions) {
    if (action->shortcuts().isEmpty()) continue;
    QStringList keys;
    for (const QKeySequence& key : action->shortcuts()) keys << key.toString(QKeySequence::NativeText);
    rows.push_back(
        {group, action->iconText().remove(QStringLiteral("…")), keys.join(ShortcutDialog::tr(" or "))});
  }
  return rows;
}

ShortcutDialog::ShortcutDialog(const std::vector<ShortcutRow>& rows, QWidget* parent) : QDialog(parent) {
  setObjectName("shortcutDialog");
  setWindowTitle(tr("Keyboard shortcuts"));
  auto* search = described(new QLineEdit, "shortcutSearch", {}, tr("Search the shortcuts"));
  search->setPlaceholderText(tr("Search"));
  search->setClearButtonEnabled(true);
  auto* shown = new QSortFilterProxyModel(this);
  shown->setSourceModel(modelOf(rows, this));
  shown->setFilterKeyColumn(-1);
  shown->setFilterCaseSensitivity(Qt::CaseInsensitive);
  connect(search, &QLineEdit::textChanged, shown, &QSortFilterProxyModel::setFilterFixedString);
  auto* list = described(new QTreeView, "shortcutList", {}, tr("Keyboard shortcuts"));
  list->setModel(shown);
  list->setRootIsDecorated(false);
  list->setAlternatingRowColors(true);
  list->setEditTriggers(QAbstractItemView::NoEditTriggers);
  list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(search);
  layout->addWidget(list);
  layout->addWidget(buttons);
  constexpr int height_px = 560;
  list->header()->resizeSections(QHeaderView::ResizeToContents);
  const QMargins margins = layout->contentsMargins();
  const int beside_px = list->verticalScrollBar()->sizeHint().width() + 2 * list->frameWidth() +
                        margins.left() + margins.right();
  resize(list->header()->length() + beside_px, height_px);
}

}  // namespace detent::editor
