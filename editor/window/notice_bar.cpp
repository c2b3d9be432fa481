#include "editor/window/notice_bar.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>

#include "editor/document/graph_colors.h"

namespace detent::editor {
namespace {

QPalette paletteOf(const QPalette& window, NoticeBar::Kind kind) {
  const bool dark = isDark(window);
  QPalette palette = window;
  if (kind == NoticeBar::Kind::trouble)
    palette.setColor(QPalette::Window, dark ? QColor("#4d2a26") : QColor("#fbe6e2"));
  else
    palette.setColor(QPalette::Window, dark ? QColor("#25394a") : QColor("#e3eef8"));
  return palette;
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
  row->setPalette(paletteOf(palette(), kind));
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(10, 5, 6, 5);
  auto* label = new QLabel(text);
  label->setObjectName("noticeText");
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
  auto* close = new QToolButton;
  close->setObjectName("noticeClose");
  close->setAccessibleName(tr("Close this message"));
  close->setToolTip(tr("Close this message"));
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
    row->deleteLater();  // it may be its own button that is being pressed
  }
  setVisible(rows_->count() > 0);
}

QStringList NoticeBar::texts() const {
  QStringList all;
  for (int i = 0; i < rows_->count(); ++i)
    all << rows_->itemAt(i)->widget()->findChild<QLabel*>("noticeText")->text();
  return all;
}

}  // namespace detent::editor
