// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/welcome_page.h"

#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "editor/document/form_widgets.h"
#include "editor/files/recent_files.h"

namespace detent::editor {
namespace {

constexpr int column_px = 460;

QLabel* line(const QString& text, double sizeFactor, bool bold) {
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setPointSizeF(font.pointSizeF() * sizeFactor);
  font.setBold(bold);
  label->setFont(font);
  label->setWordWrap(true);
  return label;
}

}  // namespace

WelcomePage::WelcomePage(const QList<QAction*>& ways, QWidget* parent) : QWidget(parent) {
  setObjectName("welcomePage");
  auto* column = new QWidget;
  column->setMaximumWidth(column_px);
  auto* layout = new QVBoxLayout(column);
  layout->setSpacing(10);
  layout->addStretch(2);
  layout->addWidget(line(tr("Drop a datasheet here"), 1.7, true));
  layout->addWidget(line(tr("A picture, a PDF, an SVG, a force meter's CSV, or a button file. Detent reads "
                            "the force graph and turns it into a button you can edit and feel."),
                         1, false));
  layout->addSpacing(6);
  for (QAction* way : ways) {
    QPushButton* button = buttonOf(*way, "welcome_");
    button->setMinimumHeight(34);
    layout->addWidget(button);
  }
  recentSection_ = new QWidget;
  auto* recentLayout = new QVBoxLayout(recentSection_);
  recentLayout->setContentsMargins(0, 12, 0, 0);
  recentLayout->addWidget(line(tr("Recent files"), 1, true));
  recent_ = described(new QListWidget, "welcomeRecent", {}, tr("Recent files"));
  recent_->setFrameShape(QFrame::NoFrame);
  recent_->setMaximumHeight(170);
  recentLayout->addWidget(recent_);
  const auto choose = [this](const QListWidgetItem* item) {
    emit fileChosen(item->data(Qt::UserRole).toString());
  };
  connect(recent_, &QListWidget::itemActivated, this, choose);
  layout->addWidget(recentSection_);
  layout->addStretch(3);
  auto* inside = new QWidget;
  auto* middle = new QHBoxLayout(inside);
  middle->setContentsMargins(0, 0, 0, 0);
  middle->addStretch();
  middle->addWidget(column, column_px);
  middle->addStretch();
  auto* scrolled = new QScrollArea;  // scrolls on a small screen, because a window does not grow for it
  scrolled->setWidget(inside);
  scrolled->setWidgetResizable(true);
  scrolled->setFrameShape(QFrame::NoFrame);
  scrolled->setFocusPolicy(Qt::NoFocus);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->addWidget(scrolled);
  setRecent({});
}

void WelcomePage::setRecent(const QStringList& paths) {
  recent_->clear();
  const QStringList names = distinctNames(paths);
  for (int i = 0; i < paths.size(); ++i) {
    auto* item = new QListWidgetItem(names[i]);
    item->setData(Qt::UserRole, paths[i]);
    item->setToolTip(QDir::toNativeSeparators(paths[i]));
    recent_->addItem(item);
  }
  recentSection_->setVisible(!paths.isEmpty());
}

}  // namespace detent::editor
