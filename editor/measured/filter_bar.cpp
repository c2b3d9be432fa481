// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/measured/filter_bar.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "editor/document/described.h"
#include "editor/document/graph_colors.h"
#include "editor/measured/measured_words.h"
#include "editor/panels/key_figures_model.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

constexpr std::size_t mostRanges = 6;  // number of ranges that are visible at once

}  // namespace

FilterBar::FilterBar(const DisplayUnits& units, QWidget* parent) : QWidget(parent), units_(units) {
  words_ = described(new QLineEdit, "measuredWords",
                     tr("Show only switches with these words in name, credit, licence or file"),
                     tr("Words to search for"));
  words_->setPlaceholderText(tr("Search: maker, name, credit \u2026"));
  words_->setClearButtonEnabled(true);
  kind_ = described(new QComboBox, "measuredKind", tr("Show only switches of this kind"), tr("Kind"));
  kind_->addItem(tr("all kinds"));
  using importer::SwitchKind;
  for (const SwitchKind kind : {SwitchKind::linear, SwitchKind::between, SwitchKind::tactile})
    kind_->addItem(kindWords(kind), static_cast<int>(kind));
  add_ = described(new QPushButton(tr("Filter by key &figure…")), "measuredAddRange",
                   tr("Show only switches with a key figure within limits that you choose"));
  auto* first = new QHBoxLayout;
  first->addWidget(words_, 1);
  first->addWidget(kind_);
  first->addWidget(add_);
  rows_ = new QVBoxLayout(this);
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->addLayout(first);
  connect(words_, &QLineEdit::textChanged, this, &FilterBar::changed);
  connect(kind_, &QComboBox::currentIndexChanged, this, &FilterBar::changed);
  connect(add_, &QPushButton::clicked, this, [this] {
    addRange();
    ranges_.back().figure->setFocus();
  });
}

QLineEdit* FilterBar::endOf(const char* name, const QString& hint) {
  auto* end = described(new QLineEdit, name, {}, hint);
  end->setPlaceholderText(hint);
  connect(end, &QLineEdit::textChanged, this, [this] {
    check();
    emit changed();
  });
  return end;
}

void FilterBar::addRange() {
  Range range;
  range.figure = described(new QComboBox, "measuredFigure", {}, tr("Figure"));
  for (const KeyFigureName& name : keyFigureNames())
    range.figure->addItem(figureTitle(name.figure, units_), static_cast<int>(name.figure));
  range.figure->setCurrentIndex(static_cast<int>(KeyFigure::peakForce));
  range.low = endOf("measuredLeast", tr("at least"));
  range.high = endOf("measuredMost", tr("at most"));
  auto* away = described(new QToolButton, "measuredRemoveRange", tr("Remove this condition"),
                         tr("Remove this condition"));
  away->setText(QStringLiteral("\u00d7"));
  away->setAutoRaise(true);
  range.row = new QWidget;
  auto* layout = new QHBoxLayout(range.row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(range.figure);
  layout->addWidget(range.low);
  layout->addWidget(new QLabel(QStringLiteral("\u2026")));
  layout->addWidget(range.high);
  layout->addWidget(away);
  layout->addStretch();
  rows_->addWidget(range.row);
  connect(range.figure, &QComboBox::currentIndexChanged, this, [this] {
    check();
    emit changed();
  });
  connect(away, &QToolButton::clicked, this, [this, row = range.row] { remove(row); });
  ranges_.push_back(range);
  add_->setEnabled(ranges_.size() < mostRanges);
}

void FilterBar::remove(QWidget* row) {
  std::erase_if(ranges_, [&](const Range& each) { return each.row == row; });
  row->hide();
  row->deleteLater();  // later, because the click comes from a button inside this row
  add_->setEnabled(true);
  emit changed();
}

std::optional<double> FilterBar::read(QLineEdit& end, KeyFigure figure) const {
  const QString text = end.text().trimmed();
  QString refusal;
  std::optional<double> value;
  if (!text.isEmpty()) {
    const QuantityReading reading = readQuantity(text, quantityOf(figure), units_);
    value = reading.value;
    if (!value) refusal = refusalOf(reading, quantityOf(figure), units_);
  }
  QPalette colors;
  if (!refusal.isEmpty()) colors.setColor(QPalette::Text, graphColors(isDark(palette())).refused);
  end.setPalette(colors);
  end.setToolTip(refusal);
  end.setAccessibleDescription(refusal);
  return value;
}

void FilterBar::check() {
  for (const Range& range : ranges_) {
    const auto figure = static_cast<KeyFigure>(range.figure->currentData().toInt());
    read(*range.low, figure);
    read(*range.high, figure);
  }
}

SwitchFilter FilterBar::filter() const {
  SwitchFilter filter;
  filter.words = words_->text();
  if (kind_->currentIndex() > 0)
    filter.kind = static_cast<importer::SwitchKind>(kind_->currentData().toInt());
  for (const Range& each : ranges_) {
    importer::FigureRange range;
    range.figure = static_cast<KeyFigure>(each.figure->currentData().toInt());
    const auto low = read(*each.low, range.figure), high = read(*each.high, range.figure);
    if (!low && !high) continue;
    range.low = low.value_or(range.low);
    range.high = high.value_or(range.high);
    filter.ranges.push_back(range);
  }
  return filter;
}

// The limits stay, so their numbers change.
void FilterBar::setUnits(const DisplayUnits& units) {
  constexpr int digits = 12;  // so that 24 is 24 again in the first unit
  for (const Range& range : ranges_) {
    const auto figure = static_cast<KeyFigure>(range.figure->currentData().toInt());
    for (QLineEdit* end : {range.low, range.high})
      if (const auto value = readQuantity(end->text(), quantityOf(figure), units_).value) {
        const QSignalBlocker quiet(end);
        end->setText(quantityText(*value, quantityOf(figure), units, digits));
      }
    for (const KeyFigureName& name : keyFigureNames())
      range.figure->setItemText(static_cast<int>(name.figure), figureTitle(name.figure, units));
  }
  units_ = units;
  check();
  emit changed();
}

bool FilterBar::empty() const {
  const SwitchFilter now = filter();
  return now.words.trimmed().isEmpty() && !now.kind && now.ranges.empty();
}

void FilterBar::clear() {
  words_->clear();
  kind_->setCurrentIndex(0);
  while (!ranges_.empty()) remove(ranges_.back().row);
}

}  // namespace detent::editor
