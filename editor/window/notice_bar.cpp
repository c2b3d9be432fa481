// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/notice_bar.h"

#include <QAccessible>
#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>

#include "editor/document/described.h"
#include "editor/document/graph_colors.h"

namespace detent::editor {
namespace {

// Changes only the background; text and buttons keep the program's style.
void paintNoticeBackground(QFrame& row) {
  const bool trouble = row.property("trouble").toBool();
  QPalette palette;
  if (isDark(QApplication::palette()))
    palette.setColor(QPalette::Window, trouble ? QColor("#4d2a26") : QColor("#25394a"));
  else
    palette.setColor(QPalette::Window, trouble ? QColor("#fbe6e2") : QColor("#e3eef8"));
  row.setPalette(palette);
}

}  // namespace

NoticeBar::NoticeBar(QWidget* parent) : QWidget(parent), rows_(new QVBoxLayout(this)) {
  setObjectName("notices");
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(1);
  hide();
}

QFrame* NoticeBar::rowOf(const QString& id) const {
  for (int i = 0; i < rows_->count(); ++i)
    if (rows_->itemAt(i)->widget()->property("noticeId") == id)
      return qobject_cast<QFrame*>(rows_->itemAt(i)->widget());
  return nullptr;
}

void NoticeBar::say(const QString& id, Kind kind, const QString& text, const std::vector<Choice>& choices) {
  dismiss(id);
  auto* row = new QFrame;
  row->setProperty("noticeId", id);
  row->setAutoFillBackground(true);
  row->setProperty("trouble", kind == Kind::trouble);
  paintNoticeBackground(*row);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(10, 5, 6, 5);
  auto* label = described(new QLabel(text), "noticeText");
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout->addWidget(label, 1);
  for (const Choice& choice : choices) {
    auto* button = new QPushButton(choice.text);
    button->setObjectName(choice.objectName);
    connect(button, &QPushButton::clicked, this, [this, id, act = choice.act] {
      dismiss(id);
      act();
    });
    layout->addWidget(button);
  }
  auto* close = described(new QToolButton, "noticeClose", tr("Close this message"), tr("Close this message"));
  close->setAutoRaise(true);
  close->setIcon(style()->standardIcon(QStyle::SP_TitleBarCloseButton));
  connect(close, &QToolButton::clicked, this, [this, id] { dismiss(id); });
  layout->addWidget(close);
  rows_->addWidget(row);
  show();
  QAccessibleEvent announced(label, QAccessible::Alert);
  QAccessible::updateAccessibility(&announced);
}

void NoticeBar::dismiss(const QString& id) {
  if (QFrame* row = rowOf(id)) {
    rows_->removeWidget(row);
    row->hide();
    row->deleteLater();  // later, because the click may come from a button inside this row
  }
  setVisible(rows_->count() > 0);
}

void NoticeBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  for (int i = 0; i < rows_->count(); ++i)
    paintNoticeBackground(*qobject_cast<QFrame*>(rows_->itemAt(i)->widget()));
}

QStringList NoticeBar::texts() const {
  QStringList all;
  for (int i = 0; i < rows_->count(); ++i)
    all << rows_->itemAt(i)->widget()->findChild<QLabel*>("noticeText")->text();
  return all;
}

}  // namespace detent::editor
