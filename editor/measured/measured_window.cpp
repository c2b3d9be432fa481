// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/measured/measured_window.h"

#include <algorithm>
#include <QAction>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QMenu>
#include <QPlainTextEdit>
#include <QProxyStyle>
#include <QScreen>
#include <QShortcut>
#include <QSplitter>
#include <QStandardPaths>
#include <QVBoxLayout>

#include "editor/document/described.h"
#include "editor/document/form_widgets.h"
#include "editor/document/message_words.h"
#include "editor/document/series_colors.h"
#include "editor/forecast/forecast_words.h"
#include "editor/measured/measured_words.h"
#include "editor/panels/key_figures_model.h"
#include "model/file/text_file.h"

namespace detent::editor {
namespace {

constexpr QSize first_px{1180, 760}, leastPlot_px{260, 180};
constexpr int nameColumn_em = 20, figureColumn_em = 11, wideColumn_em = 14, headerLines = 3;
constexpr int tableShare = 3, plotsShare = 2;  // shares of the width
constexpr int mapShare = 1, overlayShare = 1;  // shares of the plots' height
constexpr int rankPause_ms = 120;              // after an edit of the reference button
constexpr int forecastPause_ms = 400;
constexpr std::size_t foretoldSwitches = 8, reportedSwitches = 20;
constexpr std::size_t comparedSwitches = seriesColors;
constexpr int longestList = 4;  // of credits and licences in a line

/// A style without resize grips for headers whose sections cannot be resized, so that a click near a line
/// between two rows selects the row.
class NoGrips : public QProxyStyle {
 public:
  NoGrips() : QProxyStyle(QStringLiteral("Fusion")) {}  // Fusion is the base of outlinedStyle()
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
    return metric == PM_HeaderGripMargin ? 0 : QProxyStyle::pixelMetric(metric, option, widget);
  }
};

QLabel* namedText(const char* name) {
  QLabel* label = wrappingLabel(QString::fromLatin1(name));
  label->setTextFormat(Qt::PlainText);  // names of files may contain markup
  return label;
}

QString joined(const QStringList& texts) {
  if (texts.size() <= longestList) return texts.join(QStringLiteral(", "));
  return texts.first(longestList).join(QStringLiteral(", ")) + QStringLiteral(" \u2026");
}

}  // namespace

MeasuredWindow::MeasuredWindow(MeasuredContext context, QWidget* parent)
    : QDialog(parent), context_(std::move(context)) {
  setObjectName("measuredWindow");
  setWindowTitle(tr("Measured switches"));
  setWindowFlag(Qt::WindowMinMaxButtonsHint);
  table_.setUnits(context_.view.units());
  credits_ = namedText("measuredCredits");
  pages_ = new QStackedWidget;
  pages_->addWidget(emptyPage());
  pages_->addWidget(fullPage());
  said_ = namedText("measuredSaid");
  progress_ = described(new QProgressBar, "measuredProgress", {}, tr("Progress of reading the folders"));
  progress_->setRange(0, 1000);
  cancel_ = actionButton("measuredCancel", tr("Stop"), tr("Stop reading and keep what was read"),
                         [this] { source_.cancel(); });
  refusedButton_ = actionButton("measuredRefused", tr("Rejected files…"),
                                tr("Which files were rejected, and why"), [this] { showRefused(); });
  auto* state = new QHBoxLayout;
  state->addWidget(said_, 1);
  state->addWidget(refusedButton_);
  state->addWidget(progress_);
  state->addWidget(cancel_);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(pages_, 1);
  layout->addLayout(state);
  sayBusy(false);
  refusedButton_->hide();
  said_->hide();

  rankSoon_.setSingleShot(true);
  rankSoon_.setInterval(rankPause_ms);
  connect(&rankSoon_, &QTimer::timeout, this, &MeasuredWindow::rank);
  forecastSoon_.setSingleShot(true);
  forecastSoon_.setInterval(forecastPause_ms);
  connect(&forecastSoon_, &QTimer::timeout, this, &MeasuredWindow::forecastNearest);
  connect(&forecasts_, &NearestForecasts::foretold, this,
          [this](SwitchIndex of, const auto& pair) { table_.setForecast(of, shortForecastWords(pair)); });
  connect(&source_, &LibrarySource::loaded, this, &MeasuredWindow::take);
  connect(&source_, &LibrarySource::indexed, this, &MeasuredWindow::sayIndexed);
  connect(&source_, &LibrarySource::progressed, this, [this](double fraction, const QString& file) {
    progress_->setValue(static_cast<int>(1000 * fraction));
    progress_->setToolTip(file);
  });
  connect(&source_, &LibrarySource::opened, this, [this](const std::vector<Button>& buttons) {
    const auto& act = comparing_ ? context_.compare : context_.open;
    if (!buttons.empty() && act) act(buttons);
  });
  connect(&source_, &LibrarySource::failed, this, [this](const QString& sentence) {
    said_->setText(sentence);
    said_->show();
    sayBusy(false);
    emit shown();
  });
  connect(&context_.view, &ViewSettings::changed, this, &MeasuredWindow::followUnits);
  auto* find = new QShortcut(QKeySequence::Find, this);
  connect(find, &QShortcut::activated, this,
          [this] { filter_->findChild<QLineEdit*>("measuredWords")->setFocus(); });
  followDocuments();
  showChosen();
  resize(first_px / 2);  // grows with the first library
}

// ---- the parts

QPushButton* MeasuredWindow::actionButton(const char* name, const QString& text, const QString& tip,
                                          const std::function<void()>& act) {
  QPushButton* button = plainButton(name, text, tip);
  connect(button, &QPushButton::clicked, this, act);
  return button;
}

QWidget* MeasuredWindow::emptyPage() {
  emptyWords_ = namedText("measuredEmpty");
  emptyWords_->setText(
      tr("Measurements of more than 1,500 key switches are published. Download one of these collections "
         "(force-curves-tidy, Open-Switch-Curve-Meter, topre-force-curves …) or take your own measurements "
         "(CSV, ODS, JSON, button files). Then add their folder. Detent contains no measurements; each one "
         "shows its author and licence."));
  auto* page = new QWidget;
  auto* row = new QHBoxLayout;
  row->addWidget(actionButton("measuredAddFolder", tr("&Add a folder…"),
                              tr("Read the measurements in a folder and its subfolders"),
                              [this] { askForFolder(); }));
  row->addWidget(actionButton("measuredOpenLibrary", tr("&Open a library…"),
                              tr("Show a library file that the command `detent-import library` made"),
                              [this] { askForLibrary(); }));
  row->addStretch();
  auto* layout = new QVBoxLayout(page);
  layout->addStretch();
  layout->addWidget(emptyWords_);
  layout->addLayout(row);
  layout->addStretch();
  return page;
}

QToolButton* MeasuredWindow::libraryButton() {
  auto* button =
      described(new QToolButton, "measuredLibrary", tr("Folders and files of the library"), tr("Library"));
  button->setText(tr("&Library"));
  button->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(button);
  menu->setToolTipsVisible(true);
  const auto add = [&](const char* name, const QString& text, const QString& tip,
                       const std::function<void()>& act) {
    auto* action = described(new QAction(text, menu), name, tip);
    connect(action, &QAction::triggered, this, act);
    menu->addAction(action);
  };
  add("measuredAddMore", tr("&Add a folder…"), tr("Read the measurements in a folder and its subfolders"),
      [this] { askForFolder(); });
  add("measuredIndexAgain", tr("&Read the folders again"),
      tr("Read the folders again, but only files that have changed"), [this] { indexAgain(); });
  auto* pages = described(new QAction(tr("Include &datasheets"), menu), "measuredPages",
                          tr("Also read force graphs from PDF, SVG and picture files in the folders. This "
                             "takes some seconds per page, but only the first time"));
  pages->setCheckable(true);
  pages->setChecked(context_.settings.value("measured/pages", false).toBool());
  connect(pages, &QAction::toggled, this, [this](bool on) {
    context_.settings.setValue("measured/pages", on);
    if (on && !folders().isEmpty()) indexAgain();
  });
  menu->addAction(pages);
  add("measuredOpenOther", tr("&Open another library…"),
      tr("Show a library file that the command `detent-import library` made"), [this] { askForLibrary(); });
  button->setMenu(menu);
  return button;
}

QLayout* MeasuredWindow::askRow() {
  like_ =
      described(new QComboBox, "measuredLike",
                tr("The switches that feel like this one come first, with their distance"), tr("Feels like"));
  like_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  auto* label = new QLabel(tr("Feels li&ke:"));
  label->setBuddy(like_);
  count_ = namedText("measuredCount");
  count_->setWordWrap(false);
  auto* row = new QHBoxLayout;
  row->addWidget(libraryButton());
  row->addWidget(label);
  row->addWidget(like_);
  row->addStretch();
  row->addWidget(count_);
  connect(like_, &QComboBox::activated, this, &MeasuredWindow::chooseReference);
  return row;
}

QWidget* MeasuredWindow::tableView() {
  view_ = described(new QTableView, "measuredTable", {}, tr("Measured switches"));
  view_->setModel(&table_);
  view_->setSelectionBehavior(QAbstractItemView::SelectRows);
  view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  view_->setAlternatingRowColors(true);
  view_->setCornerButtonEnabled(false);
  view_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  view_->setWordWrap(false);
  const int em = fontMetrics().horizontalAdvance('M');
  QHeaderView* const across = view_->horizontalHeader();
  across->setDefaultAlignment(static_cast<Qt::Alignment>(Qt::AlignCenter | Qt::TextWordWrap));
  across->setDefaultSectionSize(figureColumn_em * em);
  across->setFixedHeight(headerLines * fontMetrics().lineSpacing() + em);
  across->setSortIndicatorClearable(true);  // a third click returns to the order by distance
  across->setSortIndicator(-1, Qt::AscendingOrder);
  across->setContextMenuPolicy(Qt::CustomContextMenu);
  across->setSectionsMovable(true);
  for (const int column : {MeasuredTable::forecastColumn, MeasuredTable::licenceColumn,
                           MeasuredTable::creditColumn, MeasuredTable::fileColumn})
    view_->setColumnWidth(column, wideColumn_em * em);
  view_->setSortingEnabled(true);
  QHeaderView* const down = view_->verticalHeader();
  down->setSectionResizeMode(QHeaderView::Fixed);
  auto* noGrips = new NoGrips;
  noGrips->setParent(down);
  down->setStyle(noGrips);
  down->setDefaultSectionSize(fontMetrics().lineSpacing() + em / 2);
  down->setFixedWidth(nameColumn_em * em);
  connect(across, &QHeaderView::customContextMenuRequested, this, &MeasuredWindow::columnMenu);
  connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &MeasuredWindow::chosenInTable);
  connect(&table_, &QAbstractItemModel::modelReset, this, &MeasuredWindow::rowsChanged);
  connect(view_, &QTableView::doubleClicked, this, [this] { openChosen(false); });
  connect(down, &QHeaderView::sectionDoubleClicked, this, [this] { openChosen(false); });
  return view_;
}

QWidget* MeasuredWindow::mapView() {
  map_ = described(new SwitchMap(table_), "measuredMap",
                   tr("Click a dot or draw a rectangle to select; hold Ctrl to add to the selection; "
                      "double-click to show all"),
                   tr("Map of the switches shown"));
  map_->setMinimumSize(leastPlot_px);
  const auto scaleBox = [this](const char* name, const QString& words, int chosen) {
    auto* box = described(new QComboBox, QString::fromLatin1(name), words, words);
    for (const int axis : {0, 1}) box->addItem(tr("Main difference %1").arg(axis + 1), -1 - axis);
    for (const KeyFigureName& figure : keyFigureNames())
      box->addItem(termOf(figure.figure), static_cast<int>(figure.figure));
    box->setCurrentIndex(chosen);
    connect(box, &QComboBox::currentIndexChanged, this, &MeasuredWindow::followScales);
    return box;
  };
  mapX_ = scaleBox("measuredMapX", tr("Horizontal axis of the map"), 0);
  mapY_ = scaleBox("measuredMapY", tr("Vertical axis of the map"), 1);
  auto* choice = new QHBoxLayout;
  for (const auto& [words, box] :
       {std::pair(tr("Map: ho&rizontal"), mapX_), std::pair(tr("&vertical"), mapY_)}) {
    auto* label = new QLabel(words);
    label->setBuddy(box);
    box->setMinimumContentsLength(12);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice->addWidget(label);
    choice->addWidget(box, 1);
  }
  auto* page = new QWidget;
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(choice);
  layout->addWidget(map_, 1);
  connect(map_, &SwitchMap::chosen, this, &MeasuredWindow::choose);
  return page;
}

QLayout* MeasuredWindow::actionRow() {
  likeThis_ = actionButton("measuredLikeThis", tr("Find &similar"),
                           tr("List the switches most similar to the selected one first"),
                           [this] { askLikeChosen(); });
  openButton_ = actionButton("measuredOpen", tr("Open as a &button"),
                             tr("Open the selected switches as buttons, each in a new tab"),
                             [this] { openChosen(false); });
  compareButton_ = actionButton("measuredCompare", tr("&Compare"),
                                tr("Open two to six selected switches and overlay their curves"),
                                [this] { openChosen(true); });
  report_ = actionButton("measuredReport", tr("Write a &web page…"),
                         tr("Write the most similar switches as a web page with plots, to send to others"),
                         [this] { writeReport(); });
  auto* row = new QHBoxLayout;
  for (QPushButton* button : {likeThis_, openButton_, compareButton_, report_}) row->addWidget(button);
  row->addStretch();
  return row;
}

QWidget* MeasuredWindow::fullPage() {
  filter_ = described(new FilterBar(context_.view.units()), "measuredFilter");
  overlay_ = described(new OverlayPlot, "measuredOverlay", {}, tr("Curves of the selected switches"));
  overlay_->setMinimumSize(leastPlot_px);
  auto* plots = new QSplitter(Qt::Vertical);
  plots->addWidget(mapView());
  plots->addWidget(overlay_);
  plots->setSizes({mapShare * first_px.height(), overlayShare * first_px.height()});
  auto* sides = new QSplitter(Qt::Horizontal);
  sides->addWidget(tableView());
  sides->addWidget(plots);
  sides->setStretchFactor(0, tableShare);
  sides->setStretchFactor(1, plotsShare);
  sides->setSizes({tableShare * first_px.width(), plotsShare * first_px.width()});
  sides->setChildrenCollapsible(false);
  auto* page = new QWidget;
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(askRow());
  layout->addWidget(filter_);
  layout->addWidget(sides, 1);
  layout->addWidget(credits_);
  layout->addLayout(actionRow());
  connect(filter_, &FilterBar::changed, this, &MeasuredWindow::filterChanged);
  return page;
}

// ---- the library

QString MeasuredWindow::database() const {
  QString chosen = context_.settings.value("measured/library").toString();
  if (!chosen.isEmpty()) return chosen;
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/switches.db");
}

QStringList MeasuredWindow::folders() const {
  return context_.settings.value("measured/folders").toStringList();
}

void MeasuredWindow::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  if (loadedOnce_ || !QFileInfo::exists(database())) return;
  sayBusy(true);
  source_.load(database(), ofFolders());
}

void MeasuredWindow::openLibrary(const QString& path) {
  loadedOnce_ = true;
  context_.settings.setValue("measured/library", path);
  context_.settings.remove("measured/folders");
  sayBusy(true);
  source_.load(path);
}

void MeasuredWindow::askForFolder() {
  if (const QString at = context_.folder(this); !at.isEmpty()) addFolder(at);
}

void MeasuredWindow::askForLibrary() {
  if (const QString at = context_.libraryFile(this); !at.isEmpty()) openLibrary(at);
}

void MeasuredWindow::addFolder(const QString& folder) {
  QStringList all = folders();
  if (!all.contains(folder)) all << folder;
  context_.settings.setValue("measured/folders", all);
  indexAgain();
}

LibraryRequest MeasuredWindow::ofFolders() const {
  LibraryRequest request;
  request.pages = context_.settings.value("measured/pages", false).toBool();
  request.index.database = QFile::encodeName(database()).toStdString();
  for (const QString& folder : folders())
    if (QFileInfo::exists(folder)) request.index.folders.push_back(QFile::encodeName(folder).toStdString());
  return request;
}

void MeasuredWindow::indexAgain() {
  loadedOnce_ = true;
  LibraryRequest request = ofFolders();
  if (request.index.folders.empty()) {
    said_->setText(tr("None of the folders of the library was found. Add one."));
    return said_->show();
  }
  QDir().mkpath(QFileInfo(database()).absolutePath());
  sayBusy(true);
  source_.index(std::move(request));
}

void MeasuredWindow::sayBusy(bool busy) {
  progress_->setValue(0);
  progress_->setVisible(busy);
  cancel_->setVisible(busy);
}

void MeasuredWindow::sayIndexed(const importer::IndexSummary& summary) {
  refused_ = summary.refusals;
  refusedButton_->setVisible(!refused_.empty());
  QString sentence = tr("%1 files read (%2 switches), %3 unchanged, %4 rejected, %5 removed.")
                         .arg(summary.imported)
                         .arg(summary.switches)
                         .arg(summary.unchanged)
                         .arg(summary.refused)
                         .arg(summary.gone);
  if (!summary.rebuilt.empty()) sentence = asSentence(inWords(summary.rebuilt)) + ' ' + sentence;
  said_->setText(sentence);
  said_->show();
}

void MeasuredWindow::showRefused() {
  QDialog dialog(this);
  dialog.setObjectName("measuredRefusedList");
  dialog.setWindowTitle(tr("Rejected files"));
  auto* list = described(new QPlainTextEdit, "measuredRefusedText", {}, tr("Rejected files"));
  list->setReadOnly(true);
  for (const importer::RefusedFile& each : refused_)
    list->appendPlainText(QFile::decodeName(QByteArray::fromStdString(each.file)) + '\n' +
                          QString::fromStdString(each.reason) + '\n');
  auto* layout = new QVBoxLayout(&dialog);
  layout->addWidget(list);
  dialog.resize(first_px / 2);
  dialog.exec();
}

void MeasuredWindow::take(const QString& path, const std::shared_ptr<const MeasuredSwitches>& switches) {
  loadedOnce_ = true;
  setWindowTitle(tr("Measured switches \u2013 %1").arg(QFileInfo(path).fileName()));
  sayBusy(false);
  chosen_.clear();
  // its index may belong to another switch in the new library
  if (reference_ && reference_->own) reference_.reset();
  table_.setSwitches(switches);
  const bool grows = pages_->currentIndex() == 0 && !switches->switches.empty();
  pages_->setCurrentIndex(switches->switches.empty() ? 0 : 1);
  if (grows) resize(size().expandedTo(first_px).boundedTo(screen()->availableSize()));
  listRequested();
  rank();
  followUnits();
  emit shown();
}

// ---- requests

void MeasuredWindow::followDocuments() {
  if (context_.documents) listed_ = context_.documents();
  if (reference_ && !reference_->own &&
      std::ranges::find(listed_, reference_->document.data()) == listed_.end()) {
    reference_.reset();
    rank();
  }
  listRequested();
}

void MeasuredWindow::listRequested() {
  like_->clear();
  like_->addItem(tr("no reference"));
  like_->addItems(distinctTitles(listed_));
  for (std::size_t i = 0; i < listed_.size(); ++i)
    if (reference_ && reference_->document == listed_[i]) like_->setCurrentIndex(static_cast<int>(i) + 1);
  if (!reference_ || !reference_->own) return;
  like_->addItem(reference_->name);
  like_->setCurrentIndex(like_->count() - 1);
}

void MeasuredWindow::chooseReference() {
  const int index = like_->currentIndex();
  if (index > 0 && static_cast<std::size_t>(index) <= listed_.size())
    return askFor(*listed_[static_cast<std::size_t>(index - 1)]);
  if (index > 0) return;
  reference_.reset();
  rank();
  listRequested();
}

void MeasuredWindow::askFor(ButtonDocument& document) {
  if (reference_ && reference_->document) reference_->document->disconnect(&rankSoon_);
  reference_ = Reference{document.title(), {}, {}, &document};
  nearestFirst();
  for (const auto signal : {&ButtonDocument::changed, &ButtonDocument::activeStateChanged})
    connect(&document, signal, &rankSoon_, qOverload<>(&QTimer::start));
  listRequested();
  rank();
}

void MeasuredWindow::askLikeChosen() {
  if (chosen_.size() != 1) return;
  const importer::LibrarySwitch& entry = table_.switches()[*chosen_.begin()];
  reference_ = Reference{titleOf(entry), entry, *chosen_.begin(), {}};
  nearestFirst();
  listRequested();
  rank();
}

// The user wants the nearest switches first, whatever column was sorted.
void MeasuredWindow::nearestFirst() { view_->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder); }

void MeasuredWindow::rank() {
  std::optional<importer::FeltShape> shape;
  if (reference_ && reference_->document) {
    ButtonDocument& document = *reference_->document;
    const ButtonState& state = document.button().states()[document.activeState()];
    shape = importer::feltShapeOf(state.graph);
    reference_->entry.name = document.title().toStdString();
    reference_->entry.licence = importer::noLicenceStated;
    reference_->entry.figures = keyFiguresOf(state);
    if (shape) reference_->entry.shape = *shape;
  } else if (reference_ && reference_->own) {
    shape = reference_->entry.shape;
  }
  forecasts_.cancel();
  view_->setColumnHidden(MeasuredTable::distanceColumn, !shape);
  view_->setColumnHidden(MeasuredTable::forecastColumn, !shape);
  table_.rankBy(shape);
  if (shape) {
    view_->scrollToTop();
    forecastSoon_.start();
  }
  report_->setEnabled(shape.has_value());
}

void MeasuredWindow::forecastNearest() {
  if (!reference_ || !table_.ranked()) return;
  std::vector<SwitchIndex> order = table_.shown();
  std::ranges::stable_sort(order, {}, [&](SwitchIndex each) { return table_.distanceOf(each); });
  std::vector<std::pair<SwitchIndex, importer::LibrarySwitch>> nearest;
  for (const SwitchIndex each : order) {
    if (nearest.size() == foretoldSwitches) break;
    if (reference_->own != each) nearest.emplace_back(each, table_.switches()[each]);
  }
  if (reference_->document) return forecasts_.ask(reference_->document->button(), std::move(nearest));
  const auto button = importer::buttonOf(reference_->entry, importer::Quality::draft);
  if (button) forecasts_.ask(*button, std::move(nearest));
}

// ---- what is shown and chosen

void MeasuredWindow::filterChanged() {
  table_.setFilter(filter_->filter());
  if (table_.ranked()) forecastSoon_.start();
}

void MeasuredWindow::rowsChanged() {
  restoreChosen();
  count_->setText(tr("%L1 of %L2 switches").arg(table_.rowCount()).arg(table_.switches().size()));
  map_->redraw();
  showChosen();
}

// Selects the chosen switches in the table, as far as it shows them.
void MeasuredWindow::restoreChosen() {
  QItemSelection selection;
  const std::vector<SwitchIndex>& rows = table_.shown();
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (!chosen_.contains(rows[row])) continue;
    std::size_t end = row;
    while (end + 1 < rows.size() && chosen_.contains(rows[end + 1])) ++end;
    selection.append(QItemSelectionRange(table_.index(static_cast<int>(row), 0),
                                         table_.index(static_cast<int>(end), MeasuredTable::columns - 1)));
    row = end;
  }
  restoring_ = true;
  view_->selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
  restoring_ = false;
}

void MeasuredWindow::choose(const std::set<SwitchIndex>& chosen) {
  chosen_ = chosen;
  restoreChosen();
  const auto first =
      std::ranges::find_if(table_.shown(), [&](SwitchIndex each) { return chosen_.contains(each); });
  if (first != table_.shown().end())
    view_->scrollTo(table_.index(static_cast<int>(first - table_.shown().begin()), view_->columnAt(0)));
  showChosen();
}

void MeasuredWindow::chosenInTable() {
  if (restoring_) return;
  chosen_.clear();
  for (const QItemSelectionRange& range : view_->selectionModel()->selection())
    for (int row = range.top(); row <= range.bottom(); ++row)
      chosen_.insert(table_.shown()[static_cast<std::size_t>(row)]);
  showChosen();
}

void MeasuredWindow::showChosen() {
  std::vector<OverlayPlot::Entry> entries;
  for (const SwitchIndex each : table_.shown())
    if (chosen_.contains(each)) {
      const importer::LibrarySwitch& entry = table_.switches()[each];
      entries.push_back({titleOf(entry), &entry.shape});
    }
  const std::size_t count = entries.size();
  overlay_->show(std::move(entries),
                 reference_ && table_.ranked() ? std::optional(reference_->entry.shape) : std::nullopt,
                 context_.view.units());
  map_->setChosen(chosen_);
  likeThis_->setEnabled(count == 1);
  openButton_->setEnabled(count >= 1 && count <= comparedSwitches);
  compareButton_->setEnabled(count >= 2 && count <= comparedSwitches);
  report_->setEnabled(table_.ranked());
  sayCredits();
}

void MeasuredWindow::sayCredits() {
  QStringList credits, licences, names;
  const bool anyChosen =
      std::ranges::any_of(table_.shown(), [&](SwitchIndex each) { return chosen_.contains(each); });
  int doubtful = 0;
  for (const SwitchIndex each : table_.shown()) {
    if (anyChosen && !chosen_.contains(each)) continue;
    const importer::LibrarySwitch& entry = table_.switches()[each];
    names << titleOf(entry);
    if (entry.scaleDoubtful) ++doubtful;
    if (const QString credit = creditWords(entry); !credits.contains(credit)) credits << credit;
    if (const QString licence = licenceWords(entry); !licences.contains(licence)) licences << licence;
  }
  if (names.isEmpty()) return credits_->clear();
  const QString of = anyChosen ? joined(names) : tr("All shown");
  QString said = tr("%1. Credit: %2. Licence: %3.").arg(of, joined(credits), joined(licences));
  if (anyChosen && chosen_.size() == 1) {
    said += spreadWords(table_.spreadOf(*chosen_.begin()), context_.view.units());
    said += ratingWords(table_.ratingsOf(*chosen_.begin()));
  }
  if (doubtful > 0)
    said +=
        ' ' + (names.size() == 1
                   ? doubtfulScaleWords()
                   : tr("Forces of %n of these switches may differ greatly from those of other laboratories.",
                        nullptr, doubtful));
  credits_->setText(said);
}

std::vector<importer::LibrarySwitch> MeasuredWindow::chosenEntries() const {
  std::vector<importer::LibrarySwitch> entries;
  for (const SwitchIndex each : table_.shown())
    if (chosen_.contains(each)) entries.push_back(table_.switches()[each]);
  return entries;
}

void MeasuredWindow::openChosen(bool compare) {
  const auto entries = chosenEntries();
  if (entries.empty() || entries.size() > comparedSwitches) return;
  comparing_ = compare;
  source_.open(entries);
}

void MeasuredWindow::writeReport() {
  if (!reference_ || !table_.ranked()) return;
  const QString path = context_.page(this, reference_->name + QStringLiteral(".html"));
  if (path.isEmpty()) return;
  std::vector<importer::FoundSwitch> found;
  for (const SwitchIndex each : table_.shown())
    found.push_back(
        {table_.switches()[each], table_.distanceOf(each), table_.spreadOf(each), table_.ratingsOf(each)});
  std::ranges::stable_sort(found, {}, &importer::FoundSwitch::distance_labNoise);
  const std::size_t fitting = found.size();
  if (found.size() > reportedSwitches) found.erase(found.begin() + reportedSwitches, found.end());
  const auto written = writeTextFileAtomically(QFile::encodeName(path).toStdString(),
                                               importer::reportPage(reference_->entry, found, fitting));
  said_->setText(written ? tr("Written: %1.").arg(QDir::toNativeSeparators(path))
                         : sentenceOf(written.failure()));
  said_->show();
}

void MeasuredWindow::columnMenu(QPoint at) {
  QMenu menu(this);
  for (int column = 0; column < MeasuredTable::columns; ++column) {
    if (!table_.ranked() &&
        (column == MeasuredTable::distanceColumn || column == MeasuredTable::forecastColumn))
      continue;
    QAction* action = menu.addAction(table_.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
    action->setCheckable(true);
    action->setChecked(!view_->isColumnHidden(column));
    connect(action, &QAction::toggled, this,
            [this, column](bool shown) { view_->setColumnHidden(column, !shown); });
  }
  menu.exec(view_->horizontalHeader()->mapToGlobal(at));
}

void MeasuredWindow::followUnits() {
  const DisplayUnits& units = context_.view.units();
  table_.setUnits(units);
  filter_->setUnits(units);
  followScales();
  map_->setUnits(units);
  showChosen();
}

void MeasuredWindow::followScales() {
  const auto scaleOf = [](const QComboBox& box) {
    const int chosen = box.currentData().toInt();
    if (chosen < 0) return MapScale{{}, static_cast<std::size_t>(-1 - chosen)};
    return MapScale{static_cast<KeyFigure>(chosen), 0};
  };
  map_->setScales(scaleOf(*mapX_), scaleOf(*mapY_));
}

}  // namespace detent::editor
