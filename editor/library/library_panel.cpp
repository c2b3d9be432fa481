// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/library/library_panel.h"

#include <algorithm>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QMenu>
#include <QSplitter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include "editor/document/described.h"

namespace detent::editor {
namespace {

constexpr int forecastDelay_ms = 250;

/// Draws items no wider than the list: long names are broken or get an ellipsis.
class PictureDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const auto* list = qobject_cast<const QListView*>(parent());
    QSize size = QStyledItemDelegate::sizeHint(option, index);
    if (list) size.setWidth(std::min(size.width(), list->viewport()->width() - 2 * list->spacing()));
    return size;
  }
};

QListView* pictureList(QAbstractItemModel* model, const QString& objectName, const QString& accessibleName) {
  auto* list = new QListView;
  list->setObjectName(objectName);
  list->setAccessibleName(accessibleName);
  list->setModel(model);
  list->setItemDelegate(new PictureDelegate(list));
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list->setResizeMode(QListView::Adjust);
  list->setTextElideMode(Qt::ElideMiddle);
  list->setIconSize(LibraryPanel::pictureSize_px);
  list->setUniformItemSizes(true);  // pictures are requested only for visible rows
  list->setEditTriggers(QAbstractItemView::NoEditTriggers);
  list->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list->setContextMenuPolicy(Qt::CustomContextMenu);
  list->setFrameShape(QFrame::NoFrame);
  list->setSpacing(1);
  return list;
}

// A menu key refers to the middle of the list, not to a position.
QModelIndex clickedIndex(const QListView& list, QPoint at) {
  const QModelIndex under = list.indexAt(at);
  return under.isValid() ? under : list.currentIndex();
}

}  // namespace

LibraryPanel::LibraryPanel(QWidget* parent) : QWidget(parent) {
  setObjectName("libraryPanel");
  auto* sections = new QSplitter(Qt::Vertical);
  sections->addWidget(openSection());
  sections->addWidget(folderSection());
  sections->setChildrenCollapsible(false);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(sections);
  forecastSoon_.setSingleShot(true);
  forecastSoon_.setInterval(forecastDelay_ms);
  connect(&forecastSoon_, &QTimer::timeout, this, &LibraryPanel::askForecasts);
  connect(&forecasts_, &ForecastSource::ready, this,
          [this](const auto& forecast) { showForecasts(*forecast); });
  updateDrawingColors();
  showFolderName();
}

QWidget* LibraryPanel::openSection() {
  auto* section = new QWidget;
  auto* layout = new QVBoxLayout(section);
  layout->setContentsMargins(6, 6, 6, 6);
  auto* title = new QLabel(tr("Open"));
  layout->addWidget(title);
  openList_ = pictureList(&open_, "libraryOpenButtons", tr("Open buttons"));
  openList_->setWordWrap(true);
  title->setBuddy(openList_);
  layout->addWidget(openList_);
  const auto choose = [this](const QModelIndex& index) {
    // the user is selecting several buttons
    if (openList_->selectionModel()->selectedIndexes().size() > 1) return;
    if (ButtonDocument* document = open_.documentAt(index)) emit documentChosen(document);
  };
  connect(openList_, &QListView::clicked, this, choose);
  connect(openList_, &QListView::activated, this, choose);
  connect(openList_, &QListView::customContextMenuRequested, this, &LibraryPanel::openMenu);
  return section;
}

QWidget* LibraryPanel::folderSection() {
  auto* section = new QWidget;
  auto* layout = new QVBoxLayout(section);
  layout->setContentsMargins(6, 6, 6, 6);
  folderButton_ =
      described(new QToolButton, "libraryFolder", tr("Choose the folder whose buttons are listed here"),
                tr("Folder of the library"));
  folderButton_->setToolButtonStyle(Qt::ToolButtonTextOnly);
  folderButton_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(folderButton_, &QToolButton::clicked, this, &LibraryPanel::askFolder);
  filter_ = described(new QLineEdit, "libraryFilter", {}, tr("Filter by name"));
  filter_->setPlaceholderText(tr("Filter by name"));
  filter_->setClearButtonEnabled(true);
  connect(filter_, &QLineEdit::textChanged, &files_, &FolderModel::setFilter);
  fileList_ = pictureList(&files_, "libraryFolderButtons", tr("Buttons of the folder"));
  connect(fileList_, &QListView::activated, this,
          [this](const QModelIndex& index) { emit fileChosen(files_.pathAt(index)); });
  connect(fileList_, &QListView::customContextMenuRequested, this, &LibraryPanel::folderMenu);
  emptyHint_ = new QLabel;
  emptyHint_->setWordWrap(true);
  emptyHint_->setEnabled(false);
  connect(&files_, &FolderModel::modelReset, this, &LibraryPanel::showFolderName);
  layout->addWidget(folderButton_);
  layout->addWidget(filter_);
  layout->addWidget(emptyHint_);
  layout->addWidget(fileList_, 1);
  return section;
}

void LibraryPanel::setDocuments(const std::vector<ButtonDocument*>& documents, ButtonDocument* active) {
  open_.setDocuments(documents);
  for (int row = 0; row < open_.rowCount(); ++row)
    if (open_.documentAt(open_.index(row)) == active && selectedDocuments().size() < 2)
      openList_->setCurrentIndex(open_.index(row));
  for (ButtonDocument* document : documents) {
    if (std::find(documents_.begin(), documents_.end(), document) != documents_.end()) continue;
    connect(document, &ButtonDocument::changed, this, [this] {
      if (!forecastSoon_.isActive()) forecastSoon_.start();
    });
  }
  if (documents == documents_ && active == active_) return;
  documents_ = documents;
  active_ = active;
  forecasts_.cancel();  // otherwise an answer for other buttons could fill these rows
  open_.setForecasts({});
  forecastSoon_.start();
}

/// Requests forecasts of the shown button against every other one; none while the panel is hidden.
void LibraryPanel::askForecasts() {
  if (!isVisible() || !active_ || documents_.size() < 2) return;
  std::vector<Button> buttons{active_->button()};
  for (const ButtonDocument* document : documents_)
    if (document != active_) buttons.push_back(document->button());
  forecasts_.request(std::move(buttons), ForecastPairs::ofFirst);
}

void LibraryPanel::showForecasts(const Forecast& forecast) {
  std::map<ButtonDocument*, playback::PredictedPair> found;
  std::size_t at = 0;
  for (ButtonDocument* document : documents_)
    if (document != active_ && at < forecast.pairs.size()) found.emplace(document, forecast.pairs[at++]);
  open_.setForecasts(std::move(found));
}

void LibraryPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  forecastSoon_.start();
}

void LibraryPanel::setFolder(const QString& folder) { files_.setFolder(folder); }

void LibraryPanel::showFolderName() {
  const QString name = QDir(files_.folder()).dirName();
  folderButton_->setText(files_.folder().isEmpty() ? tr("Choose a folder…") : name);
  emptyHint_->setText(files_.folder().isEmpty()
                          ? tr("Choose a folder to list its buttons.")
                          : tr("This folder has no button file (*.button.json) with this name."));
  emptyHint_->setVisible(files_.rowCount() == 0);
  filter_->setVisible(!files_.folder().isEmpty());
}

void LibraryPanel::askFolder() {
  const QString folder =
      QFileDialog::getExistingDirectory(this, tr("Folder of the library"), files_.folder());
  if (folder.isEmpty()) return;
  setFolder(folder);
  emit folderChanged(folder);
}

std::vector<ButtonDocument*> LibraryPanel::selectedDocuments() const {
  QModelIndexList chosen = openList_->selectionModel()->selectedIndexes();
  std::sort(chosen.begin(), chosen.end());
  std::vector<ButtonDocument*> documents;
  for (const QModelIndex& index : chosen)
    if (ButtonDocument* document = open_.documentAt(index)) documents.push_back(document);
  return documents;
}

QStringList LibraryPanel::selectedFiles() const {
  QModelIndexList chosen = fileList_->selectionModel()->selectedIndexes();
  std::sort(chosen.begin(), chosen.end());
  QStringList paths;
  for (const QModelIndex& index : chosen) paths << files_.pathAt(index);
  return paths;
}

void LibraryPanel::openMenu(QPoint at) {
  ButtonDocument* document = open_.documentAt(clickedIndex(*openList_, at));
  if (!document) return;
  QMenu menu;
  if (const auto selected = selectedDocuments(); selected.size() > 1) {
    menu.addAction(tr("Compare the %n selected", nullptr, static_cast<int>(selected.size())), this,
                   [this, selected] { emit compareAllRequested(selected); });
    menu.addSeparator();
  }
  menu.addAction(tr("Show this button"), this, [this, document] { emit documentChosen(document); });
  menu.addAction(tr("Compare with the button shown"), this,
                 [this, document] { emit compareRequested(document); });
  menu.exec(openList_->viewport()->mapToGlobal(at));
}

void LibraryPanel::folderMenu(QPoint at) {
  const QString path = files_.pathAt(clickedIndex(*fileList_, at));
  if (path.isEmpty()) return;
  QMenu menu;
  if (const QStringList selected = selectedFiles(); selected.size() > 1) {
    menu.addAction(tr("Compare the %n selected", nullptr, static_cast<int>(selected.size())), this,
                   [this, selected] { emit compareFilesRequested(selected); });
    menu.addSeparator();
  }
  menu.addAction(tr("Open"), this, [this, path] { emit fileChosen(path); });
  menu.addAction(tr("Compare with the button shown"), this,
                 [this, path] { emit compareFileRequested(path); });
  menu.exec(fileList_->viewport()->mapToGlobal(at));
}

void LibraryPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && openList_) updateDrawingColors();
}

void LibraryPanel::updateDrawingColors() {
  pictures_.setDrawing(graphColors(isDark(palette())), devicePixelRatioF());
  open_.redraw();
  files_.redraw();
}

}  // namespace detent::editor
