// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/library/average_dialog.h"

#include <QDialogButtonBox>
#include <QVBoxLayout>
#include <utility>

#include "editor/document/described.h"
#include "editor/document/message_words.h"
#include "model/sections.h"

namespace detent::editor {
namespace {

std::vector<std::size_t> tactilePointsOf(const Button& button) {
  std::vector<std::size_t> counts;
  for (const ButtonState& state : button.states())
    counts.push_back(tactilePoints(state.graph.press(), Stroke::press).size());
  return counts;
}

}  // namespace

AverageDialog::AverageDialog(std::vector<Button> buttons, const QStringList& titles, std::size_t current,
                             const DisplayUnits& units, QWidget* parent)
    : QDialog(parent),
      buttons_(std::move(buttons)),
      units_(units),
      list_(described(new QListWidget, "averageButtons", tr("Buttons to average"), tr("Buttons to average"))),
      why_(described(new QLabel, "averageRefusal")) {
  setObjectName(QStringLiteral("averageDialog"));
  setWindowTitle(tr("Average buttons"));
  const auto kind = tactilePointsOf(buttons_[current]);
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    auto* item = new QListWidgetItem(titles[static_cast<qsizetype>(i)], list_);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(tactilePointsOf(buttons_[i]) == kind ? Qt::Checked : Qt::Unchecked);
  }
  why_->setWordWrap(true);
  auto* ends = new QDialogButtonBox(QDialogButtonBox::Cancel);
  create_ = described(ends->addButton(tr("&Create"), QDialogButtonBox::AcceptRole),
                      QStringLiteral("averageCreate"), tr("Opens the average in a new tab"));
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(new QLabel(tr("Average which buttons?")));
  layout->addWidget(list_, 1);
  layout->addWidget(why_);
  layout->addWidget(ends);
  connect(ends, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(ends, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(list_, &QListWidget::itemChanged, this, &AverageDialog::follow);
  follow();
}

QStringList AverageDialog::titles() const {
  QStringList ticked;
  for (int i = 0; i < list_->count(); ++i)
    if (list_->item(i)->checkState() == Qt::Checked) ticked << list_->item(i)->text();
  return ticked;
}

void AverageDialog::follow() {
  spread_.reset();
  QString why;
  std::vector<Button> ticked;
  for (int i = 0; i < list_->count(); ++i) {
    if (list_->item(i)->checkState() != Qt::Checked) continue;
    ticked.push_back(buttons_[static_cast<std::size_t>(i)]);
    if (tactilePointsOf(ticked.back()) != tactilePointsOf(ticked.front()))
      why = tr("“%1” and “%2” differ in states or tactile points. Average buttons of one kind.")
                .arg(titles().front(), list_->item(i)->text());
  }
  if (ticked.size() < 2) {
    why = tr("Tick two or more buttons.");
  } else if (why.isEmpty()) {
    auto spread = spreadOf(ticked);
    if (spread)
      spread_ = *std::move(spread);
    else
      why = sentenceOf(spread.failure(), units_);
  }
  why_->setText(why);
  why_->setAccessibleName(why);
  create_->setEnabled(spread_.has_value());
}

}  // namespace detent::editor
