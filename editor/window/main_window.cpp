// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/main_window.h"

#include <algorithm>
#include <cmath>
#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMenu>
#include <QMimeData>
#include <QPrinter>
#include <QScreen>
#include <QScrollArea>
#include <QSplitter>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>
#include <utility>

#include "editor/canvas/graph_canvas.h"
#include "editor/document/described.h"
#include "editor/document/form_widgets.h"
#include "editor/document/message_words.h"
#include "editor/feel/feel_panel.h"
#include "editor/files/document_files.h"
#include "editor/files/exports.h"
#include "editor/forecast/forecast_matrix.h"
#include "editor/library/average_dialog.h"
#include "editor/library/compare_panel.h"
#include "editor/library/library_panel.h"
#include "editor/library/morph_dialog.h"
#include "editor/measured/measured_window.h"
#include "editor/panels/key_figures_model.h"
#include "editor/panels/key_figures_panel.h"
#include "editor/quantity/quantity.h"
#include "editor/quantity/reading_error.h"
#include "editor/study/experimenter_dialog.h"
#include "editor/window/appearance.h"
#include "editor/window/graph_print.h"
#include "editor/window/margin_overlay.h"
#include "editor/window/screen_fit.h"
#include "editor/window/stored_view.h"
#include "editor/window/wheel_guard.h"
#include "model/edits.h"
#include "model/unit_spread.h"

namespace detent::editor {
namespace {

constexpr int messageTime_ms = 8000;
constexpr int stateVersion = 5;  // of the docks' arrangement; changes when docks do
constexpr QSize firstSize_px{1280, 820};
constexpr int firstLibrary_px = 230, firstInspector_px = 310;
constexpr double mostForInspector = 0.42, mostForFeel = 0.6;  // shares of the window
constexpr int leastForLibrary_px = 1600;  // width of the window from which the library is shown at first
constexpr QSize copiedPicture_px{1800, 1200};

struct AverageWords {
  Q_DECLARE_TR_FUNCTIONS(AverageWords)
};

// Number of digits of a mean, down to the second digit of its standard deviation.
int digitsBeside(double mean, double sd) {
  if (sd <= 0 || mean == 0) return 4;
  return std::clamp(static_cast<int>(std::floor(std::log10(std::abs(mean))) - std::floor(std::log10(sd))) + 2,
                    2, 6);
}

// "Mean of 5 buttons. Peak force 55 ± 2 cN. Far from the others: C."
QString averageWords(const UnitSpread& spread, const QStringList& titles, const DisplayUnits& units) {
  QStringList sentences{AverageWords::tr("Mean of %n buttons.", nullptr, static_cast<int>(titles.size()))};
  for (const FigureSpread& figure : spread.states.front().figures) {
    const FigureUnit unit = keyFigureNames()[static_cast<std::size_t>(figure.figure)].unit;
    if (unit != FigureUnit::N && unit != FigureUnit::mm) continue;
    const Quantity quantity = unit == FigureUnit::N ? Quantity::force : Quantity::length;
    if (figure.figure != KeyFigure::peakForce && figure.figure != KeyFigure::bottomOutForce &&
        figure.figure != KeyFigure::preTravel)
      continue;
    if (!figure.sd)
      sentences << AverageWords::tr("%1: %2 (one button only).")
                       .arg(termOf(figure.figure), quantityWithUnit(figure.mean, quantity, units, 4));
    else
      sentences << AverageWords::tr("%1: %2 ± %3.")
                       .arg(termOf(figure.figure),
                            quantityText(figure.mean, quantity, units, digitsBeside(figure.mean, *figure.sd)),
                            quantityWithUnit(*figure.sd, quantity, units, 2));
  }
  QStringList far;
  for (const std::size_t unit : spread.outliers) far << titles[static_cast<qsizetype>(unit)];
  if (!far.isEmpty()) sentences << AverageWords::tr("Outlier: %1.").arg(far.join(", "));
  return sentences.join(' ');
}

// A low screen does not have room for all of its contents.
QScrollArea* scrolledArea(const char* name, const QString& title) {
  auto* area = described(new QScrollArea, name, {}, title);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  return area;
}

}  // namespace

QPalette currentDesktopPalette() {
  QApplication::setPalette(QPalette());
  return QApplication::palette();
}

MainWindow::MainWindow(const WindowContext& context, QWidget* parent)
    : QMainWindow(parent), at_(context), systemPalette_(context.desktopPalette()) {
  setObjectName("mainWindow");
  new WheelGuard(this);  // installed before any widget exists
  new ScreenFit(this);
  setAcceptDrops(true);
  setDockNestingEnabled(true);
  applyAppearance();  // before there are widgets, because existing ones would keep the old style
  makeFileActions();
  makeEditActions();
  makeCentre();
  makeDocks();
  makeViewActions();
  makeWindowActions();
  makeHelpActions();
  makeToolBar();
  makeStatusBar();
  connectTabs();
  connect(&at_.view, &ViewSettings::changed, this, &MainWindow::updateUnits);
  connect(&at_.view, &ViewSettings::changed, this, &MainWindow::applyAppearance);
  restoreWindow();
  updateUnits();
  updateRecent();
  showTab(nullptr);
}

// Closes the documents first, as the user would, so that panels, recovery and file watch release them.
MainWindow::~MainWindow() {
  sessionHeld_ = true;
  for (DocumentTab* tab : tabs_->all()) tabs_->remove(*tab);
  tabs_->disconnect(this);
  delete feel_;
  delete session_;
}

// ---- the parts

void MainWindow::makeCentre() {
  welcome_ = new WelcomePage(actionsNamed({"import", "new", "open", "trySample"}));
  tabs_ = new TabArea(welcome_, at_.view);
  notices_ = described(new NoticeBar, "windowNotices");
  files_ =
      new FileController({*this, *tabs_, *notices_, at_.view, at_.settings, at_.prompts, at_.recovery}, this);
  auto* centre = new QWidget;
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* editing = new QSplitter(Qt::Vertical);
  editing->setChildrenCollapsible(false);
  editing->addWidget(tabs_);
  editing->addWidget(feelArea_ = scrolledArea("feelArea", tr("Feel")));
  editing->setStretchFactor(0, 1);
  feelArea_->hide();
  compareArea_ = scrolledArea("compareArea", tr("Comparison"));
  centre_ = new QStackedWidget;
  centre_->addWidget(editing);
  centre_->addWidget(compareArea_);
  layout->addWidget(notices_);
  layout->addWidget(centre_, 1);
  setCentralWidget(centre);
  connect(welcome_, &WelcomePage::fileChosen, this, [this](const QString& path) { files_->open({path}); });
  connect(files_, &FileController::done, this,
          [this](const QString& sentence) { statusBar()->showMessage(sentence, messageTime_ms); });
  connect(&files_->recent(), &RecentFiles::changed, this, &MainWindow::updateRecent);
}

QList<QAction*> MainWindow::actionsNamed(std::initializer_list<const char*> names) const {
  QList<QAction*> named;
  for (const char* name : names)
    for (QAction* action : ownActions_)
      if (action->objectName() == name) named << action;
  return named;
}

QDockWidget* MainWindow::dock(const char* name, const QString& title, Qt::DockWidgetArea area,
                              const QKeySequence& keys) {
  auto* dock = described(new QDockWidget(title), name);
  addDockWidget(area, dock);
  QAction* toggle = action((QByteArray(name) + "Toggle").constData(), title,
                           tr("Show or hide: %1").arg(title), keys, [this, dock] { turn(*dock); });
  toggle->setCheckable(true);
  connect(dock, &QDockWidget::visibilityChanged, toggle, &QAction::setChecked);
  return dock;
}

// Shows or hides a panel. A panel behind another one's tab counts as hidden.
void MainWindow::turn(QDockWidget& dock) {
  const bool seen = dock.isVisible() && !dock.visibleRegion().isEmpty();
  if (seen) return dock.hide();
  if (&dock != libraryDock_) showView(CentreView::edit);
  dock.show();
  dock.raise();
  QWidget* inside = dock.widget();
  if (auto* stack = qobject_cast<QStackedWidget*>(inside); stack && stack->currentWidget())
    inside = stack->currentWidget();
  if (!inside) return;
  inside->setFocus();
  // A table shows all of its columns.
  const int wished_px = std::min(inside->sizeHint().width(), static_cast<int>(mostForInspector * width()));
  layout()->activate();
  if (&dock == valuesDock_ && dock.width() < wished_px) resizeDocks({&dock}, {wished_px}, Qt::Horizontal);
}

// ---- views of the centre

void MainWindow::showView(CentreView view) {
  if (!tabs_->current()) view = CentreView::edit;
  if (view == CentreView::compare && !comparison_) return compareWith(nullptr);
  if (view == CentreView::feel && !feel_) makeFeelPanel();
  view_ = view;
  for (const auto& [action, shown] : {std::pair{showEdit_, CentreView::edit},
                                      {showCompare_, CentreView::compare},
                                      {showFeel_, CentreView::feel}})
    action->setChecked(view == shown);
  if (view == CentreView::compare && comparison_->isAlone()) offerToCompare();
  centre_->setCurrentIndex(view == CentreView::compare ? 1 : 0);
  const bool feelShown = feelArea_->isVisibleTo(centre_->widget(0));
  feelArea_->setVisible(view == CentreView::feel);
  if (view == CentreView::feel && !feelShown) {
    auto* editing = static_cast<QSplitter*>(centre_->widget(0));
    const int all_px = editing->height();
    const int feel_px =
        std::min(feelArea_->widget()->sizeHint().height(), static_cast<int>(mostForFeel * all_px));
    editing->setSizes({all_px - feel_px, feel_px});
  }
  for (QAction* tool : toolMenu_.shown) tool->setVisible(view != CentreView::compare);
  putDocksAway(view != CentreView::edit || !tabs_->current());
  if (view == CentreView::feel) feel_->takeKeys();
  if (view == CentreView::edit && tabs_->current()) tabs_->current()->workspace().setFocus();
}

// Docks belong to the editing of one button. Without one they are empty; beside a comparison or the pad they
// would take its room.
void MainWindow::putDocksAway(bool away) {
  if (away == docksAway_) return;
  docksAway_ = away;
  if (away) {
    keepInspectorWidth();
    for (QDockWidget* dock : inspectorDocks()) {
      if (dock->isHidden()) continue;
      awayDocks_ << dock;
      if (!dock->visibleRegion().isEmpty()) frontDock_ = dock;
      dock->hide();
    }
    return;
  }
  for (QDockWidget* dock : std::exchange(awayDocks_, {})) dock->show();
  if (frontDock_) frontDock_->raise();
  if (isVisible()) QTimer::singleShot(0, this, &MainWindow::sizeDocks);
}

QList<QDockWidget*> MainWindow::inspectorDocks() const {
  return {inspectorDock_, valuesDock_, historyDock_, checksDock_, annotationsDock_};
}

void MainWindow::makeDocks() {
  libraryDock_ = dock("libraryDock", tr("Library"), Qt::LeftDockWidgetArea, QKeySequence("Alt+1"));
  inspectorDock_ = dock("inspectorDock", tr("Inspector"), Qt::RightDockWidgetArea, QKeySequence("Alt+6"));
  valuesDock_ = dock("valuesDock", tr("All values"), Qt::RightDockWidgetArea, QKeySequence("Alt+2"));
  historyDock_ = dock("historyDock", tr("History"), Qt::RightDockWidgetArea, QKeySequence("Alt+3"));
  checksDock_ = dock("checksDock", tr("Checks"), Qt::RightDockWidgetArea, QKeySequence("Alt+5"));
  annotationsDock_ = dock("annotationsDock", tr("Notes"), Qt::RightDockWidgetArea, QKeySequence("Alt+7"));
  library_ = new LibraryPanel;
  libraryDock_->setWidget(library_);
  const QList<QDockWidget*> docks = inspectorDocks();
  for (QDockWidget* dock : docks) dock->setWidget(new QStackedWidget);
  for (int i = 1; i < docks.size(); ++i) tabifyDockWidget(docks[i - 1], docks[i]);
  inspectorDock_->raise();
  valuesDock_->hide();
  frontDock_ = inspectorDock_;
  // The panel shows the page's printed values when it comes to the front.
  connect(checksDock_, &QDockWidget::visibilityChanged, this, [this](bool seen) {
    if (!seen) return;
    if (DocumentTab* tab = tabs_->current()) tab->document().wantOrigin();
  });
  connect(library_, &LibraryPanel::documentChosen, this, [this](ButtonDocument* d) { tabs_->show(*d); });
  connect(library_, &LibraryPanel::fileChosen, this,
          [this](const QString& path) { files_->openButton(path); });
  connect(library_, &LibraryPanel::compareRequested, this, &MainWindow::compareWith);
  connect(library_, &LibraryPanel::compareFileRequested, this, [this](const QString& path) {
    DocumentTab* shown = tabs_->current();
    DocumentTab* other = files_->openButton(path);
    if (shown) tabs_->show(shown->document());
    if (other) compareWith(&other->document());
  });
  connect(library_, &LibraryPanel::compareAllRequested, this, &MainWindow::compareAll);
  connect(library_, &LibraryPanel::compareFilesRequested, this, &MainWindow::compareFiles);
  connect(library_, &LibraryPanel::folderChanged, this,
          [this](const QString& folder) { at_.settings.setValue("library/folder", folder); });
}

// A sound device is not touched before the pad is pressed, but the panel itself
// is not light either.
void MainWindow::makeFeelPanel() {
  session_ = new FeelSession(this);
  feel_ = new FeelPanel(at_.view, *session_);
  feel_->restoreState(at_.settings.value("feel").toMap());
  buttonMenu_->addAction(feel_->exchangeAction());
  ownActions_ << feel_->exchangeAction();
  connect(session_, &FeelSession::said, statusBar(),
          [this](const QString& message) { statusBar()->showMessage(message, messageTime_ms); });
  connect(session_, &FeelSession::fingerMoved, this, [this](std::optional<FingerPosition> finger) {
    if (DocumentTab* tab = tabs_->current()) tab->workspace().showFinger(finger);
  });
  connect(session_, &FeelSession::otherFingerMoved, this, [this](std::optional<FingerPosition> finger) {
    if (DocumentTab* tab = tabs_->tabOf(otherDocument_)) tab->workspace().showFinger(finger);
  });
  connect(&session_->force(), &ForceSession::marginChanged, this, &MainWindow::showMargin);
  other_ = described(new QComboBox, "feelOther",
                     tr("Second button (B), which you can press in turn with the button shown"),
                     tr("Button B, for comparison"));
  connect(other_, &QComboBox::activated, this, &MainWindow::chooseOther);
  auto* label = new QLabel(tr("Compare &with:"));
  label->setBuddy(other_);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(8, 4, 8, 0);
  row->setSpacing(6);
  row->addWidget(label);
  row->addWidget(other_);
  row->addStretch();
  auto* panel = new QWidget;
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(row);
  layout->addWidget(feel_, 1);
  feelArea_->setWidget(panel);
  updateDocuments();
}

void MainWindow::showMargin() {
  const ForceSession& force = session_->force();
  DocumentTab* tab = force.margin() ? tabs_->tabOf(force.document()) : nullptr;
  GraphCanvas* canvas = tab ? &tab->workspace().canvas() : nullptr;
  if (margin_ && margin_->parentWidget() != canvas) delete margin_;
  if (!canvas) return;
  if (!margin_) margin_ = new MarginOverlay(*canvas, tab->document());
  margin_->setMargin(force.margin());
}

void MainWindow::chooseOther() {
  const auto documents = tabs_->documents();
  const int index = other_->currentIndex() - 1;
  otherChosen_ = true;
  setOther(index >= 0 ? documents[static_cast<std::size_t>(index)] : nullptr);
}

void MainWindow::setOther(ButtonDocument* other) {
  otherDocument_ = other;
  updateFeel();
}

// A and B are never the same button, not even on the way from one pair to the
// next.
void MainWindow::updateFeel() {
  if (!session_) return;
  DocumentTab* tab = tabs_->current();
  ButtonDocument* shown = tab ? &tab->document() : nullptr;
  ButtonDocument* other = otherDocument_ == shown ? nullptr : otherDocument_.data();
  if (felt_ == std::pair(shown, other)) return;
  session_->setDocument(FeelSide::b, nullptr);
  session_->setDocument(FeelSide::a, shown);
  session_->setDocument(FeelSide::b, other);
  felt_ = {shown, other};
}

void MainWindow::makeStatusBar() {
  cursor_ = described(new QLabel, "cursorPosition", tr("Displacement and force under the mouse"),
                      tr("Displacement and force under the mouse"));
  cursor_->setMinimumWidth(fontMetrics().horizontalAdvance("0000.0000 mm, 00000.00 cN"));
  cursor_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  units_ = described(new QToolButton, "unitButton", tr("Units that everything is shown and typed in"),
                     tr("Units"));
  units_->setPopupMode(QToolButton::InstantPopup);
  units_->setMenu(unitMenu_);
  units_->setAutoRaise(true);
  statusBar()->addPermanentWidget(cursor_);
  statusBar()->addPermanentWidget(units_);
}

// ---- the tabs

void MainWindow::connectTabs() {
  connect(tabs_, &TabArea::tabAdded, this, [this](DocumentTab* tab) { adopt(*tab); });
  connect(tabs_, &TabArea::tabClosing, this, [this](DocumentTab* tab) { letGo(*tab); });
  connect(tabs_, &TabArea::closeRequested, this, [this](DocumentTab* tab) { files_->close(*tab); });
  connect(tabs_, &TabArea::currentTabChanged, this, &MainWindow::showTab);
  connect(tabs_, &TabArea::documentsChanged, this, &MainWindow::updateDocuments);
}

void MainWindow::adopt(DocumentTab& tab) {
  sessionHeld_ = false;
  // An opened button must be visible; a comparison that waits for a second button shows it.
  if (view_ == CentreView::compare && !comparison_->isAlone()) showView(CentreView::edit);
  connect(&tab.workspace(), &GraphWorkspace::cursorMoved, this, &MainWindow::showCursor);
  connect(&tab.workspace(), &GraphWorkspace::buttonCopyRequested, this, [this, &tab] { copyButton(tab); });
  connect(&tab.workspace(), &GraphWorkspace::statusMessage, statusBar(),
          [this](const QString& message) { statusBar()->showMessage(message, messageTime_ms); });
  connect(&tab.document(), &ButtonDocument::titleChanged, this, &MainWindow::updateTitle);
  connect(&tab.document(), &ButtonDocument::titleChanged, this, &MainWindow::storeSession);
  connect(&tab, &DocumentTab::inspectorWanted, this, [this] {
    showView(CentreView::edit);
    inspectorDock_->show();
    inspectorDock_->raise();
  });
  connect(&tab, &DocumentTab::versionOpened, this,
          [this](const Button& version) { tabs_->add(std::make_unique<ButtonDocument>(version)); });
  connect(&tab.document().history().stack(), &QUndoStack::indexChanged, this, &MainWindow::updateUndo);
  connect(&tab.document(), &ButtonDocument::originChanged, this, &MainWindow::updateKeepPage);
  connect(&tab.document(), &ButtonDocument::cutoutChanged, this, &MainWindow::updateKeepPage);
}

void MainWindow::letGo(DocumentTab& tab) {
  tab.workspace().disconnect(this);
  tab.disconnect(this);
  tab.document().disconnect(this);
  tab.document().history().stack().disconnect(this);
  if (otherDocument_ == &tab.document()) {
    otherChosen_ = false;
    setOther(nullptr);
  }
  if (session_ && felt_.first == &tab.document()) {
    session_->setDocument(FeelSide::a, nullptr);
    felt_.first = nullptr;
  }
  for (QPointer<ButtonDocument>* known : {&shown_, &shownBefore_})
    if (*known == &tab.document()) known->clear();
  if (tabs_->current() == &tab) showTabActions(nullptr);
}

void MainWindow::showTab(DocumentTab* tab) {
  at_.view.setPageUnits(tab ? unitsOfPage(tab->document().button()) : std::nullopt);
  showTabActions(tab);
  for (QAction* action : needTab_) action->setEnabled(tab != nullptr);
  if (tab) {
    for (const auto& [dock, panel] : {std::pair{valuesDock_, tab->valuesPanel()},
                                      {inspectorDock_, tab->inspector()},
                                      {historyDock_, tab->historyPanel()},
                                      {checksDock_, tab->checksPanel()},
                                      {annotationsDock_, tab->annotationsPanel()}}) {
      auto* stack = static_cast<QStackedWidget*>(dock->widget());
      stack->addWidget(panel);
      stack->setCurrentWidget(panel);
    }
    tab->workspace().setFocus();
  }
  if (tab && shown_ != &tab->document()) shownBefore_ = std::exchange(shown_, &tab->document());
  if (!otherChosen_) otherDocument_ = shownBefore_;
  showView(tab ? view_ : CentreView::edit);
  updateFeel();
  showCursor({});
  updateUndo();
  updateKeepPage();
  updateDocuments();
  updateTitle();
}

void MainWindow::updateKeepPage() {
  DocumentTab* tab = tabs_->current();
  const bool kept = tab && tab->document().cutout();
  keepPage_->setChecked(kept);
  keepPage_->setEnabled(kept || (tab && tab->workspace().canvas().hasUnderlay()));
}

void MainWindow::updateDocuments() {
  storeSession();
  const std::vector<ButtonDocument*> documents = tabs_->documents();
  DocumentTab* current = tabs_->current();
  library_->setDocuments(documents, current ? &current->document() : nullptr);
  if (comparison_) {
    const bool waiting = view_ == CentreView::compare && comparison_->isAlone() && documents.size() > 1;
    comparison_->setDocuments(documents);
    if (waiting) {
      compareAll({documents.front(), documents.back()});
      tabs_->show(*documents.front());  // the button that was being edited stays the one that is
    }
    if (comparison_->isAlone()) offerToCompare();
  }
  if (forecasts_) forecasts_->setDocuments(documents);
  if (measured_) measured_->followDocuments();
  if (!feel_) return;
  updateFeel();
  other_->clear();
  other_->addItem(tr("no other button"));
  other_->addItems(distinctTitles(documents));
  for (std::size_t i = 0; i < documents.size(); ++i)
    if (documents[i] == otherDocument_) other_->setCurrentIndex(static_cast<int>(i) + 1);
}

void MainWindow::updateTitle() {
  const DocumentTab* tab = tabs_->current();
  if (!tab) {
    setWindowTitle(tr("Detent"));
    setWindowModified(false);
    return;
  }
  const ButtonDocument& document = tabs_->current()->document();
  setWindowTitle(tr("%1[*] \u2013 Detent").arg(document.title()));
  setWindowModified(document.history().modified());
}

void MainWindow::compareWith(ButtonDocument* other) {
  if (view_ == CentreView::compare && other) return comparison_->add(other);
  ButtonDocument* shown = tabs_->current() ? &tabs_->current()->document() : nullptr;
  for (ButtonDocument* document : tabs_->documents())
    if (!other && document != shown) other = document;
  compareAll({shown, other ? other : shown});
}

// Keeps a comparison that contains the shown button, and one that the user has chosen.
void MainWindow::compareShown(DocumentTab& tab) {
  if (comparison_ && (comparison_->isChosen() || comparison_->compares(tab.document())))
    return showView(CentreView::compare);
  compareWith(nullptr);
}

void MainWindow::compareAll(const std::vector<ButtonDocument*>& documents) {
  makeComparison();
  comparison_->setDocuments(tabs_->documents());
  comparison_->compare(documents);
  showView(CentreView::compare);
}

void MainWindow::compareFiles(const QStringList& paths) {
  std::vector<ButtonDocument*> documents;
  for (const QString& path : paths)
    if (DocumentTab* tab = files_->openButton(path)) documents.push_back(&tab->document());
  if (!documents.empty()) compareAll(documents);
}

void MainWindow::makeComparison() {
  if (comparison_) return;
  comparison_ = new ComparePanel(at_.view);
  connect(comparison_, &ComparePanel::pictureRequested, this, &MainWindow::writeComparison);
  compareArea_->setWidget(comparison_);
}

// The ways to a second button; also the reference curve of the shown one, which is compared as a button.
void MainWindow::offerToCompare() {
  QList<QAction*> ways = actionsNamed({"open", "import", "new", "measured"});
  if (reference_) reference_->deleteLater();  // later, because it may be what was triggered
  DocumentTab* tab = tabs_->current();
  if (const std::optional<Reference> shown = tab ? tab->workspace().canvas().reference() : std::nullopt) {
    reference_ = described(new QAction(tr("The reference curve, %1").arg(shown->name), this), "reference",
                           tr("Open the reference curve as a button and compare it"));
    connect(reference_, &QAction::triggered, this, [this, reference = *shown] {
      if (const auto button = Button::fromStates(reference.name.toStdString(), {reference.state}))
        openAll({*button});
    });
    ways.prepend(reference_);
  }
  comparison_->offer(ways);
}

void MainWindow::writeComparison() {
  if (DocumentTab* tab = tabs_->current()) files_->exports().comparison(*tab, *comparison_);
}

void MainWindow::showForecasts() {
  if (!forecasts_) {
    forecasts_ = new ForecastMatrix(this);
    connect(forecasts_, &ForecastMatrix::compareRequested, this,
            [this](ButtonDocument* a, ButtonDocument* b) {
              compareAll({a, b});
            });
  }
  forecasts_->setDocuments(tabs_->documents());
  bringUp(*forecasts_);
}

void MainWindow::morph(DocumentTab& tab) {
  std::vector<Button> buttons;
  std::size_t shown = 0;
  for (ButtonDocument* document : tabs_->documents()) {
    if (document == &tab.document()) shown = buttons.size();
    buttons.push_back(document->history().committed());
  }
  if (buttons.size() < 2)
    return statusBar()->showMessage(tr("Open a second button first: a blend needs two."), messageTime_ms);
  auto* dialog = new MorphDialog(std::move(buttons), shown, at_.view.units(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    if (dialog->between()) addComputed(*dialog->between());
  });
  dialog->open();
}

// A computed button exists nowhere else: it is unsaved work from the start.
DocumentTab& MainWindow::addComputed(const Button& button) {
  auto document = std::make_unique<ButtonDocument>(button);
  document->history().stack().resetClean();
  return tabs_->add(std::move(document));
}

void MainWindow::average(DocumentTab& tab) {
  std::vector<Button> units;
  std::size_t current = 0;
  const std::vector<ButtonDocument*> documents = tabs_->documents();
  for (const ButtonDocument* document : documents) {
    if (document == &tab.document()) current = units.size();
    units.push_back(document->history().committed());
  }
  if (units.size() < 2)
    return statusBar()->showMessage(tr("Open a second button first: an average needs two."), messageTime_ms);
  auto* dialog =
      new AverageDialog(std::move(units), distinctTitles(documents), current, at_.view.units(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    if (dialog->spread()) openAverage(*dialog->spread(), dialog->titles());
  });
  dialog->open();
}

void MainWindow::openAverage(const UnitSpread& spread, const QStringList& titles) {
  const QString name = AverageWords::tr("Mean of %n buttons", nullptr, static_cast<int>(titles.size()));
  const auto named = rename(spread.mean, name.toStdString());
  DocumentTab& tab = addComputed(named ? *named : spread.mean);
  tab.workspace().canvas().showSpread(spread.states);
  tab.notices().say("average", NoticeBar::Kind::information, averageWords(spread, titles, at_.view.units()));
}

// Participants feel with the devices that were chosen for the feel panel.
void MainWindow::showStudy() {
  if (!study_) {
    const auto feel = [this] {
      return session_ ? session_->settings() : feelSettingsFrom(at_.settings.value("feel").toMap());
    };
    StudyContext context;
    context.documents = [this] { return tabs_->documents(); };
    context.profileFile = [feel] { return feel().profileFile; };
    context.sound = [feel] { return outputOf(feel()); };
    context.force = [feel] { return forceDeviceOf(feel().force); };
    study_ = new ExperimenterDialog(context, this);
  }
  bringUp(*study_);
}

std::vector<ButtonDocument*> MainWindow::openAll(const std::vector<Button>& buttons) {
  std::vector<ButtonDocument*> opened;
  for (const Button& button : buttons)
    opened.push_back(&tabs_->add(std::make_unique<ButtonDocument>(button)).document());
  return opened;
}

MeasuredWindow& MainWindow::showMeasured() {
  if (!measured_) {
    const auto folder = [this] { return at_.settings.value("measured/last", QDir::homePath()).toString(); };
    const auto remember = [this](const QString& path) {
      if (!path.isEmpty()) at_.settings.setValue("measured/last", QFileInfo(path).absolutePath());
      return path;
    };
    MeasuredContext context{at_.view, at_.settings, {}, {}, {}, {}, {}, {}};
    context.documents = [this] { return tabs_->documents(); };
    context.open = [this](const std::vector<Button>& buttons) {
      openAll(buttons);
      bringUp(*this);
    };
    context.compare = [this](const std::vector<Button>& buttons) {
      compareAll(openAll(buttons));
      bringUp(*this);
    };
    context.libraryFile = [this, folder, remember](QWidget* parent) {
      const QStringList files = at_.prompts.filesToOpen(parent, tr("Open a library"), folder(),
                                                        {tr("Libraries (*.db *.sqlite *.sqlite3)")});
      return remember(files.isEmpty() ? QString() : files.front());
    };
    context.folder = [this, folder, remember](QWidget* parent) {
      return remember(at_.prompts.folder(parent, tr("Add a folder of measurements"), folder()));
    };
    context.page = [this](QWidget* parent, const QString& suggested) {
      return at_.prompts.fileToSave(parent, tr("Write a web page"), suggested, tr("Web pages (*.html)"));
    };
    measured_ = new MeasuredWindow(std::move(context), this);
  }
  bringUp(*measured_);
  return *measured_;
}

// ---- units, appearance

void MainWindow::updateUnits() {
  const DisplayUnits& units = at_.view.units();
  units_->setText(units.lengthSymbol() + ", " + units.forceSymbol());
  for (QAction* unit : unitMenu_->actions()) {
    if (unit->data().toString() == "length:" + units.lengthSymbol()) unit->setChecked(true);
    if (unit->data().toString() == "force:" + units.forceSymbol()) unit->setChecked(true);
  }
  pageUnits_->setChecked(!at_.view.unitsChosen());
  showCursor({});
}

void MainWindow::showCursor(std::optional<CurvePoint> at) {
  const DisplayUnits& units = at_.view.units();
  if (!at) return cursor_->clear();
  const auto number = [](double value) { return fixedText(value, std::abs(value) < 1 ? 4 : 3); };
  cursor_->setText(number(units.lengthFrom(at->displacement_mm)) + " " + units.lengthSymbol() + ", " +
                   number(units.forceFrom(at->force_N)) + " " + units.forceSymbol());
}

void MainWindow::applyAppearance() {
  const QPalette palette = paletteFor(at_.view.appearance(), systemPalette_);
  if (palette != QApplication::palette()) QApplication::setPalette(palette);
}

// ---- between two runs

void MainWindow::restoreWindow() {
  if (!restoreGeometry(at_.settings.value("window/geometry").toByteArray()))
    resize(firstSize_px.boundedTo(screen()->availableSize() - roomForFrame_px));
  firstState_ = saveState(stateVersion);
  docksAreNew_ = !restoreState(at_.settings.value("window/state").toByteArray(), stateVersion);
  const int inspector_px = at_.settings.value("window/inspector_px").toInt();
  if (inspector_px < screen()->availableSize().width()) inspector_px_ = inspector_px;
  if (const QString folder = at_.settings.value("library/folder").toString(); QFileInfo(folder).isDir())
    library_->setFolder(folder);
}

// The widths of docks can only be set when the window has its own size.
void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (!docksAreNew_) return;
  libraryDock_->setVisible(width() >= leastForLibrary_px);
  if (!docksAway_) QTimer::singleShot(0, this, &MainWindow::sizeDocks);
}

// Qt forgets the width of docks that were hidden. A layout that is still due would undo what is set here.
void MainWindow::sizeDocks() {
  layout()->activate();
  if (std::exchange(docksAreNew_, false)) {
    inspector_px_ = std::min(firstInspector_px, static_cast<int>(mostForInspector * width()));
    resizeDocks({libraryDock_}, {firstLibrary_px}, Qt::Horizontal);
  }
  if (inspector_px_ > 0) resizeDocks({inspectorDock_}, {inspector_px_}, Qt::Horizontal);
}

void MainWindow::keepInspectorWidth() {
  for (const QDockWidget* dock : inspectorDocks())
    if (!dock->isFloating() && !dock->visibleRegion().isEmpty()) inspector_px_ = dock->width();
}

// Arranges the docks as at the first start, whatever view is shown.
void MainWindow::resetLayout() {
  const bool away = docksAway_;
  putDocksAway(false);
  restoreState(firstState_, stateVersion);
  libraryDock_->setVisible(width() >= leastForLibrary_px);
  docksAreNew_ = true;
  sizeDocks();
  const int inspector_px = inspector_px_;  // docks that are laid out later still have their old width
  putDocksAway(away);
  inspector_px_ = inspector_px;
}

void MainWindow::storeWindow() {
  at_.settings.setValue("window/geometry", saveGeometry());
  const bool away = docksAway_;
  putDocksAway(false);
  at_.settings.setValue("window/state", saveState(stateVersion));
  keepInspectorWidth();
  if (inspector_px_ > 0) at_.settings.setValue("window/inspector_px", inspector_px_);
  putDocksAway(away);
  if (feel_) at_.settings.setValue("feel", feel_->saveState());
  storeView(at_.view, at_.settings);
}

// Stored whenever a button is opened, closed or renamed, so that the session survives a power failure.
void MainWindow::storeSession() {
  if (sessionHeld_) return;
  QStringList paths;
  for (DocumentTab* tab : tabs_->all())
    if (!tab->document().path().isEmpty()) paths << tab->document().path();
  at_.settings.setValue("session/files", paths);
  at_.settings.setValue("session/shown", tabs_->current() ? tabs_->current()->document().path() : QString());
}

// Missing files are not reported, because nobody requested them.
void MainWindow::restoreSession() {
  const QString shownPath = at_.settings.value("session/shown").toString();
  for (const QString& path : at_.settings.value("session/files").toStringList())
    if (QFileInfo(path).isFile()) files_->openButton(path);
  if (DocumentTab* shown = tabs_->withPath(shownPath)) tabs_->show(shown->document());
}

// The desktop has changed between light and dark. The desktop's own palette is only visible while ours is not
// set.
void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() != QEvent::ThemeChange) return;
  systemPalette_ = at_.desktopPalette();
  applyAppearance();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  storeWindow();
  storeSession();
  sessionHeld_ = true;  // the tabs that are closed now belong to the stored session
  if (!files_->closeAll()) {
    sessionHeld_ = false;
    return event->ignore();
  }
  event->accept();
}

// ---- clipboard, drop, small edits

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (FileController::canTake(*event->mimeData())) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  if (files_->take(*event->mimeData())) event->acceptProposedAction();
}

// Pastes text that Detent has copied: a stretch into the shown graph, a button into a new tab.
bool MainWindow::pasteText(const QString& text) {
  if (const auto stretch = stretchFrom(text); stretch && tabs_->current()) {
    tabs_->current()->workspace().paste(*stretch);
    return true;
  }
  auto document = documentFromText(text);
  if (!document) return false;
  tabs_->add(*std::move(document));
  return true;
}

void MainWindow::paste() {
  const QMimeData& held = *QApplication::clipboard()->mimeData();
  if (held.hasText() && pasteText(held.text())) return;
  if (!files_->take(held))
    statusBar()->showMessage(tr("The clipboard holds no picture, no file and nothing copied from a "
                                "button. Copy "
                                "a picture of a graph, or points of a curve, first."),
                             messageTime_ms);
}

void MainWindow::copyButton(DocumentTab& tab) {
  QApplication::clipboard()->setText(buttonText(tab.document().button()));
  statusBar()->showMessage(tr("Copied the whole button as text."), messageTime_ms);
}

void MainWindow::duplicateButton(DocumentTab& tab) {
  auto copy = std::make_unique<ButtonDocument>(tab.document().history().committed());
  copy->setOrigin(tab.document().origin());
  copy->setSheet(tab.document().sheet());
  copy->setCutout(tab.document().cutout());
  copy->setAnnotations(tab.document().annotations());
  copy->history().stack().resetClean();
  tabs_->add(std::move(copy));
}

void MainWindow::copyPicture(DocumentTab& tab) {
  QApplication::clipboard()->setImage(tab.workspace().renderImage(copiedPicture_px, 2));
  statusBar()->showMessage(tr("Copied a picture of the graph."), messageTime_ms);
}

void MainWindow::copyCsv(DocumentTab& tab) {
  QApplication::clipboard()->setText(csvText(tab.document().button(), tab.document().activeState()));
  statusBar()->showMessage(tr("Copied the samples as CSV, in mm and N."), messageTime_ms);
}

void MainWindow::copyFigures(DocumentTab& tab) {
  const ButtonDocument& document = tab.document();
  QApplication::clipboard()->setText(
      figuresText(document.button().states()[document.activeState()], at_.view.units()));
  statusBar()->showMessage(tr("Copied the key figures as a table."), messageTime_ms);
}

void MainWindow::print(DocumentTab& tab) {
  QPrinter printer(QPrinter::HighResolution);
  printer.setDocName(tab.document().title());
  if (!at_.prompts.printer(this, printer)) return;
  const bool printed = printGraph(printer, tab.document(), at_.view);
  statusBar()->showMessage(
      printed ? tr("Printed %1.").arg(tab.document().title())
              : tr("The printer did not accept the print job. Choose another printer, or print to a file."),
      messageTime_ms);
}

// Moves the keyboard focus to the next or previous panel, also out of tables and lists: graph, inspector,
// feel, library.
void MainWindow::focusNextPanel(int by) {
  QList<QWidget*> panels;
  if (DocumentTab* tab = tabs_->current(); tab && view_ != CentreView::compare)
    panels << &tab->workspace().canvas();
  for (QScrollArea* area : {feelArea_, compareArea_})
    if (area->isVisible() && area->widget()) panels << area->widget();
  for (QDockWidget* dock : inspectorDocks() + QList<QDockWidget*>{libraryDock_})
    if (dock->isVisible() && !dock->visibleRegion().isEmpty() && dock->widget()) panels << dock->widget();
  if (panels.isEmpty()) return;
  const QWidget* focus = QApplication::focusWidget();
  int now = -1;
  for (int i = 0; i < panels.size(); ++i)
    if (focus && (panels[i] == focus || panels[i]->isAncestorOf(focus))) now = i;
  const auto count = static_cast<int>(panels.size());
  QWidget* next = panels[now < 0 ? 0 : (now + by + count) % count];
  if (auto* stack = qobject_cast<QStackedWidget*>(next); stack && stack->currentWidget())
    next = stack->currentWidget();
  if (next->focusPolicy() == Qt::NoFocus && !next->focusProxy())
    for (QWidget* inside : next->findChildren<QWidget*>())
      if (inside->isVisible() && inside->focusPolicy() & Qt::TabFocus) {
        next = inside;
        break;
      }
  next->setFocus(Qt::TabFocusReason);
}

void MainWindow::renameButton(DocumentTab& tab) {
  const QString now = QString::fromStdString(tab.document().button().name());
  const auto name = at_.prompts.text(this, tr("Rename the button"), tr("Name:"), now);
  if (!name || *name == now || tab.document().history().dragging()) return;
  if (const auto renamed = rename(tab.document().button(), name->toStdString()))
    tab.document().history().apply(*renamed, tr("Rename"));
}

}  // namespace detent::editor
