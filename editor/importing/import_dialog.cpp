// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/import_dialog.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QLabel>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QSplitter>
#include <QStackedWidget>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>
#include <utility>
#include <vector>

#include "editor/document/described.h"
#include "editor/document/elided_label.h"
#include "editor/document/line_icon.h"
#include "editor/files/input_kind.h"
#include "editor/importing/advice_bar.h"
#include "editor/importing/findings_panel.h"
#include "editor/importing/import_state.h"
#include "editor/importing/log_plot.h"
#include "editor/importing/page_list.h"
#include "editor/importing/page_view.h"
#include "editor/importing/quality_figures.h"

namespace detent::editor {
namespace {

constexpr std::array qualities{importer::Quality::draft, importer::Quality::standard,
                               importer::Quality::precise};

constexpr QSize firstSize_px{1280, 820};

QString keyOf(const QAction& action) { return action.shortcut().toString(QKeySequence::NativeText); }

bool isGiven(RemedyKind correction, const Corrections& given) {
  switch (correction) {
    case RemedyKind::giveFrame:
      return given.frame.has_value();
    case RemedyKind::giveXAxis:
      return !given.x.empty();
    case RemedyKind::giveYAxis:
      return !given.y.empty();
    case RemedyKind::giveXUnit:
      return given.xUnit.has_value();
    case RemedyKind::giveYUnit:
      return given.yUnit.has_value();
    case RemedyKind::pickPress:
      return given.pressColor || !given.drawn.press.empty();
    case RemedyKind::pickRelease:
    case RemedyKind::noRelease:
      return given.releaseColor || !given.drawn.release.empty() || given.noRelease;
    case RemedyKind::drawPress:
      return !given.drawn.press.empty();
    case RemedyKind::drawRelease:
      return !given.drawn.release.empty();
    case RemedyKind::chooseSwitch:
      return !given.curve.empty();
    default:  // all other corrections can be given more than once
      return false;
  }
}

/// Remedies for a doubt: those that the importer names, without the given ones; units if the axes are in
/// doubt and none was printed.
Advice adviceForDoubt(const ImportGraph& graph, const DisplayUnits& units) {
  const importer::ImportReport& report = *graph.last->report;
  const Corrections& given = graph.history.now();
  std::vector<RemedyKind> corrections;
  const auto named = correctionsAmong(report.doubt->remedies);
  const bool axes = std::find(named.begin(), named.end(), RemedyKind::giveXAxis) != named.end();
  if (axes && report.x && !report.x->unitFound) corrections.push_back(RemedyKind::giveXUnit);
  if (axes && report.y && !report.y->unitFound) corrections.push_back(RemedyKind::giveYUnit);
  for (const RemedyKind each : named) {
    if (!isGiven(each, given)) corrections.push_back(each);
  }
  Advice advice = adviceFor(*report.doubt, corrections, units);
  if (axes && report.x && report.y && !report.x->unitFound && !report.y->unitFound)
    advice.problem = QObject::tr("The page names no units: %1 and %2 are a guess.")
                         .arg(QString::fromStdString(report.x->unit), QString::fromStdString(report.y->unit));
  const QString check =
      QObject::tr("If everything matches the page, tick “I have checked it against the page”.");
  advice.remedy = advice.remedy.isEmpty() ? check : advice.remedy + ' ' + check;
  return advice;
}

/// Advice on a plot with several switches. It stays after one was chosen: others may be wanted too, and the
/// list must not move under the pointer.
Advice adviceOnSwitches(const ImportGraph& graph) {
  return {QObject::tr("This plot shows %1 switches.").arg(graph.switches().size()),
          QObject::tr(
              "Choose one in the list of switches, or tick several there: each becomes a button of its own."),
          {}};
}

/// The reason why a plot on the page is no force graph, if its axes show that; null otherwise.
const Failure* otherPlotOn(const ImportPage& page) {
  for (const importer::RejectedFrame& rejected : page.rejected)
    if (rejected.why.reason == importer::nameOf(importer::DoubtCode::axesExchanged) ||
        rejected.why.reason == importer::nameOf(importer::DoubtCode::otherQuantity))
      return &rejected.why;
  return nullptr;
}

bool isAboutSwitches(const Failure& failure) {
  return failure.reason == importer::nameOf(importer::DoubtCode::severalSwitches);
}

}  // namespace

struct ImportDialog::Impl {
  Impl(ImportDialog& itsDialog, ViewSettings& itsSettings)
      : dialog(itsDialog),
        settings(itsSettings),
        pages(new PageList(state)),
        view(new PageView(state, settings)),
        log(new LogPlot(state, settings)),
        findings(new FindingsPanel(state, settings)),
        advice(new AdviceBar) {}

  void build();
  void buildTools(QToolBar& bar);
  void fitTools();
  QAction* addTool(QToolBar& bar, PageToolKind kind, const char* name, const QString& text,
                   const QString& tip, const QKeySequence& key);
  QAction* addAction(QToolBar& bar, const char* name, const QString& text, const QString& tip,
                     const QKeySequence& key, const std::function<void()>& run);
  void connectState();

  void showDocument();
  void showCorrections();
  void showWork();
  void showAdvice();
  void say(AdviceBar::Tone tone, const Advice& what);
  void clearAdvice();
  void showAccept();
  void follow(RemedyKind correction);
  void chooseFile();
  void paste();

  ImportDialog& dialog;
  ViewSettings& settings;
  ImportState state;  // before the widgets that listen to it
  PageList* pages;
  PageView* view;
  LogPlot* log;
  FindingsPanel* findings;
  AdviceBar* advice;

  QWidget* side = nullptr;  // contains the list of pages
  QCheckBox* graphsOnly = nullptr;
  QStackedWidget* middle = nullptr;
  ElidedLabel *document = nullptr, *hint = nullptr;
  QLabel* work = nullptr;
  QComboBox* quality = nullptr;
  QProgressBar* progress = nullptr;
  QPushButton *stop = nullptr, *accept = nullptr;
  QAction *undo = nullptr, *redo = nullptr;
  QActionGroup* tools = nullptr;
  QToolBar* toolBar = nullptr;
  std::vector<QAction*> viewActions;
  QTimer* workSoon = nullptr;
};

QAction* ImportDialog::Impl::addTool(QToolBar& bar, PageToolKind kind, const char* name, const QString& text,
                                     const QString& tip, const QKeySequence& key) {
  auto* action = new QAction(lineIcon(name), text, &dialog);
  action->setCheckable(true);
  action->setData(static_cast<int>(kind));
  action->setShortcut(key);
  action->setToolTip(tr("%1 (%2)").arg(tip, key.toString(QKeySequence::NativeText)));
  tools->addAction(action);
  bar.addAction(action);
  QObject::connect(action, &QAction::triggered, view, [this, kind] { view->setTool(kind); });
  return action;
}

QAction* ImportDialog::Impl::addAction(QToolBar& bar, const char* name, const QString& text,
                                       const QString& tip, const QKeySequence& key,
                                       const std::function<void()>& run) {
  auto* action = new QAction(lineIcon(name), text, &dialog);
  action->setObjectName(QString::fromLatin1(name));
  viewActions.push_back(action);
  action->setShortcut(key);
  action->setToolTip(key.isEmpty() ? tip : tr("%1 (%2)").arg(tip, key.toString(QKeySequence::NativeText)));
  bar.addAction(action);
  QObject::connect(action, &QAction::triggered, &dialog, run);
  return action;
}

void ImportDialog::Impl::buildTools(QToolBar& bar) {
  tools = new QActionGroup(&dialog);
  addTool(bar, PageToolKind::adjust, "adjust", tr("Adjust"), tr("Drag corners, edges and ticks"),
          Qt::ALT | Qt::Key_1)
      ->setChecked(true);
  addTool(bar, PageToolKind::scale, "scale", tr("Axis values"), tr("Click ticks and type their values"),
          Qt::ALT | Qt::Key_2);
  addTool(bar, PageToolKind::drawFrame, "drawFrame", tr("Plot frame"), tr("Draw a plot frame"),
          Qt::ALT | Qt::Key_3);
  addTool(bar, PageToolKind::pressColor, "pressColor", tr("Press curve"), tr("Click the press curve"),
          Qt::ALT | Qt::Key_4);
  addTool(bar, PageToolKind::releaseColor, "releaseColor", tr("Release curve"), tr("Click the release curve"),
          Qt::ALT | Qt::Key_5);
  addTool(bar, PageToolKind::drawPress, "drawPress", tr("Draw press"),
          tr("Click points along the press curve, or draw along it"), Qt::ALT | Qt::Key_9);
  addTool(bar, PageToolKind::drawRelease, "drawRelease", tr("Draw release"),
          tr("Click points along the release curve, or draw along it"), Qt::ALT | Qt::Key_0);
  addTool(bar, PageToolKind::maskBox, "maskBox", tr("Mask"), tr("Mask a rectangle"), Qt::ALT | Qt::Key_6);
  addTool(bar, PageToolKind::maskBrush, "maskBrush", tr("Brush"), tr("Paint a mask"), Qt::ALT | Qt::Key_7);
  addTool(bar, PageToolKind::pan, "pan", tr("Pan"), tr("Drag the page"), Qt::ALT | Qt::Key_8);
  bar.addSeparator();
  const auto addKey = [this](const char* name, const QString& text, const QKeySequence& keys, auto run) {
    auto* action = new QAction(text, &dialog);
    action->setObjectName(QString::fromLatin1(name));
    action->setShortcut(keys);
    dialog.addAction(action);
    QObject::connect(action, &QAction::triggered, &dialog, run);
  };
  addKey("nextGraph", tr("Next graph"), QKeySequence("Ctrl+PgDown"), [this] { state.selectNext(1); });
  addKey("previousGraph", tr("Previous graph"), QKeySequence("Ctrl+PgUp"), [this] { state.selectNext(-1); });
  addKey("allGraphs", tr("Tick all graphs"), QKeySequence("Ctrl+Shift+A"), [this] { state.tickAll(); });
  undo = addAction(bar, "undo", tr("Undo"), tr("Undo the last correction"), QKeySequence::Undo,
                   [this] { state.undo(); });
  redo = addAction(bar, "redo", tr("Redo"), tr("Redo the correction"), QKeySequence::Redo,
                   [this] { state.redo(); });
  bar.addSeparator();
  addAction(bar, "fitGraph", tr("Graph"), tr("Show the graph"), Qt::CTRL | Qt::Key_0,
            [this] { view->fitGraph(); });
  addAction(bar, "fitPage", tr("Page"), tr("Show the whole page"), Qt::CTRL | Qt::Key_9,
            [this] { view->fitPage(); });
  addAction(bar, "zoomIn", tr("In"), tr("Zoom in"), QKeySequence::ZoomIn, [this] { view->zoomBy(1.25); });
  addAction(bar, "zoomOut", tr("Out"), tr("Zoom out"), QKeySequence::ZoomOut, [this] { view->zoomBy(0.8); });
  QObject::connect(view, &PageView::toolChanged, &dialog, [this](PageToolKind kind) {
    for (QAction* action : tools->actions())
      action->setChecked(action->data().toInt() == static_cast<int>(kind));
  });
}

void ImportDialog::Impl::build() {
  auto* column = new QVBoxLayout(&dialog);
  column->setContentsMargins(8, 8, 8, 8);
  auto* top = new QHBoxLayout;
  auto* open = new QPushButton(tr("&Open…"));
  open->setShortcut(QKeySequence::Open);
  open->setToolTip(tr("Open a picture, PDF, SVG or a force meter's CSV (%1)")
                       .arg(QKeySequence(QKeySequence::Open).toString(QKeySequence::NativeText)));
  auto* pasteButton =
      described(new QPushButton(tr("&Paste picture")), "paste",
                tr("Import the picture on the clipboard (%1)")
                    .arg(QKeySequence(QKeySequence::Paste).toString(QKeySequence::NativeText)));
  document = described(new ElidedLabel(Qt::ElideMiddle), "documentName");
  // characters of the name that stay visible beside the words of the quality
  constexpr int leastOfName = 14;
  document->setMinimumWidth(leastOfName * document->fontMetrics().averageCharWidth());
  auto* qualityLabel = new QLabel(tr("&Quality"));
  quality = described(new QComboBox, "quality");
  qualityLabel->setBuddy(quality);
  for (const importer::Quality each : qualities) quality->addItem(describedQuality(each));
  quality->setCurrentIndex(1);
  quality->setMinimumContentsLength(12);  // on a narrow screen its words are cut before the dialogue is
  quality->setAccessibleName(tr("Quality of the import"));
  quality->setToolTip(
      tr("How carefully Detent reads the graph. Times and errors were measured on drawn graphs "
         "(docs/measurements/trade.md). Your corrections are kept when you change the quality."));
  top->addWidget(open);
  top->addWidget(pasteButton);
  top->addWidget(document, 1);
  top->addWidget(qualityLabel);
  top->addWidget(quality);
  column->addLayout(top);

  toolBar = new QToolBar;
  toolBar->setIconSize({20, 20});
  buildTools(*toolBar);
  column->addWidget(toolBar);

  middle = new QStackedWidget;
  middle->addWidget(view);
  middle->addWidget(log);
  auto* splitter = new QSplitter;
  side = new QWidget;
  auto* list = new QVBoxLayout(side);
  list->setContentsMargins(0, 0, 0, 0);
  list->addWidget(graphsOnly = new QCheckBox(tr("Graphs onl&y")));
  list->addWidget(pages);
  graphsOnly->setObjectName(QStringLiteral("graphsOnly"));
  graphsOnly->setToolTip(tr("List only the graphs, without the pages between them"));
  QObject::connect(graphsOnly, &QCheckBox::toggled, pages, &PageList::setGraphsOnly);
  splitter->addWidget(side);
  // The advice is placed beside the lists, so that they do not move when a question appears or disappears.
  auto* centre = new QWidget;
  auto* centreColumn = new QVBoxLayout(centre);
  centreColumn->setContentsMargins(0, 0, 0, 0);
  centreColumn->addWidget(advice);
  centreColumn->addWidget(middle, 1);
  splitter->addWidget(centre);
  splitter->addWidget(findings);
  splitter->setStretchFactor(1, 1);
  splitter->setCollapsible(1, false);  // on a small screen the lists at the sides can be put away
  constexpr int firstSide_px = 220;
  splitter->setSizes({firstSide_px, 720, 330});
  QObject::connect(findings, &FindingsPanel::widthWanted, splitter, [this, splitter](int width_px) {
    constexpr double leastForPage = 0.4;  // share of the dialogue's width
    QList<int> sizes = splitter->sizes();
    // a hidden list is reported with size 0 and would stay collapsed
    if (!side->isVisible()) sizes[0] = firstSide_px;
    const int all = std::accumulate(sizes.begin(), sizes.end(), 0);
    const int least_px[] = {pages->minimumWidth(), static_cast<int>(leastForPage * all)};
    for (const int giver : {1, 0}) {
      const int taken = std::max(0, std::min(width_px - sizes[2], sizes[giver] - least_px[giver]));
      sizes[giver] -= taken, sizes[2] += taken;
    }
    splitter->setSizes(sizes);
  });
  column->addWidget(splitter, 1);

  hint = new ElidedLabel(Qt::ElideRight);
  hint->setForegroundRole(QPalette::PlaceholderText);
  column->addWidget(hint);
  auto* bottom = new QHBoxLayout;
  progress = new QProgressBar;
  progress->setRange(0, 1000);
  progress->setTextVisible(false);
  progress->setFixedWidth(180);
  progress->setAccessibleName(tr("Progress of the import"));
  work = new QLabel;
  work->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  stop = described(new QPushButton(tr("&Stop")), "stop", tr("Stop reading and keep the last result"));
  accept = described(new QPushButton(tr("&Import")), "import");
  accept->setDefault(true);
  auto* close = described(new QPushButton(tr("Close")), "close");
  close->setAutoDefault(false);
  for (QPushButton* button : {open, pasteButton, stop}) button->setAutoDefault(false);
  bottom->addWidget(progress);
  bottom->addWidget(stop);
  bottom->addWidget(work, 1);
  bottom->addWidget(accept);
  bottom->addWidget(close);
  column->addLayout(bottom);

  workSoon = new QTimer(&dialog);
  workSoon->setSingleShot(true);
  workSoon->setInterval(150);  // shorter work shows no bar, so that nothing flickers
  QObject::connect(open, &QPushButton::clicked, &dialog, [this] { chooseFile(); });
  QObject::connect(pasteButton, &QPushButton::clicked, &dialog, [this] { paste(); });
  QObject::connect(close, &QPushButton::clicked, &dialog, &QDialog::reject);
  QObject::connect(stop, &QPushButton::clicked, &state, &ImportState::cancel);
  // Without this check a refused field would keep its previous value unnoticed.
  QObject::connect(accept, &QPushButton::clicked, &state, [this] {
    if (view->takeEditor() && findings->acceptable()) state.acceptAll();
  });
  QObject::connect(quality, &QComboBox::activated, &state,
                   [this](int index) { state.setQuality(qualities[static_cast<std::size_t>(index)]); });
  QObject::connect(view, &PageView::hint, hint, &ElidedLabel::say);
  QObject::connect(findings, &FindingsPanel::toolRequested, view, [this](PageToolKind kind) {
    view->setTool(kind);
    view->setFocus();
  });
  QObject::connect(advice, &AdviceBar::remedyChosen, &dialog,
                   [this](RemedyKind correction) { follow(correction); });
  QObject::connect(advice, &AdviceBar::lengthUnitChosen, &dialog, [this](LengthUnit unit) {
    state.correct(tr("Displacement unit"), [unit](Corrections& c) { c.xUnit = unit; });
  });
  QObject::connect(advice, &AdviceBar::forceUnitChosen, &dialog, [this](ForceUnit unit) {
    state.correct(tr("Force unit"), [unit](Corrections& c) { c.yUnit = unit; });
  });
  QObject::connect(advice, &AdviceBar::otherQuantityChosen, &dialog, [this](RemedyKind question) {
    state.correct(tr("Another quantity"), [question](Corrections& c) {
      (question == RemedyKind::giveXUnit ? c.xIsOther : c.yIsOther) = true;
    });
  });
  QObject::connect(workSoon, &QTimer::timeout, &dialog, [this] {
    progress->setVisible(true);
    stop->setVisible(true);
  });
}

/// Texts under the icons where the window is wide enough for all of them.
void ImportDialog::Impl::fitTools() {
  toolBar->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  if (toolBar->sizeHint().width() > toolBar->width()) toolBar->setToolButtonStyle(Qt::ToolButtonIconOnly);
}

void ImportDialog::Impl::connectState() {
  QObject::connect(&state, &ImportState::documentChanged, &dialog, [this] { showDocument(); });
  QObject::connect(&state, &ImportState::graphsChanged, &dialog, [this] {
    showAdvice();
    showAccept();
  });
  QObject::connect(&state, &ImportState::pageChanged, &dialog, [this] { showWork(); });
  QObject::connect(&state, &ImportState::currentChanged, &dialog, [this] {
    showAdvice();
    showAccept();
  });
  QObject::connect(&state, &ImportState::correctionsChanged, &dialog, [this] { showCorrections(); });
  QObject::connect(&state, &ImportState::resultChanged, &dialog, [this] {
    showWork();
    showAdvice();
    showAccept();
  });
  QObject::connect(&state, &ImportState::progressed, &dialog,
                   [this](double fraction, importer::ImportStep step) {
                     progress->setValue(static_cast<int>(1000 * fraction));
                     work->setText(inProgress(step));
                   });
  QObject::connect(&state, &ImportState::accepted, &dialog, &ImportDialog::imported);
  QObject::connect(&state, &ImportState::allAccepted, &dialog, &QDialog::accept);
}

void ImportDialog::Impl::showDocument() {
  QString text = state.documentName();
  if (state.pageCount() > 1) text += tr(" – %1 pages").arg(state.pageCount());
  document->say(text);
  dialog.setWindowTitle(text.isEmpty() ? tr("Import a force graph")
                                       : tr("Import – %1").arg(state.documentName()));
  middle->setCurrentWidget(state.isForceLog() ? static_cast<QWidget*>(log) : view);
  side->setVisible(state.isOpen() && !state.isForceLog());
  graphsOnly->setVisible(state.pageCount() > 1);
  findings->setVisible(state.isOpen());
  const bool onPage = state.isOpen() && !state.isForceLog();
  for (QAction* action : tools->actions()) action->setEnabled(onPage);
  for (QAction* action : viewActions)
    if (action != undo && action != redo) action->setEnabled(onPage);
  hint->setVisible(!state.isForceLog());
  showCorrections();
  showWork();
  showAdvice();
  showAccept();
}

void ImportDialog::Impl::showCorrections() {
  const ImportGraph* graph = state.current();
  undo->setEnabled(graph && graph->history.canUndo());
  redo->setEnabled(graph && graph->history.canRedo());
  undo->setToolTip(undo->isEnabled() ? tr("Undo: %1 (%2)").arg(graph->history.undoLabel(), keyOf(*undo))
                                     : tr("Nothing to undo"));
  redo->setToolTip(redo->isEnabled() ? tr("Redo: %1 (%2)").arg(graph->history.redoLabel(), keyOf(*redo))
                                     : tr("Nothing to redo"));
}

void ImportDialog::Impl::showWork() {
  const bool working = state.opening() || state.working();
  if (working) {
    if (!progress->isVisibleTo(&dialog) && !workSoon->isActive()) {
      progress->setValue(0);
      workSoon->start();
    }
    return;
  }
  const bool searching = state.isOpen() && !state.isForceLog() && state.searchedPages() < state.pageCount();
  work->setText(
      !searching ? QString()
      : state.pageCount() > 1
          ? tr("Searching for graphs: page %1 of %2").arg(state.searchedPages() + 1).arg(state.pageCount())
          : tr("Searching the page for graphs …"));
  workSoon->stop();
  progress->setVisible(false);
  stop->setVisible(false);
}

// The axis in question is marked on the page.
void ImportDialog::Impl::say(AdviceBar::Tone tone, const Advice& what) {
  advice->say(tone, what);
  const RemedyKind first = what.remedies.empty() ? RemedyKind::advice : what.remedies.front();
  const bool x = first == RemedyKind::giveXAxis || first == RemedyKind::giveXUnit;
  const bool y = first == RemedyKind::giveYAxis || first == RemedyKind::giveYUnit;
  view->setDoubt(x ? std::optional(GraphAxis::x) : y ? std::optional(GraphAxis::y) : std::nullopt);
}

void ImportDialog::Impl::clearAdvice() {
  advice->clear();
  view->setDoubt({});
}

void ImportDialog::Impl::showAdvice() {
  if (state.openFailure())
    return say(AdviceBar::Tone::fault,
               adviceFor(*state.openFailure(), state.documentName(), settings.units()));
  const ImportGraph* graph = state.current();
  if (!graph) {
    if (!state.isOpen() || state.isForceLog()) return clearAdvice();
    if (const auto& failure = state.page(state.currentPage()).failure)
      return say(AdviceBar::Tone::fault, adviceFor(*failure, state.documentName(), settings.units()));
    const auto& page = state.page(state.currentPage());
    if (page.searched) {
      if (const Failure* why = otherPlotOn(page))
        return say(AdviceBar::Tone::note,
                   {adviceFor(*why, state.documentName(), settings.units()).problem,
                    tr("As it was read, this graph gives no button. If it was misread, click its dashed "
                       "rectangle. If the page shows another graph, draw its plot frame."),
                    {RemedyKind::giveFrame}});
      // No advice on pages that are still being searched.
      const bool pageAlone = !state.graphs().empty() || state.searchedPages() < state.pageCount();
      return say(AdviceBar::Tone::note,
                 {pageAlone ? tr("No force graph was found on this page.") : tr("No force graph was found."),
                  tr("If the page shows a graph, draw its plot frame or click a dashed rectangle."),
                  {RemedyKind::giveFrame}});
    }
    return clearAdvice();
  }
  if (graph->isOther())
    return say(AdviceBar::Tone::fault,
               {graph->history.now().xIsOther ? tr("The horizontal axis measures no displacement.")
                                              : tr("The vertical axis measures no force."),
                tr("No button can be imported from this graph. Use Undo to take your answer back."),
                {}});
  const bool several = !graph->switches().empty();
  const bool failed = graph->last && graph->last->failure && graph->pending == 0;
  if (failed && !(several && isAboutSwitches(*graph->last->failure)))
    return say(AdviceBar::Tone::fault,
               adviceFor(*graph->last->failure, state.documentName(), settings.units()));
  const importer::ImportReport* report = graph->last ? graph->last->report.get() : nullptr;
  if (report && report->doubt) {
    if (graph->confirmed) return clearAdvice();
    return say(AdviceBar::Tone::doubt, adviceForDoubt(*graph, settings.units()));
  }
  if (several) return say(AdviceBar::Tone::note, adviceOnSwitches(*graph));
  // While a graph is read again, the advice of its previous result stays; the first reading of a graph
  // clears the advice of another one.
  if (graph->pending == 0 || !graph->last) clearAdvice();
}

void ImportDialog::Impl::showAccept() {
  const int ticked = state.tickedCount();
  const ImportGraph* graph = state.current();
  const bool usable =
      graph && graph->good && !(graph->last && graph->last->failure) && graph->isAcceptable(*graph->good);
  accept->setText(ticked > 1 ? tr("&Import %1 buttons").arg(ticked) : tr("&Import"));
  accept->setEnabled(ticked > 0 || usable);
  accept->setToolTip(ticked > 0 ? tr("Import the ticked graphs, each as a button of its own")
                                : tr("Import this graph as a button (Ctrl+Enter)"));
}

void ImportDialog::Impl::follow(RemedyKind correction) {
  switch (correction) {
    case RemedyKind::giveFrame:
      return view->setTool(PageToolKind::drawFrame);
    case RemedyKind::giveXAxis:
      return findings->focusField(GraphAxis::x);
    case RemedyKind::giveYAxis:
      return findings->focusField(GraphAxis::y);
    case RemedyKind::giveXUnit:
      return findings->focusUnit(GraphAxis::x);
    case RemedyKind::giveYUnit:
      return findings->focusUnit(GraphAxis::y);
    case RemedyKind::pickPress:
      return view->setTool(PageToolKind::pressColor);
    case RemedyKind::pickRelease:
      return view->setTool(PageToolKind::releaseColor);
    case RemedyKind::addMask:
      return view->setTool(PageToolKind::maskBrush);
    case RemedyKind::setResolution:
      return findings->focusDpi();
    case RemedyKind::drawPress:
      return view->setTool(PageToolKind::drawPress);
    case RemedyKind::drawRelease:
      return view->setTool(PageToolKind::drawRelease);
    case RemedyKind::chooseSwitch:
      return findings->focusSwitches();
    case RemedyKind::noRelease:
      return state.correct(tr("No release curve"), [](Corrections& c) { c.noRelease = true; });
    case RemedyKind::swapStrokes:
      return state.correct(tr("Swap press and release"),
                           [](Corrections& c) { c.swapStrokes = !c.swapStrokes; });
    default:
      return;  // the bar shows only corrections
  }
}

void ImportDialog::Impl::chooseFile() {
  auto* chooser = new QFileDialog(&dialog, tr("Open a datasheet or a force meter's log"));
  chooser->setAttribute(Qt::WA_DeleteOnClose);
  chooser->setFileMode(QFileDialog::ExistingFile);
  chooser->setNameFilters(importFilters());
  QObject::connect(chooser, &QFileDialog::fileSelected, &dialog, &ImportDialog::openFile);
  chooser->open();
}

void ImportDialog::Impl::paste() {
  const QMimeData* mime = QApplication::clipboard()->mimeData();
  if (mime && mime->hasUrls() && !mime->urls().isEmpty() && mime->urls().front().isLocalFile()) {
    dialog.openFile(mime->urls().front().toLocalFile());
  } else if (mime && mime->hasImage()) {
    dialog.openPicture(qvariant_cast<QImage>(mime->imageData()));
  } else {
    hint->say(
        tr("There is no picture on the clipboard. Copy one, for instance with the snipping tool of your "
           "system."));
  }
}

ImportDialog::ImportDialog(ViewSettings& settings, QWidget* parent)
    : QDialog(parent), impl_(std::make_unique<Impl>(*this, settings)) {
  setObjectName(QStringLiteral("importDialog"));
  setWindowFlag(Qt::WindowMaximizeButtonHint);
  setAcceptDrops(true);
  impl_->build();
  resize(firstSize_px);
  impl_->connectState();
  connect(&impl_->state, &ImportState::correctionsChanged, this, &ImportDialog::draftChanged);
  connect(&impl_->state, &ImportState::documentChanged, this, [this] {
    const QString path = draft().path;
    if (path.isEmpty()) return;
    if (impl_->state.isOpen()) emit opened(path);
    if (impl_->state.openFailure()) emit unreadable(path);
  });
  impl_->showDocument();
  impl_->view->setTool(PageToolKind::adjust);
}

/// Widgets are deleted before the state they refer to.
ImportDialog::~ImportDialog() { qDeleteAll(findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)); }

void ImportDialog::openFile(const QString& path) {
  if (mayGiveUp()) impl_->state.openFile(path);
}

void ImportDialog::openPicture(const QImage& picture) {
  if (mayGiveUp()) impl_->state.openPicture(picture);
}

void ImportDialog::continueDraft(const ImportDraft& draft) {
  if (mayGiveUp()) impl_->state.continueDraft(draft);
}

ImportDraft ImportDialog::draft() const { return impl_->state.draft(); }
const QImage& ImportDialog::pastedPicture() const { return impl_->state.pastedPicture(); }

// Corrections are work, so neither Escape nor another sheet discards them without a question.
bool ImportDialog::mayGiveUp() const { return !mayLeave_ || draft().empty() || mayLeave_(); }

void ImportDialog::reject() {
  if (mayGiveUp()) QDialog::reject();
}

void ImportDialog::resizeEvent(QResizeEvent* event) {
  QDialog::resizeEvent(event);
  layout()->activate();
  impl_->fitTools();
}

void ImportDialog::done(int result) {
  impl_->state.stopAll();
  QDialog::done(result);
}

// Only now do the widgets have their final style and size.
void ImportDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  impl_->fitTools();
}

void ImportDialog::dragEnterEvent(QDragEnterEvent* event) {
  const QMimeData* mime = event->mimeData();
  const bool file = mime->hasUrls() && !mime->urls().isEmpty() && mime->urls().front().isLocalFile();
  if (file || mime->hasImage()) event->acceptProposedAction();
}

void ImportDialog::dropEvent(QDropEvent* event) {
  const QMimeData* mime = event->mimeData();
  if (mime->hasUrls() && !mime->urls().isEmpty() && mime->urls().front().isLocalFile()) {
    openFile(mime->urls().front().toLocalFile());
  } else if (mime->hasImage()) {
    openPicture(qvariant_cast<QImage>(mime->imageData()));
  }
}

void ImportDialog::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Paste)) return impl_->paste();
  // Enter in a field only ends the typing of a value; on a button it presses the button. With Ctrl it
  // imports.
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enter && event->modifiers() & Qt::ControlModifier) return impl_->accept->click();
  if (enter && !qobject_cast<QPushButton*>(focusWidget())) return;
  QDialog::keyPressEvent(event);
}

}  // namespace detent::editor
