// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/advice_bar.h"

#include <algorithm>
#include <QStyle>
#include <QVBoxLayout>

#include "editor/document/graph_colors.h"
#include "editor/quantity/offered_units.h"

namespace detent::editor {
namespace {

constexpr int columns = 4;  // columns of buttons

void removeAll(QGridLayout& buttons) {
  while (QLayoutItem* item = buttons.takeAt(0)) {
    if (item->widget()) item->widget()->deleteLater();
    delete item;
  }
}

}  // namespace

AdviceBar::AdviceBar(QWidget* parent)
    : QFrame(parent),
      mark_(new QLabel),
      words_(new QLabel),
      question_(new QLabel),
      units_(new QGridLayout),
      buttons_(new QGridLayout) {
  setObjectName(QStringLiteral("adviceBar"));
  setAccessibleName(tr("Message about the import"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 8, 12, 8);
  row->addWidget(mark_, 0, Qt::AlignTop);
  auto* column = new QVBoxLayout;
  words_->setWordWrap(true);
  words_->setTextFormat(Qt::RichText);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(words_);
  question_->setWordWrap(true);
  column->addWidget(question_);
  for (QGridLayout* each : {units_, buttons_}) {
    column->addLayout(each);
    each->setColumnStretch(columns, 1);
  }
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
  removeAll(*units_);
  removeAll(*buttons_);
  addButtons(advice.remedies);
  show();
}

// If the units of both axes are missing, one is requested first; its answer leads to the question for the
// other.
void AdviceBar::addButtons(const std::vector<RemedyKind>& remedies) {
  unit_ = button_ = 0;
  const auto isUnit = [](RemedyKind remedy) {
    return remedy == RemedyKind::giveXUnit || remedy == RemedyKind::giveYUnit;
  };
  const auto unit = std::ranges::find_if(remedies, isUnit);
  question_->setVisible(unit != remedies.end());
  if (unit != remedies.end()) {
    *unit == RemedyKind::giveXUnit ? addLengthUnits() : addForceUnits();
    addNoUnit(*unit);
  }
  QStringList made;
  for (const RemedyKind remedy : remedies) {
    const QString name = textOnButton(remedy);
    if (isUnit(remedy) || made.contains(name)) continue;
    made << name;
    connect(addButton(name), &QPushButton::clicked, this, [this, remedy] { emit remedyChosen(remedy); });
  }
}

QPushButton* AdviceBar::addButton(const QString& text) {
  auto* button = new QPushButton(text);
  button->setAutoDefault(false);
  buttons_->addWidget(button, button_ / columns, button_ % columns, Qt::AlignLeft);
  ++button_;
  return button;
}

QPushButton* AdviceBar::addUnit(const QString& symbol, const char* name) {
  auto* button = new QPushButton(symbol);
  button->setObjectName(QLatin1String(name) + symbol);
  button->setAutoDefault(false);
  units_->addWidget(button, unit_ / columns, unit_ % columns);
  ++unit_;
  return button;
}

// A button for axes that measure neither force nor displacement; it leads to a refusal.
void AdviceBar::addNoUnit(RemedyKind question) {
  auto* none = new QPushButton(tr("None of these: another quantity"));
  none->setObjectName(QStringLiteral("otherQuantity"));
  none->setAutoDefault(false);
  units_->addWidget(none, (unit_ + columns - 1) / columns, 0, 1, -1, Qt::AlignLeft);
  connect(none, &QPushButton::clicked, this, [this, question] { emit otherQuantityChosen(question); });
}

// Offers every unit, so that the printed one is never missing.
void AdviceBar::addLengthUnits() {
  question_->setText(tr("Which unit is the displacement axis in?"));
  for (const LengthUnit unit : offeredLengthUnits) {
    QPushButton* button = addUnit(DisplayUnits{unit, {}}.lengthSymbol(), "lengthUnit_");
    connect(button, &QPushButton::clicked, this, [this, unit] { emit lengthUnitChosen(unit); });
  }
}

void AdviceBar::addForceUnits() {
  question_->setText(tr("Which unit is the force axis in?"));
  for (const ForceUnit unit : offeredForceUnits) {
    QPushButton* button = addUnit(DisplayUnits{{}, unit}.forceSymbol(), "forceUnit_");
    connect(button, &QPushButton::clicked, this, [this, unit] { emit forceUnitChosen(unit); });
  }
}

void AdviceBar::clear() {
  said_.clear();
  hide();
}

}  // namespace detent::editor
