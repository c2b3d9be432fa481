// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/advice_bar.h"

#include <algorithm>
#include <QStyle>
#include <QVBoxLayout>

#include "editor/document/graph_colors.h"
#include "editor/quantity/offered_units.h"

namespace detent::editor {

AdviceBar::AdviceBar(QWidget* parent)
    : QFrame(parent), mark_(new QLabel), words_(new QLabel), buttons_(new QHBoxLayout) {
  setObjectName(QStringLiteral("adviceBar"));
  setAccessibleName(tr("Message about the import"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 6, 10, 6);
  row->addWidget(mark_, 0, Qt::AlignTop);
  auto* column = new QVBoxLayout;
  words_->setWordWrap(true);
  words_->setTextFormat(Qt::RichText);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(words_);
  column->addLayout(buttons_);
  row->addLayout(column, 1);
  hide();
}

void AdviceBar::say(Tone tone, const Advice& advice) {
  QString text = QStringLiteral("<b>%1</b>").arg(advice.problem.toHtmlEscaped());
  if (!advice.remedy.isEmpty()) text += QStringLiteral("<br>%1").arg(advice.remedy.toHtmlEscaped());
  if (isVisibleTo(parentWidget()) && text == said_ && tone == tone_) return;
  said_ = text, tone_ = tone;
  words_->setText(text);
  words_->setAccessibleName(advice.problem + ' ' + advice.remedy);
  const auto icon = tone == Tone::fault   ? QStyle::SP_MessageBoxCritical
                    : tone == Tone::doubt ? QStyle::SP_MessageBoxWarning
                                          : QStyle::SP_MessageBoxInformation;
  mark_->setPixmap(style()->standardIcon(icon).pixmap(22, 22));
  QPalette colors = parentWidget() ? parentWidget()->palette() : palette();
  const bool dark = isDark(colors);
  const QColor background = tone == Tone::fault   ? (dark ? "#4a2326" : "#fdeaea")
                            : tone == Tone::doubt ? (dark ? "#463a1d" : "#fff5dc")
                                                  : (dark ? "#24384a" : "#e8f2fb");
  colors.setColor(QPalette::Window, background);
  setPalette(colors);
  while (QLayoutItem* item = buttons_->takeAt(0)) {
    if (item->widget()) item->widget()->deleteLater();
    delete item;
  }
  addButtons(advice.remedies);
  show();
}

void AdviceBar::addButtons(const std::vector<RemedyKind>& remedies) {
  QStringList made;
  for (const RemedyKind remedy : remedies) {
    const QString name = textOnButton(remedy);
    if (made.contains(name)) continue;
    made << name;
    if (remedy == RemedyKind::giveXUnit) {
      addLengthUnits();
      continue;
    }
    if (remedy == RemedyKind::giveYUnit) {
      addForceUnits();
      continue;
    }
    connect(addButton(name), &QPushButton::clicked, this, [this, remedy] { emit remedyChosen(remedy); });
  }
  buttons_->addStretch();
}

QPushButton* AdviceBar::addButton(const QString& text) {
  auto* button = new QPushButton(text);
  button->setAutoDefault(false);
  buttons_->addWidget(button);
  return button;
}

// Every unit is a click away: the printed one is never missing.
void AdviceBar::addLengthUnits() {
  for (const LengthUnit unit : offeredLengthUnits) {
    QPushButton* button = addButton(DisplayUnits{unit, {}}.lengthSymbol());
    button->setObjectName(QStringLiteral("lengthUnit_") + DisplayUnits{unit, {}}.lengthSymbol());
    connect(button, &QPushButton::clicked, this, [this, unit] { emit lengthUnitChosen(unit); });
  }
}

void AdviceBar::addForceUnits() {
  for (const ForceUnit unit : offeredForceUnits) {
    QPushButton* button = addButton(DisplayUnits{{}, unit}.forceSymbol());
    button->setObjectName(QStringLiteral("forceUnit_") + DisplayUnits{{}, unit}.forceSymbol());
    connect(button, &QPushButton::clicked, this, [this, unit] { emit forceUnitChosen(unit); });
  }
}

void AdviceBar::clear() {
  said_.clear();
  hide();
}

}  // namespace detent::editor
