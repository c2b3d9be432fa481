// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/checks_panel.h"

#include <algorithm>
#include <QStyle>
#include <QVBoxLayout>

#include "editor/panels/check_words.h"

namespace detent::editor {
namespace {

constexpr int checksDragPause_ms = 120;

std::vector<importer::PrintedSpec> specsOf(const ButtonDocument& document) {
  std::vector<importer::PrintedSpec> specs;
  if (document.origin())
    for (const importer::SpecCheck& check : document.origin()->specChecks) specs.push_back(check.spec);
  return specs;
}

}  // namespace

ChecksPanel::ChecksPanel(ButtonDocument& document, ViewSettings& settings, QWidget* parent)
    : QWidget(parent),
      document_(document),
      settings_(settings),
      list_(new QListWidget),
      nothing_(new QLabel) {
  setObjectName(QStringLiteral("checksPanel"));
  list_->setObjectName(QStringLiteral("checksList"));
  list_->setAccessibleName(tr("Problems and warnings of the button"));
  list_->setWordWrap(true);
  list_->setTextElideMode(Qt::ElideNone);
  nothing_->setText(tr("No problems found."));
  nothing_->setMargin(10);
  nothing_->setWordWrap(true);
  setMinimumWidth(260);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(nothing_);
  layout->addWidget(list_, 1);
  setFocusProxy(list_);
  pause_.setSingleShot(true);
  pause_.setInterval(checksDragPause_ms);
  connect(&pause_, &QTimer::timeout, this, &ChecksPanel::follow);
  connect(&document_, &ButtonDocument::changed, this, [this] {
    if (!document_.history().dragging()) return follow();
    if (!pause_.isActive()) pause_.start();
  });
  connect(&document_, &ButtonDocument::originChanged, this, &ChecksPanel::follow);
  connect(&settings_, &ViewSettings::changed, this, &ChecksPanel::follow);
  const auto choose = [this](QListWidgetItem* item) {
    const int row = list_->row(item);
    if (row >= 0) emit placeChosen(places_[static_cast<std::size_t>(row)]);
  };
  connect(list_, &QListWidget::itemClicked, this, choose);
  connect(list_, &QListWidget::itemActivated, this, choose);
  follow();
}

// Printed values are known only after reading the page. A panel behind another tab does not request it,
// although Qt calls it visible.
void ChecksPanel::wantPage() {
  if (isVisible() && !visibleRegion().isEmpty()) document_.wantOrigin();
}

void ChecksPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  wantPage();
}

void ChecksPanel::follow() {
  wantPage();
  pause_.stop();
  show(validate(document_.button()));
}

void ChecksPanel::show(const std::vector<Warning>& warnings) {
  const int row = list_->currentRow();
  list_->clear();
  places_.clear();
  for (const Warning& warning : warnings)
    add(wordsOf(warning, document_.button(), settings_.units()), true, warning.spot);
  for (const importer::SpecCheck& check : importer::checkAgainst(specsOf(document_), document_.button()))
    add(wordsOf(check, settings_.units()), !check.agrees, {});
  list_->setCurrentRow(std::min(row, list_->count() - 1));
  list_->setVisible(list_->count() > 0);
  nothing_->setVisible(list_->count() == 0);
}

void ChecksPanel::add(const QString& text, bool odd, const WarningPlace& place) {
  auto* item = new QListWidgetItem(
      style()->standardIcon(odd ? QStyle::SP_MessageBoxWarning : QStyle::SP_DialogApplyButton), text, list_);
  item->setToolTip(place.at_mm ? tr("Click a problem, or press Enter, to go to its place") : text);
  places_.push_back(place);
}

QStringList ChecksPanel::texts() const {
  QStringList texts;
  for (int i = 0; i < list_->count(); ++i) texts << list_->item(i)->text();
  return texts;
}

}  // namespace detent::editor
