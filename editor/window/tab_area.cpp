// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/tab_area.h"

#include <algorithm>
#include <QDir>
#include <QTabBar>

namespace detent::editor {
namespace {

constexpr int leastName = 9;  // characters; with less space the tabs scroll

class NamedTabBar : public QTabBar {
 protected:
  QSize minimumTabSizeHint(int index) const override {
    const QSize whole = tabSizeHint(index);
    const int besideName_px = whole.width() - fontMetrics().horizontalAdvance(tabText(index));
    const int least_px = besideName_px + leastName * fontMetrics().averageCharWidth();
    return {std::min(whole.width(), std::max(least_px, QTabBar::minimumTabSizeHint(index).width())),
            whole.height()};
  }
};

class NamedTabs : public QTabWidget {
 public:
  NamedTabs() { setTabBar(new NamedTabBar); }
};

}  // namespace

TabArea::TabArea(WelcomePage* welcome, ViewSettings& settings, QWidget* parent)
    : QStackedWidget(parent), settings_(settings), tabs_(new NamedTabs) {
  tabs_->setObjectName("tabs");
  tabs_->tabBar()->setObjectName("tabBar");
  tabs_->tabBar()->setAccessibleName(tr("Open buttons"));
  tabs_->setDocumentMode(true);
  tabs_->setTabsClosable(true);
  tabs_->setMovable(true);
  tabs_->setElideMode(Qt::ElideMiddle);
  addWidget(welcome);
  addWidget(tabs_);
  connect(tabs_, &QTabWidget::currentChanged, this, [this](int index) { emit currentTabChanged(at(index)); });
  connect(tabs_, &QTabWidget::tabCloseRequested, this, [this](int index) { emit closeRequested(at(index)); });
  connect(tabs_->tabBar(), &QTabBar::tabMoved, this, [this] {
    updateTitles();
    emit documentsChanged();
  });
}

TabArea::~TabArea() {
  tabs_->disconnect(this);
  while (tabs_->count() > 0) delete tabs_->widget(0);
}

DocumentTab* TabArea::at(int index) const { return qobject_cast<DocumentTab*>(tabs_->widget(index)); }

DocumentTab& TabArea::add(std::unique_ptr<ButtonDocument> document) {
  auto* tab = new DocumentTab(std::move(document), settings_);
  connect(&tab->document(), &ButtonDocument::titleChanged, this, &TabArea::updateTitles);
  emit tabAdded(tab);
  const int index = tabs_->addTab(tab, QString());
  updateTitles();
  setCurrentWidget(tabs_);
  tabs_->setCurrentIndex(index);
  tab->workspace().setFocus();  // the page that was hidden had the keyboard focus
  emit documentsChanged();
  return *tab;
}

void TabArea::remove(DocumentTab& tab) {
  emit tabClosing(&tab);
  tab.document().disconnect(this);
  tabs_->removeTab(tabs_->indexOf(&tab));
  updateTitles();
  if (tabs_->count() == 0) setCurrentIndex(0);
  tab.hide();
  tab.deleteLater();  // later, because the click may come from a button inside this tab
  emit documentsChanged();
}

void TabArea::updateTitles() {
  QStringList titles = distinctTitles(documents());
  for (int i = 0; i < tabs_->count(); ++i) {
    const ButtonDocument& document = at(i)->document();
    titles[i].replace('&', "&&");
    tabs_->setTabText(i, document.history().modified() ? titles[i] + " *" : titles[i]);
    tabs_->setTabToolTip(
        i, document.path().isEmpty() ? tr("Not saved yet") : QDir::toNativeSeparators(document.path()));
  }
}

DocumentTab* TabArea::current() const { return at(tabs_->currentIndex()); }

void TabArea::show(ButtonDocument& document) {
  if (DocumentTab* tab = tabOf(&document)) tabs_->setCurrentWidget(tab);
}

void TabArea::showNext(int step) {
  if (const int count = tabs_->count(); count > 0)
    tabs_->setCurrentIndex((tabs_->currentIndex() + step + count) % count);
}

std::vector<DocumentTab*> TabArea::all() const {
  std::vector<DocumentTab*> tabs;
  for (int i = 0; i < tabs_->count(); ++i) tabs.push_back(at(i));
  return tabs;
}

std::vector<ButtonDocument*> TabArea::documents() const {
  std::vector<ButtonDocument*> documents;
  for (DocumentTab* tab : all()) documents.push_back(&tab->document());
  return documents;
}

DocumentTab* TabArea::withPath(const QString& path) const {
  for (DocumentTab* tab : all())
    if (tab->document().path() == path) return tab;
  return nullptr;
}

DocumentTab* TabArea::tabOf(const ButtonDocument* document) const {
  for (DocumentTab* tab : all())
    if (&tab->document() == document) return tab;
  return nullptr;
}

}  // namespace detent::editor
